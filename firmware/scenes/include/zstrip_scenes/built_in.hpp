// A scene that compiles into flash, with its camera and its counts.
#pragma once

#include <cstdint>

#include "zstrip/camera.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/status.hpp"

namespace zstrip::scenes {

/// The largest number of instances of a built-in scene: the capacity of Staged.
inline constexpr std::uint32_t kMaxInstances = 4;

/// The part that rotates on the turntable.
enum class Turns : std::uint8_t {
  model,   ///< the instances rotate about the world's y axis; camera and lights stand still
  camera,  ///< the camera moves around the world's y axis: for scenes that are seen from inside
};

/// A scene in flash. All of it is constant-initialised and lives as long as the program.
struct BuiltIn {
  const char* name;         ///< on the command line: lower case letters, digits and underscores
  const char* description;  ///< one phrase, without a full stop
  /// The scene at rest, as at frame 0 of the turntable. constexpr, so that effects_of(scene, camera) is a constant.
  Scene scene;
  /// The input of the planner. Equals count(scene), but is constexpr even if meshlet tables are not visible.
  SceneCounts counts;
  /// The turntable's camera, with a focal length for the height of the picture.
  Camera camera;
  /// 16.16, 0 < focal_across < 8. The focal length at which the model just fits a square picture from side to side.
  Fixed focal_across;
  Turns turns = Turns::model;
  /// 16.16. The workload's camera stands at (0, 0, workload_distance).
  Fixed workload_distance = 3 * kFixedOne;
  /// Writes the scene's data in RAM for this frame, which is part of drawing it; null: all data is in flash. The
  /// workload then shows this motion through `camera`. Before the first call the scene is at rest.
  Status (*pose)(std::uint32_t frame) = nullptr;
  std::uint32_t pose_bytes = 0;  ///< bytes of that RAM
};

/// Returns the counts of a scene with one instance of `mesh` with `material`. If the mesh has meshlets, also pass the
/// largest numbers of vertices and triangles of a meshlet.
constexpr SceneCounts counts_of_one(const Mesh& mesh, const Material& material, std::uint32_t largest_meshlet = 0,
                                    std::uint32_t longest_meshlet = 0) {
  const auto vertices = static_cast<std::uint32_t>(mesh.positions.size());
  const auto triangles = static_cast<std::uint32_t>(mesh.triangles.size());
  const bool whole = mesh.meshlets.empty();
  const Scene scene{.meshes = {&mesh, 1}, .materials = {&material, 1}, .textures = {}, .instances = {}, .lights = {}};
  return {.instances = 1,
          .triangles = triangles,
          .vertices = vertices,
          .largest_meshlet = whole ? vertices : largest_meshlet,
          .meshlets = whole ? 1 : static_cast<std::uint32_t>(mesh.meshlets.size()),
          .longest_meshlet = whole ? triangles : longest_meshlet,
          .colours_in_place = !detail::makes_colours(scene, {})};
}

}  // namespace zstrip::scenes
