// Where the assembly for small triangles, in Thumb-1 and Thumb-2, expects what C++ hands to it.
#pragma once

#include <cstddef>

#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/small_scan.hpp"
#include "zstrip/kernels/thumb/records.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1 || ZSTRIP_HAS_THUMB2

static_assert(offsetof(SmallScan, start) == 0 && offsetof(SmallScan, step_x) == 16 &&
              offsetof(SmallScan, step_y) == 32);
static_assert(offsetof(SmallScan, depth_row) == 48 && offsetof(SmallScan, colour_row) == 52);
static_assert(offsetof(SmallScan, depth_stride) == 56 && offsetof(SmallScan, colour_stride) == 60);
static_assert(offsetof(SmallScan, width) == 64 && offsetof(SmallScan, height) == 68);
static_assert(offsetof(SmallScan, colours) == 72 && offsetof(SmallScan, area) == 84);
static_assert(offsetof(SmallScan, anchor_x) == 88 && offsetof(SmallScan, anchor_y) == 92);
static_assert(SmallScan::edges == 0 && SmallScan::depth == 1 && SmallScan::green == 2 && SmallScan::red_blue == 3);
static_assert(PackedEdges::kSigns == 0x80200400U);
static_assert(offsetof(SmallScan, first_column) == 96 && offsetof(SmallScan, first_row) == 100 &&
              offsetof(SmallScan, flat_colour) == 104);

#endif

}  // namespace zstrip::detail
