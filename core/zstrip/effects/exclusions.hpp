// Effects and methods that exclude each other: all checks and messages follow from these rules.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "zstrip/effects/list.hpp"

namespace zstrip {

/// No renderer has effects or methods of both sides of one of these.
inline constexpr auto kExclusions = detail::DescribedEffects::exclusions();

/// No renderer has more than one of each of these sets.
inline constexpr Effects kAlternatives[] = {
    effect::depth_formats | effect::depth_ranges,
    effect::perspective_runs,
};

namespace detail {

/// Unrolled, so that firmware links neither a table nor a text.
template <std::size_t... i>
constexpr Effects excluded_by(Effects effects, std::index_sequence<i...>) {
  Effects excluded{};
  const auto add = [&](Effects one, Effects other) {
    if (effects.any(one)) excluded = excluded | other;
    if (effects.any(other)) excluded = excluded | one;
  };
  (add(kExclusions[i].one, kExclusions[i].other), ...);
  return excluded;
}
/// Unrolled for the same reason.
template <const auto& alternatives, std::size_t... i>
constexpr bool one_of_each(Effects effects, std::index_sequence<i...>) {
  const auto single = [](auto bits) { return (bits & (bits - 1)) == 0; };
  return ((single((effects & alternatives[i]).bits) && single((effects & alternatives[i]).methods)) && ...);
}

/// Returns all effects that exclude one of these.
constexpr Effects excluded_by(Effects effects) {
  return excluded_by(effects, std::make_index_sequence<kExclusions.size()>());
}
template <const auto& alternatives>
constexpr bool one_of_each(Effects effects) {
  return one_of_each<alternatives>(effects, std::make_index_sequence<std::size(alternatives)>());
}

}  // namespace detail

/// True if these effects can be combined, with any method.
constexpr bool effects_agree(Effects effects) {
  effects.methods = 0;
  return !effects.any(detail::excluded_by(effects)) && detail::one_of_each<kAlternatives>(effects);
}

/// Returns the effects of this set that its methods cannot draw.
constexpr Effects refused_by_methods(Effects effects) {
  return {effects.bits & detail::excluded_by({0, effects.methods}).bits, 0};
}

/// True if the methods can be combined and can draw all these effects. False for an unknown effect.
constexpr bool methods_agree(Effects effects) {
  if (effects.methods == 0) return true;
  constexpr Effects kKnown = effect::of_scenes | effect::shades | effect::statistics | effect::bins |
                             effect::depth_formats | effect::depth_ranges | detail::methods::kAll;
  return without(effects, kKnown) == Effects{} && refused_by_methods(effects) == Effects{} &&
         detail::one_of_each<detail::methods::kAlternatives>(effects) && detail::methods::has_what_it_needs(effects);
}

}  // namespace zstrip
