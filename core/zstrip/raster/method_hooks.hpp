// Hooks of the pixel loops, through which a visibility method selects the parts of triangles and runs to draw.
#pragma once

#include <cstdint>

#include "zstrip/kernels/span.hpp"
#include "zstrip/pixels/depth_rule.hpp"
#include "zstrip/pixels/target.hpp"

namespace zstrip::detail::methods {

/// Calls draw(run) for the parts of a span that the method has not found to be hidden.
template <DepthMode mode, class Depth, class Draw>
void for_each_shown_run(const TargetFor<mode>& target, const Depth& depth, std::int32_t row, std::int32_t left,
                        const Span<std::uint16_t>& span, const Draw& draw) {
  if constexpr (mode.state) {
    if (!is_plain(target.settings)) {
      target.method->bounds.forget({left, row, left + span.length, row + 1});
      return draw(span);
    }
  }
  target.method->bounds.for_each_shown(
      row, left, span.length, depth.plane().at(span.columns, span.rows), depth.plane().step_x, target.method->counts,
      [&](std::int32_t first, std::int32_t length) {
        draw(Span<std::uint16_t>{span.depth + first, span.colour + first, length, span.columns + first, span.rows,
                                 span.skipped + first, span.whole_length});
      });
}

/// Calls draw(piece, use) for the pieces of a triangle that the method has not found to be hidden. Defined by
/// zstrip/visibility.hpp.
template <DepthMode mode, class Draw>
void for_each_piece(const TargetFor<mode>& target, const RasterVertex& v0, const RasterVertex& v1,
                    const RasterVertex& v2, const Draw& draw);

}  // namespace zstrip::detail::methods
