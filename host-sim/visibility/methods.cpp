// The table of visibility methods.
#include "visibility/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bake/effects_found.hpp"
#include "zstrip/effects/exclusions.hpp"

namespace zstrip::sim {
namespace {

constexpr std::array kMethods{
    VisibilityMethod{"zbuffer", {}, "the nearest of each pixel, whatever the order"},
    VisibilityMethod{"painter", method::painter, "triangles from far to near, no depth memory"},
    VisibilityMethod{"painter-newell", method::painter | method::in_order,
                     "the same, with splits where no order is right"},
    VisibilityMethod{"painter-bsp", method::painter | method::bsp, "the same, in the order of a tree that was baked"},
    VisibilityMethod{"half-range", effect::depth_ranges, "the z-buffer in sub-ranges, with fewer clears"},
    VisibilityMethod{"front-to-back", method::front_to_back, "triangles from near to far, and the z-buffer"},
    VisibilityMethod{"hierarchical-z", method::hierarchical_z, "the z-buffer, with bounds of 8x8 tiles and a pyramid"},
    VisibilityMethod{"front-to-back-hierarchical-z", method::front_to_back | method::hierarchical_z, "the last two"},
    VisibilityMethod{"midpoint", method::midpoint, "triangles split at their centroids, decided by samples"},
    VisibilityMethod{"midpoint-safe", method::midpoint_safe, "the same, but samples are confirmed or pixels tested"},
};

}  // namespace

std::span<const VisibilityMethod> visibility_methods() { return kMethods; }

std::string visibility_names() {
  std::string names;
  for (const VisibilityMethod& known : kMethods) names += fmt::format("{}{}", names.empty() ? "" : ", ", known.name);
  return names;
}

Result<VisibilityMethod> parse_visibility(const std::string& name) {
  const auto* const found = std::ranges::find(kMethods, name, &VisibilityMethod::name);
  if (found != kMethods.end()) return *found;
  return Failure{ExitStatus::usage, fmt::format("--visibility '{}' is not one of: {}", name, visibility_names())};
}

std::string_view visibility_name(Effects effects) {
  const Effects own = without(Effects{effects.bits & effect::depth_ranges.bits, effects.methods}, method::culling);
  const auto* const found = std::ranges::find(kMethods, own, &VisibilityMethod::effects);
  return found == kMethods.end() ? "?" : found->name;
}

Result<Done> check_visibility(Effects effects, std::string_view depth_given) {
  const std::string_view name = visibility_name(effects);
  const bool ranges = effects.has(effect::depth_ranges), formats = effects.any(effect::depth_formats);
  if ((effects.methods != 0 && (ranges || formats)) || (ranges && formats)) {
    const bool culls = effects.methods != 0 && without(Effects{0, effects.methods}, method::culling) == Effects{};
    return Failure{ExitStatus::usage, fmt::format("{} with depth as z16 only: leave out {}",
                                                  culls ? std::string("--cull and --visible-sets go")
                                                        : fmt::format("--visibility {} goes", name),
                                                  ranges && !formats ? "--visibility half-range" : depth_given)};
  }
  for (const Exclusion& exclusion : kExclusions) {
    if (!effects.any(exclusion.one) || !effects.any(Effects{exclusion.other.bits, 0})) continue;
    const auto* const named = std::ranges::find_if(
        kEffectNames, [&](const EffectName& each) { return effects.any(each.effect & exclusion.one); });
    return Failure{ExitStatus::usage, fmt::format("'{}' does not go with {}: {}; leave one of them out", named->name,
                                                  ranges                ? "--visibility half-range"
                                                  : depth_given.empty() ? "this depth format"
                                                                        : depth_given,
                                                  exclusion.why)};
  }
  if (effects.any(effect::perspective_runs) && (effects.methods != 0 || ranges || formats)) {
    return Failure{ExitStatus::usage, fmt::format("--perspective, or 'perspective' in the scene file, goes with the "
                                                  "z-buffer and depth as z16 only: leave it out, or {}",
                                                  formats             ? depth_given
                                                  : ranges            ? "--visibility half-range"
                                                  : name == "zbuffer" ? "--cull and --visible-sets"
                                                                      : "--visibility")};
  }
  if (methods_agree(effects)) return Done{};
  const Effects refused = refused_by_methods(effects);
  std::string missing;
  for (const EffectName& known : kEffectNames) {
    if (!refused.has(known.effect)) continue;
    missing += fmt::format("{}{} ({})", missing.empty() ? "" : ", ", known.name, known.called_for_by);
  }
  if (missing.empty()) return Failure{ExitStatus::usage, fmt::format("--visibility {} excludes another method", name)};
  if (without(Effects{0, effects.methods}, method::culling) == Effects{}) {
    return Failure{ExitStatus::usage,
                   fmt::format("--cull and --visible-sets exclude effects of this scene: {}; leave them out", missing)};
  }
  std::string able;
  for (const VisibilityMethod& method : kMethods) {
    const Effects together = refused | method.effects;
    if (effects_agree(together) && !refused_by_methods(together).any(effect::of_scenes)) {
      able += fmt::format("{}{}", able.empty() ? "" : ", ", method.name);
    }
  }
  return Failure{ExitStatus::usage, fmt::format("--visibility {} cannot draw effects of this scene: {}; these can: {}",
                                                name, missing, able)};
}

}  // namespace zstrip::sim
