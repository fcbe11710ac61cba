// The effects that a visibility method cannot draw, and the methods that exclude each other.
#pragma once

#include "zstrip/effects/effect.hpp"
#include "zstrip/visibility/methods.hpp"

namespace zstrip::detail::methods {

struct Described : AnyEffect {
  static constexpr std::array<EffectName, 0> kNames{};
  static constexpr Exclusion kExclusions[] = {
      {effect::perspective_runs, method::any, "methods keep bounds of exact depth"},
      {effect::depth_formats | effect::depth_ranges, method::own, "methods keep depth as z16"},
      {effect::depth_state, without(method::own, method::hierarchical_z),
       "a depth test of a material's own needs the scene's order and a z-buffer"},
      {effect::environment, method::orders, "the host has split triangles for their order"},
      {effect::lines, method::painter, "they are no triangles that could be sorted"},
      {effect::outlines, method::orders, "the host has split triangles for their order"},
      {effect::skins, method::any, "methods look at vertices and spheres before they are moved"},
      {effect::edges, method::any, "edges need the z-buffer of all that is drawn"},
      {effect::unclipped, method::any, "methods split triangles, or look at boxes of their own"},
      {effect::vertex_light, method::orders, "the host has split triangles for their order"},
      {effect::csg, method::painter | method::midpoint, "solids are cut by a z-buffer that is exact"},
      {effect::shadows, method::painter | method::midpoint, "a shadow is found by a z-buffer that is exact"},
      {effect::fragments, method::orders, "the host has split triangles for their order"},
      {effect::quadrics, method::painter, "they are no triangles that could be sorted"},
  };
};

/// A renderer has at most one method of each set.
inline constexpr Effects kAlternatives[] = {
    method::painter | method::bounded | method::splitting,
    method::sorted,
    method::orders,
};

inline constexpr Effects kAll = method::any;

/// True if an order is combined with the painter, the only method that uses orders.
constexpr bool has_what_it_needs(Effects effects) {
  return effects.has(method::painter) || !effects.any(method::orders);
}

}  // namespace zstrip::detail::methods
