// The room of room.hpp at rest, and a teapot that flies in a circle around its boxes: two scenes with one camera, which
// can be drawn as a static layer with a moving object over it, or as one scene.
#pragma once

#include <array>
#include <cstdint>

#include "zstrip_scenes/room.hpp"
#include "zstrip_scenes/teapot_meshlets.hpp"

namespace zstrip::scenes {

/// The depth range is the same in every frame, because layers are compared by depth.
inline constexpr Camera kShowroomCamera = [] {
  Camera camera = turntable_camera(1.7, 15, 1.2);
  camera.near_plane = fixed(0.2);
  camera.far_plane = fixed(5.0);
  camera.fixed_depth_range = true;
  return camera;
}();

inline constexpr Scene kShowroomBackground = kRoomScene;

/// The background's meshes and materials, followed by the teapot's.
inline constexpr Mesh kShowroomMeshes[] = {kRoomMeshes[0], kRoomMeshes[1], kTeapotMeshletsMesh[0]};
inline constexpr Material kShowroomMaterials[] = {kRoomMaterials[0], kRoomMaterials[1], kRoomMaterials[2],
                                                  kRoomMaterials[3], kTeapotMaterial[0]};
inline constexpr std::uint16_t kShowroomTeapotMesh = 2, kShowroomTeapotMaterial = 4;

/// Returns the teapot at frame `frame` of a flight around the boxes in `frames` frames; any number.
Instance showroom_teapot(std::uint32_t frame, std::uint32_t frames);

/// Returns a scene of these instances: the moving one, or all. `instances` must stay alive.
constexpr Scene showroom_scene(std::span<const Instance> instances) {
  return {.meshes = kShowroomMeshes,
          .materials = kShowroomMaterials,
          .textures = kRoomTextures,
          .instances = instances,
          .lights = kRoomLights,
          .ambient = kRoomScene.ambient};
}

inline constexpr SceneCounts kShowroomTeapotCounts = teapot_meshlets.counts;

}  // namespace zstrip::scenes
