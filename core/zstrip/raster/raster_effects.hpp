// The part of a set of effects that changes how triangles become pixels.
#pragma once

#include "zstrip/effects.hpp"
#include "zstrip/plan/record_bytes.hpp"
#include "zstrip/visibility/traits.hpp"

namespace zstrip::detail {

/// The set that the rasterisers are made for, so that pipelines which differ in other stages share their code: without
/// what only earlier or later stages do, with vertex_colours for whatever gives vertices a colour.
constexpr Effects raster_effects(Effects effects) {
  constexpr Effects kOfOtherStages = effect::bins | effect::billboards | effect::csg | effect::dithered_format |
                                     effect::edges | effect::lighting | effect::overlay | effect::shadows |
                                     effect::skins | effect::supersampled | effect::surfaces | methods::kOfOrder;
  const Effects colours = has_vertex_colours(effects) ? effect::vertex_colours : Effects{};
  return without(effects, kOfOtherStages) | colours;
}

/// True if some instance may show its back faces. Methods may show both sides of anything.
constexpr bool shows_both_sides(Effects effects) {
  return !effects.any(effect::shades) || effects.has(effect::two_sided) || effects.methods != 0;
}

}  // namespace zstrip::detail
