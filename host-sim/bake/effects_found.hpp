// Which effects a scene calls for, and what in it calls for each.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "zstrip/scene/effects.hpp"

namespace zstrip::sim {

struct FoundEffect {
  Effects effect;                      ///< one
  const char* name;                    ///< as in the core's headers
  const char* reason;                  ///< "a texture and texture coordinates"
  std::vector<std::string> materials;  ///< those that call for it, in the scene's order; empty: not a material's doing
};

/// What effects_of finds for each instance alone, so that no rule stands here twice. `material_names` may be shorter
/// than the scene's materials, or hold empty names: those are called by their number.
std::vector<FoundEffect> find_effects(const Scene& scene, const Camera& camera,
                                      std::span<const std::string> material_names);

}  // namespace zstrip::sim
