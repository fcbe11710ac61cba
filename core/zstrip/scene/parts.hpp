// The only list of a scene's parts. Baked headers, flash and fingerprints walk it; the sections of blobs are compared
// with it. Only the checks of validate.hpp have an order of their own: some indices are valid only after other checks.
#pragma once

#include <cstddef>
#include <span>

#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// Calls visit(name, part) for each member of a scene, const or not, in the order of their declaration. A part is a
/// span of records, a pointer to one record or null, or a colour.
template <class AnyScene, class Visit>
constexpr void for_each_part(AnyScene& scene, const Visit& visit) {
  visit("meshes", scene.meshes);
  visit("materials", scene.materials);
  visit("textures", scene.textures);
  visit("instances", scene.instances);
  visit("lights", scene.lights);
  visit("ambient", scene.ambient);
  visit("background", scene.background);
  visit("fog", scene.fog);
  visit("finishes", scene.finishes);
  visit("punctual_lights", scene.punctual_lights);
  visit("quadrics", scene.quadrics);
  visit("lines", scene.lines);
  visit("outlines", scene.outlines);
  visit("shadow", scene.shadow);
  visit("csg", scene.csg);
  visit("edges", scene.edges);
  visit("overlay", scene.overlay);
}

constexpr std::size_t bytes_of_parts() {
  const Scene scene;
  std::size_t bytes = 0;
  for_each_part(scene, [&bytes](const char*, const auto& part) { bytes += sizeof part; });
  return bytes;
}
static_assert(bytes_of_parts() == sizeof(Scene), "a new member of Scene needs a line in for_each_part");

}  // namespace zstrip::detail
