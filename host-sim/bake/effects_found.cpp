// Lists the effects that a scene needs, and the parts of the scene that need each.
#include "bake/effects_found.hpp"
#include "zstrip/effects/exclusions.hpp"

#include <fmt/format.h>

#include <set>

namespace zstrip::sim {
namespace {

std::string name_of(std::uint16_t material, std::span<const std::string> names) {
  return material < names.size() && !names[material].empty() ? names[material] : fmt::format("number {}", material);
}

}  // namespace

std::vector<FoundEffect> find_effects(const Scene& scene, const Camera& camera, Effects effects,
                                      const Origins& origins) {
  std::vector<FoundEffect> found;
  for (const EffectName& known : kEffectNames) {
    if (!effects.has(known.effect)) continue;
    constexpr Effects kOfPicture =
        effect::dithered_colours | effect::dithered_format | effect::supersampled | effect::edges | effect::overlay;
    if (kOfPicture.has(known.effect)) {
      found.push_back({known, {}, {}});
      continue;
    }
    const auto is_of_scene = [&](Effects effect, const std::string& origin) {
      if (known.effect == effect) found.push_back({known, {}, origin});
      return known.effect == effect;
    };
    if (is_of_scene(effect::fog, origins.fog) || is_of_scene(effect::orthographic, origins.camera) ||
        is_of_scene(effect::shadows, origins.shadow) || is_of_scene(effect::csg, origins.csg)) {
      continue;
    }
    FoundEffect effect{known, {}, {}};
    std::set<std::string> seen;
    const auto consider = [&](std::span<const Instance> instances, std::span<const Quadric> quadrics,
                              std::span<const LineSet> lines, std::uint16_t material) {
      Scene alone = scene;
      alone.instances = instances;
      alone.quadrics = quadrics;
      alone.lines = lines;
      if (!effects_of(alone, camera).has(known.effect)) return;
      const std::string name = name_of(material, origins.material_names);
      if (seen.empty() && material < origins.materials.size()) effect.origin = origins.materials[material];
      if (seen.insert(name).second) effect.materials.push_back(name);
    };
    for (const Instance& instance : scene.instances) consider({&instance, 1}, {}, {}, instance.material);
    for (const Quadric& quadric : scene.quadrics) consider({}, {&quadric, 1}, {}, quadric.material);
    for (const LineSet& lines : scene.lines) consider({}, {}, {&lines, 1}, lines.material);
    found.push_back(effect);
  }
  return found;
}

}  // namespace zstrip::sim
