// Draws spans with one colour and with interpolated colours in C++, on every processor.
#pragma once

#include <cstdint>

#include "zstrip/base/statistics.hpp"
#include "zstrip/pixels/colour.hpp"
#include "zstrip/pixels/plane.hpp"
#include "zstrip/pixels/triangle_depth.hpp"

namespace zstrip::detail {

template <bool statistics, class DepthPlane, class Rule>
void fill_flat_portable(const Span<typename Rule::Cell>& span, const DepthPlane& depth, const Rule& rule,
                        std::uint16_t colour, Statistics* counters) {
  auto z = depth.at(span.columns, span.rows);
  for (std::int32_t i = 0; i < span.length; ++i) {
    if (rule.draws(z, span.depth[i])) {
      span.colour[i] = colour;
      count_pass<statistics>(counters);
    }
    z += depth.step_x;
  }
}

template <bool statistics, class DepthPlane, class Rule>
void fill_gouraud_portable(const Span<typename Rule::Cell>& span, const DepthPlane& depth, const Rule& rule,
                           const ColourPlanes& planes, Statistics* counters) {
  auto z = depth.at(span.columns, span.rows);
  std::uint32_t r = planes.r.at(span.columns, span.rows);
  std::uint32_t g = planes.g.at(span.columns, span.rows);
  std::uint32_t b = planes.b.at(span.columns, span.rows);
  for (std::int32_t i = 0; i < span.length; ++i) {
    if (rule.draws(z, span.depth[i])) {
      span.colour[i] = rgb565(r, g, b);
      count_pass<statistics>(counters);
    }
    z += depth.step_x;
    r += planes.r.step_x;
    g += planes.g.step_x;
    b += planes.b.step_x;
  }
}

}  // namespace zstrip::detail
