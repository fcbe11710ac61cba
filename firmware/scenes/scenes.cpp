// The catalogue: every built-in scene with its name.
#include "zstrip_scenes/scenes.hpp"

#include "zstrip_scenes/character.hpp"
#include "zstrip_scenes/cube.hpp"
#include "zstrip_scenes/effect_scenes.hpp"
#include "zstrip_scenes/knot.hpp"
#include "zstrip_scenes/knot_meshlets.hpp"
#include "zstrip_scenes/random.hpp"
#include "zstrip_scenes/room.hpp"
#include "zstrip_scenes/spheres.hpp"
#include "zstrip_scenes/teapot.hpp"
#include "zstrip_scenes/teapot_meshlets.hpp"
#include "zstrip_scenes/terrain.hpp"
#include "zstrip_scenes/triangle.hpp"
#include "zstrip_scenes/wires.hpp"

namespace zstrip::scenes {
namespace {

constexpr BuiltIn kBuiltIn[] = {
    triangle, cube, room,      spheres,  random50,      teapot,        teapot_meshlets, wires,
    terrain,  knot, knot_flat, knot_lit, knot_meshlets, knot_textured, random10k,       random10k_meshlets};

/// Deformable scenes share one buffer in RAM, so the turntable and scene files leave them out.
constexpr BuiltIn kBending[] = {character};

constexpr bool all_fit_staged() {
  for (const BuiltIn& scene : kBuiltIn) {
    if (scene.scene.instances.size() > kMaxInstances) return false;
  }
  return true;
}
static_assert(all_fit_staged());

/// Compares without strlen, which a freestanding target need not have.
bool equal(std::string_view name, const char* other) {
  for (const char character : name) {
    if (*other == '\0' || *other != character) return false;
    ++other;
  }
  return *other == '\0';
}

}  // namespace

std::span<const BuiltIn> built_in() { return kBuiltIn; }

const BuiltIn* find(std::string_view name) {
  for (const std::span<const BuiltIn> scenes : {built_in(), effect_scenes(), std::span<const BuiltIn>(kBending)}) {
    for (const BuiltIn& scene : scenes) {
      if (equal(name, scene.name)) return &scene;
    }
  }
  return nullptr;
}

}  // namespace zstrip::scenes
