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

/// Counts the colours and the addresses of a scene.
struct SceneSize {
  std::size_t colours = 0, addresses = 0;
  template <class Record>
  constexpr void add(std::span<const Record>) {
    addresses += 2;  // a size has as many bytes
  }
  template <class Record>
  constexpr void add(const Record*) {
    ++addresses;
  }
  constexpr void add(const Colour&) { ++colours; }
};

/// Returns the size of a Scene on a processor whose addresses have this many bytes.
constexpr std::size_t scene_bytes(std::size_t address_bytes) {
  const Scene scene;
  SceneSize size;
  for_each_part(scene, [&size](const char*, const auto& part) { size.add(part); });
  return size.colours * sizeof(Colour) + size.addresses * address_bytes;
}
static_assert(scene_bytes(sizeof(void*)) == sizeof(Scene), "a new member of Scene needs a line in for_each_part");

}  // namespace zstrip::detail
