// Kernel: draws spans, the pixels of one row that a triangle covers, with one colour or with interpolated colours.
//
// Depth is the value that the rule steps, 16.16 codes with z16. Colours are 8.16 and stay within 0 .. 255 over the
// span; all steps are modulo 2^32. Every implementation writes the same bits as portable/span.hpp, and nothing outside
// the span. Vectors support only the depth test of z16, without counting.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/base/statistics.hpp"
#include "zstrip/kernels/portable/span.hpp"
#include "zstrip/kernels/vector/span.hpp"
#include "zstrip/pixels/plane.hpp"
#include "zstrip/pixels/triangle_depth.hpp"

namespace zstrip::detail {

/// Draws a span with one colour; `span.length` > 0.
template <bool statistics, class DepthPlane, class Rule>
void fill_flat(const Span<typename Rule::Cell>& span, const DepthPlane& depth, const Rule& rule, std::uint16_t colour,
               Statistics* counters) {
  if constexpr (kHasVectors && !statistics && Rule::kNearerOnly) {
    fill_flat_vector(span.depth, span.colour, span.length, depth.at(span.columns, span.rows), depth.step_x, colour);
  } else {
    fill_flat_portable<statistics>(span, depth, rule, colour, counters);
  }
}

/// Draws a span with a colour that varies; `span.length` > 0.
template <bool statistics, class DepthPlane, class Rule>
void fill_gouraud(const Span<typename Rule::Cell>& span, const DepthPlane& depth, const Rule& rule,
                  const ColourPlanes& planes, Statistics* counters) {
  if constexpr (kHasVectors && !statistics && Rule::kNearerOnly) {
    const auto start = [&span](const Plane& plane) { return plane.at(span.columns, span.rows); };
    fill_gouraud_vector(span.depth, span.colour, span.length,
                        {start(depth), start(planes.r), start(planes.g), start(planes.b), depth.step_x, planes.r.step_x,
                         planes.g.step_x, planes.b.step_x});
  } else {
    fill_gouraud_portable<statistics>(span, depth, rule, planes, counters);
  }
}

}  // namespace zstrip::detail
