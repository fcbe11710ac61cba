// Where the assembly for medium triangles, in Thumb-1 and Thumb-2, expects what C++ hands to it.
#pragma once

#include <cstddef>

#include "zstrip/kernels/medium_scan.hpp"
#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/thumb/records.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1 || ZSTRIP_HAS_THUMB2

static_assert(offsetof(MediumScan, rows) == 0 && offsetof(MediumRows, left) == 0 && offsetof(MediumRows, right) == 20);
static_assert(offsetof(EdgeWalk, pixel) == 0 && offsetof(EdgeWalk, remainder) == 4 && offsetof(EdgeWalk, step) == 8 &&
              offsetof(EdgeWalk, remainder_step) == 12 && offsetof(EdgeWalk, denominator) == 16);
static_assert(offsetof(MediumRows, depth_row) == 40 && offsetof(MediumRows, colour_row) == 44);
static_assert(offsetof(MediumRows, depth_stride) == 48 && offsetof(MediumRows, colour_stride) == 52);
static_assert(offsetof(MediumScan, start) == 56 && offsetof(MediumScan, step_y) == 72 &&
              offsetof(MediumScan, step_x) == 88);
static_assert(MediumScan::depth == 0 && MediumScan::red == 1 && MediumScan::green == 2 && MediumScan::blue == 3);
static_assert(offsetof(MediumScan, flat_colour) == 104 && offsetof(MediumScan, has_channels) == 106 &&
              offsetof(MediumScan, area) == 108 && offsetof(MediumScan, anchor_x) == 112 &&
              offsetof(MediumScan, anchor_y) == 116 && offsetof(MediumScan, colours) == 120 &&
              offsetof(MediumScan, shared) == 132 && sizeof(SharedOfPlanes) == 28);

#endif

}  // namespace zstrip::detail
