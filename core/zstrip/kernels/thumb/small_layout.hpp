// The layout of SmallScan for the assembly of small triangles.
#pragma once

#include "zstrip/base/processor.hpp"
#include "zstrip/kernels/thumb/layout.hpp"
#include "zstrip/kernels/thumb/records.hpp"
#include "zstrip/pixels/small_scan.hpp"

// clang-format off
#define ZSTRIP_SMALL_SCAN(field, number)                                                \
  number(small.start_edges, offsetof(SmallScan, start[SmallScan::edges]), 0)            \
  number(small.start_depth, offsetof(SmallScan, start[SmallScan::depth]), 4)            \
  number(small.start_green, offsetof(SmallScan, start[SmallScan::green]), 8)            \
  number(small.start_red_blue, offsetof(SmallScan, start[SmallScan::red_blue]), 12)     \
  number(small.step_x_edges, offsetof(SmallScan, step_x[SmallScan::edges]), 16)         \
  number(small.step_x_depth, offsetof(SmallScan, step_x[SmallScan::depth]), 20)         \
  number(small.step_x_green, offsetof(SmallScan, step_x[SmallScan::green]), 24)         \
  number(small.step_x_red_blue, offsetof(SmallScan, step_x[SmallScan::red_blue]), 28)   \
  number(small.step_y_edges, offsetof(SmallScan, step_y[SmallScan::edges]), 32)         \
  number(small.step_y_depth, offsetof(SmallScan, step_y[SmallScan::depth]), 36)         \
  number(small.step_y_green, offsetof(SmallScan, step_y[SmallScan::green]), 40)         \
  number(small.step_y_red_blue, offsetof(SmallScan, step_y[SmallScan::red_blue]), 44)   \
  number(small.to_step_x, offsetof(SmallScan, step_x) - offsetof(SmallScan, start), 16) \
  number(small.to_step_y, offsetof(SmallScan, step_y) - offsetof(SmallScan, start), 32) \
  field(small, SmallScan, depth_row, 48)                                                \
  field(small, SmallScan, colour_row, 52)                                               \
  field(small, SmallScan, depth_stride, 56)                                             \
  field(small, SmallScan, colour_stride, 60)                                            \
  field(small, SmallScan, width, 64)                                                    \
  field(small, SmallScan, height, 68)                                                   \
  field(small, SmallScan, colours, 72)                                                  \
  field(small, SmallScan, area, 84)                                                     \
  field(small, SmallScan, anchor_x, 88)                                                 \
  field(small, SmallScan, anchor_y, 92)                                                 \
  field(small, SmallScan, first_column, 96)                                             \
  field(small, SmallScan, first_row, 100)                                               \
  field(small, SmallScan, flat_colour, 104)                                             \
  number(small.size, sizeof(SmallScan), 112)                                            \
  number(small.signs, PackedEdges::kSigns, 0x80200400)
// clang-format on

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1 || ZSTRIP_HAS_THUMB2

ZSTRIP_CHECK_LAYOUT(ZSTRIP_SMALL_SCAN)

#endif

}  // namespace zstrip::detail
