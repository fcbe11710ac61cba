// Which effects a scene calls for. The set is a template argument of the renderer: what is not in it costs nothing.
#pragma once

#include <cstdint>

#include "zstrip/scene/camera.hpp"
#include "zstrip/scene/scene.hpp"

namespace zstrip {

/// A set of effects; a structural type, so that it can be a template argument.
struct Effects {
  std::uint32_t bits = 0;
  constexpr bool has(Effects other) const { return (bits & other.bits) == other.bits; }
  constexpr bool any(Effects other) const { return (bits & other.bits) != 0; }
  friend constexpr Effects operator|(Effects a, Effects b) { return {a.bits | b.bits}; }
  friend constexpr Effects operator&(Effects a, Effects b) { return {a.bits & b.bits}; }
  friend constexpr Effects without(Effects a, Effects b) { return {a.bits & ~b.bits}; }
  friend constexpr bool operator==(const Effects&, const Effects&) = default;
};

namespace effect {
inline constexpr Effects lighting{1U << 0};        ///< some material is lit and there is a light or normals
inline constexpr Effects gouraud{1U << 1};         ///< colour varies over a triangle
inline constexpr Effects vertex_colours{1U << 2};  ///< some mesh has colours
inline constexpr Effects textures{1U << 3};        ///< some material has a texture
inline constexpr Effects orthographic{
    1U << 4};  ///< the camera's projection; a renderer with it takes no perspective camera
inline constexpr Effects statistics{1U << 5};  ///< counts triangles and fragments; never called for by a scene
inline constexpr Effects bins{1U << 6};        ///< can carry out plans of Mode::binned; never called for by a scene
inline constexpr Effects all{(1U << 7) - 1};
}  // namespace effect

/// Exactly what drawing this scene with this camera needs. constexpr for baked scenes.
constexpr Effects effects_of(const Scene& scene, const Camera& camera) {
  Effects found{};
  for (const Instance& instance : scene.instances) {
    if (instance.material >= scene.materials.size() || instance.mesh >= scene.meshes.size()) continue;
    const Material& material = scene.materials[instance.material];
    const Mesh& mesh = scene.meshes[instance.mesh];
    const bool lit = material.lit && !mesh.normals.empty();
    const bool textured = material.texture != kNoTexture && !mesh.texcoords.empty();
    const bool coloured = !mesh.colours.empty() && !(textured && !material.lit);
    if (lit) found = found | effect::lighting;
    if (coloured) found = found | effect::vertex_colours;
    if (textured) found = found | effect::textures;
    if (material.smooth && (lit || coloured)) found = found | effect::gouraud;
  }
  if (camera.projection == Projection::orthographic) found = found | effect::orthographic;
  return found;
}

}  // namespace zstrip
