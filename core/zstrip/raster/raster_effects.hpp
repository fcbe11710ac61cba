// The effects that change how triangles become pixels.
#pragma once

#include "zstrip/effects.hpp"
#include "zstrip/kernels/medium_triangle.hpp"
#include "zstrip/plan/record_bytes.hpp"
#include "zstrip/visibility/traits.hpp"

namespace zstrip::detail {

/// Returns the set for which the rasterisers are instantiated, so that pipelines which differ in other stages share
/// their code. It omits the effects of earlier and later stages, and contains vertex_colours if anything gives vertices
/// a colour. It contains shadows where a kernel draws triangles in the narrow rectangles of pixels in shadow.
constexpr Effects raster_effects(Effects effects) {
  constexpr Effects kOfOtherStages = effect::bins | effect::billboards | effect::csg | effect::dithered_format |
                                     effect::edges | effect::lighting | effect::overlay | effect::skins |
                                     (kHasCutMedium ? Effects{} : effect::shadows) | effect::supersampled |
                                     effect::surfaces | methods::kOfOrder;
  const Effects colours = has_vertex_colours(effects) ? effect::vertex_colours : Effects{};
  return without(effects, kOfOtherStages) | colours;
}

/// True if some instance may show its back faces. Methods may show both sides of anything.
constexpr bool shows_both_sides(Effects effects) {
  return !effects.any(effect::shades) || effects.has(effect::two_sided) || effects.methods != 0;
}

}  // namespace zstrip::detail
