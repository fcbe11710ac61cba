// A small scene for each effect of light or of fragments, in which nothing but the effect is worth looking at. Their
// shapes are those of the room and the knot.
#pragma once

#include <span>

#include "zstrip_scenes/knot.hpp"
#include "zstrip_scenes/room.hpp"

namespace zstrip::scenes {

/// A box of half sides (across, up, deep) around (x, y, z).
consteval Instance block(std::uint16_t material, double across, double up, double deep, double x, double y, double z) {
  return {.mesh = 1,
          .material = material,
          .transform = {{{fixed(across), 0, 0, fixed(x)}, {0, fixed(up), 0, fixed(y)}, {0, 0, fixed(deep), fixed(z)}}}};
}

inline constexpr Instance kFogInstances[] = {
    block(1, 1.6, 0.1, 4.0, 0, -1.0, -2.6), block(2, 0.3, 0.6, 0.3, -0.8, -0.3, 0.6),
    block(3, 0.3, 0.6, 0.3, 0.8, -0.3, -1.8), block(2, 0.3, 0.6, 0.3, -0.8, -0.3, -4.2)};
inline constexpr Fog kFog{.colour = {150, 165, 180, 255}, .mode = FogMode::exponential_squared, .density = fixed(0.16)};
inline constexpr Scene kFogScene{.meshes = kRoomMeshes,
                                 .materials = kRoomMaterials,
                                 .textures = kRoomTextures,
                                 .instances = kFogInstances,
                                 .lights = kRoomLights,
                                 .ambient = {70, 70, 70, 255},
                                 .background = {150, 165, 180, 255},
                                 .fog = &kFog};
inline constexpr BuiltIn fog{.name = "fog",
                             .description = "boxes on a floor that fade with their distance",
                             .scene = kFogScene,
                             .counts = count(kFogScene),
                             .camera = turntable_camera(3.2, 10, 1.7),
                             .focal_across = fixed(1.7)};

/// All of this page, in its order.
std::span<const BuiltIn> effect_scenes();

}  // namespace zstrip::scenes
