// Which effects a scene calls for, and what in it calls for each.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "zstrip/effects/list.hpp"

namespace zstrip::sim {

/// Where what calls for effects stands: "room.toml line 12". Empty, or shorter than the scene: not known.
struct Origins {
  std::vector<std::string> material_names;
  std::vector<std::string> materials;
  std::string camera;
  std::string fog;
  std::string shadow{};
  std::string csg{};
};

struct FoundEffect {
  EffectName effect;
  std::vector<std::string> materials;  ///< those that call for it, in the scene's order; empty: not a material's doing
  std::string origin;                  ///< of the first of them, or of what else calls for it; may be empty
};

/// Those of `effects`, which are effects_of(scene, camera), effects_of(view) and perhaps effect::bins. Materials are
/// those of the instances for which effects_of, called for each alone, finds the effect, so that no rule stands here
/// twice. Materials without a name are called by their number.
std::vector<FoundEffect> find_effects(const Scene& scene, const Camera& camera, Effects effects,
                                      const Origins& origins);

}  // namespace zstrip::sim
