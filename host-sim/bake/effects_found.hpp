// Which effects a scene calls for, and what in it calls for each.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "zstrip/scene/effects.hpp"

namespace zstrip::sim {

/// An effect that a baked scene can have.
struct KnownEffect {
  Effects effect;
  const char* name;    ///< as in the core's headers
  const char* reason;  ///< what calls for it: "a texture and texture coordinates"
};
std::span<const KnownEffect> known_effects();

struct FoundEffect {
  KnownEffect effect;
  std::vector<std::string> materials;  ///< those that call for it, in the scene's order; empty: not a material's doing
};

/// Those of `effects`, which are effects_of(scene, camera) and perhaps effect::bins. Materials are those of the
/// instances for which effects_of, asked for each alone, finds the effect, so that no rule stands here twice.
/// `material_names` may be shorter than the scene's materials, or hold empty names: those are called by their number.
std::vector<FoundEffect> find_effects(const Scene& scene, const Camera& camera, Effects effects,
                                      std::span<const std::string> material_names);

}  // namespace zstrip::sim
