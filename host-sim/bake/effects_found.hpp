// Lists the effects that a scene needs, and the parts of the scene that need each.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "zstrip/effects/list.hpp"

namespace zstrip::sim {

/// The places in files of the parts that need effects: "room.toml line 12". Empty, or shorter than the scene: not
/// known.
struct Origins {
  std::vector<std::string> material_names;
  std::vector<std::string> materials;
  std::string camera;
  std::string fog;
  std::string shadow{};
  std::string csg{};
  std::vector<std::string> instance_names{};  ///< of the file: "wheel", "train/wheel"; may be empty
};

struct FoundEffect {
  EffectName effect;
  std::vector<std::string> materials;  ///< the materials that need it, in the scene's order; empty: no material needs
                                       ///< it
  std::string origin;                  ///< of the first of these materials, or of the other part that needs it; may be
                                       ///< empty
};

/// Lists `effects`, which are effects_of(scene, camera), effects_of(view) and perhaps effect::bins. The materials are
/// those of instances for which effects_of, called for each alone, returns the effect, so that no rule is repeated
/// here. The text for materials without a name is their number.
std::vector<FoundEffect> find_effects(const Scene& scene, const Camera& camera, Effects effects,
                                      const Origins& origins);

}  // namespace zstrip::sim
