// Effects and methods that exclude each other: all checks and messages follow from these rules.
#pragma once

#include <cstddef>
#include <utility>

#include "zstrip/effects/list.hpp"

namespace zstrip {

/// Effects and methods of which no renderer has one of each side.
inline constexpr auto kExclusions = detail::DescribedEffects::exclusions();

/// Sets of which a renderer has at most one.
inline constexpr Effects kAlternatives[] = {
    effect::depth_formats | effect::depth_ranges,
    effect::perspective_runs,
};

namespace detail {

/// Unrolled, so that no table and no text is linked with a board's program.
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
/// Unrolled likewise.
template <const auto& alternatives, std::size_t... i>
constexpr bool one_of_each(Effects effects, std::index_sequence<i...>) {
  const auto single = [](auto bits) { return (bits & (bits - 1)) == 0; };
  return ((single((effects & alternatives[i]).bits) && single((effects & alternatives[i]).methods)) && ...);
}

/// All that cannot be together with one of these.
constexpr Effects excluded_by(Effects effects) {
  return excluded_by(effects, std::make_index_sequence<kExclusions.size()>());
}
template <const auto& alternatives>
constexpr bool one_of_each(Effects effects) {
  return one_of_each<alternatives>(effects, std::make_index_sequence<std::size(alternatives)>());
}

}  // namespace detail

/// True if these effects go together, with any method.
constexpr bool effects_agree(Effects effects) {
  effects.methods = 0;
  return !effects.any(detail::excluded_by(effects)) && detail::one_of_each<kAlternatives>(effects);
}

/// Which of these effects their methods cannot draw.
constexpr Effects refused_by_methods(Effects effects) {
  return {effects.bits & detail::excluded_by({0, effects.methods}).bits, 0};
}

/// True if the methods go together and can draw all these effects. False for an unknown effect.
constexpr bool methods_agree(Effects effects) {
  if (effects.methods == 0) return true;
  constexpr Effects kKnown = effect::of_scenes | effect::shades | effect::statistics | effect::bins |
                             effect::depth_formats | effect::depth_ranges | detail::methods::kAll;
  return without(effects, kKnown) == Effects{} && refused_by_methods(effects) == Effects{} &&
         detail::one_of_each<detail::methods::kAlternatives>(effects) && detail::methods::has_what_it_needs(effects);
}

}  // namespace zstrip
