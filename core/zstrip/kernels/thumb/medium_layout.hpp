// The layout of MediumScan for the assembly of medium triangles.
#pragma once

#include "zstrip/base/processor.hpp"
#include "zstrip/kernels/thumb/layout.hpp"
#include "zstrip/kernels/thumb/records.hpp"
#include "zstrip/pixels/medium_scan.hpp"

// clang-format off
#define ZSTRIP_MEDIUM_SCAN(field, number)                                          \
  field(edge, EdgeWalk, pixel, 0)                                                  \
  field(edge, EdgeWalk, remainder, 4)                                              \
  field(edge, EdgeWalk, step, 8)                                                   \
  field(edge, EdgeWalk, remainder_step, 12)                                        \
  field(edge, EdgeWalk, denominator, 16)                                           \
  number(medium.left, offsetof(MediumScan, rows.left), 0)                          \
  number(medium.right, offsetof(MediumScan, rows.right), 20)                       \
  number(medium.depth_row, offsetof(MediumScan, rows.depth_row), 40)               \
  number(medium.colour_row, offsetof(MediumScan, rows.colour_row), 44)             \
  number(medium.depth_stride, offsetof(MediumScan, rows.depth_stride), 48)         \
  number(medium.colour_stride, offsetof(MediumScan, rows.colour_stride), 52)       \
  number(medium.start_depth, offsetof(MediumScan, start[MediumScan::depth]), 56)   \
  number(medium.start_red, offsetof(MediumScan, start[MediumScan::red]), 60)       \
  number(medium.start_green, offsetof(MediumScan, start[MediumScan::green]), 64)   \
  number(medium.start_blue, offsetof(MediumScan, start[MediumScan::blue]), 68)     \
  number(medium.step_y_depth, offsetof(MediumScan, step_y[MediumScan::depth]), 72) \
  number(medium.step_y_red, offsetof(MediumScan, step_y[MediumScan::red]), 76)     \
  number(medium.step_y_green, offsetof(MediumScan, step_y[MediumScan::green]), 80) \
  number(medium.step_y_blue, offsetof(MediumScan, step_y[MediumScan::blue]), 84)   \
  number(medium.step_x_depth, offsetof(MediumScan, step_x[MediumScan::depth]), 88) \
  number(medium.step_x_red, offsetof(MediumScan, step_x[MediumScan::red]), 92)     \
  number(medium.step_x_green, offsetof(MediumScan, step_x[MediumScan::green]), 96) \
  number(medium.step_x_blue, offsetof(MediumScan, step_x[MediumScan::blue]), 100)  \
  field(medium, MediumScan, flat_colour, 104)                                      \
  field(medium, MediumScan, has_channels, 106)                                     \
  field(medium, MediumScan, area, 108)                                             \
  field(medium, MediumScan, anchor_x, 112)                                         \
  field(medium, MediumScan, anchor_y, 116)                                         \
  field(medium, MediumScan, colours, 120)                                          \
  field(medium, MediumScan, shared, 132)                                           \
  number(medium.size, sizeof(MediumScan), 160)
// clang-format on

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1 || ZSTRIP_HAS_THUMB2

ZSTRIP_CHECK_LAYOUT(ZSTRIP_MEDIUM_SCAN)
static_assert(sizeof(SharedOfPlanes) == 28);  // no gaps: the members lie in the order of the registers

#endif

}  // namespace zstrip::detail
