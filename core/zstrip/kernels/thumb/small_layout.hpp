// Where the assembly for small triangles, in Thumb-1 and Thumb-2, expects what C++ hands to it.
#pragma once

#include <cstddef>

#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/small_scan.hpp"
#include "zstrip/kernels/thumb/small_run.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1 || ZSTRIP_HAS_THUMB2

static_assert(offsetof(SmallScan, start) == 0 && offsetof(SmallScan, step_x) == 16 &&
              offsetof(SmallScan, step_y) == 32);
static_assert(offsetof(SmallScan, depth_row) == 48 && offsetof(SmallScan, colour_row) == 52);
static_assert(offsetof(SmallScan, depth_stride) == 56 && offsetof(SmallScan, colour_stride) == 60);
static_assert(offsetof(SmallScan, width) == 64 && offsetof(SmallScan, height) == 68);
static_assert(offsetof(SmallScan, colours) == 72 && offsetof(SmallScan, area) == 84);
static_assert(offsetof(SmallScan, anchor_x) == 88 && offsetof(SmallScan, anchor_y) == 92);
static_assert(offsetof(SnappedVertex, x) == 0 && offsetof(SnappedVertex, y) == 2 &&
              offsetof(SnappedVertex, depth) == 4);
static_assert(offsetof(Colour, r) == 0 && offsetof(Colour, g) == 1 && offsetof(Colour, b) == 2);
static_assert(SmallScan::edges == 0 && SmallScan::depth == 1 && SmallScan::green == 2 && SmallScan::red_blue == 3);
static_assert(kPixelCentre == 15);
static_assert(PackedEdges::kSigns == 0x80200400U);

static_assert(offsetof(ThumbSmallRun, scan) == 0);
static_assert(offsetof(SmallScan, first_column) == 96 && offsetof(SmallScan, first_row) == 100 &&
              offsetof(SmallScan, flat_colour) == 104);
static_assert(offsetof(ThumbSmallRun, vertices) == 112 && offsetof(ThumbSmallRun, colours) == 116);
static_assert(offsetof(ThumbSmallRun, area) == 120 && offsetof(Rect, left) == 0 && offsetof(Rect, top) == 4 &&
              offsetof(Rect, right) == 8 && offsetof(Rect, bottom) == 12);
static_assert(offsetof(ThumbSmallRun, depth) == 136 && offsetof(ThumbSmallRun, colour) == 140);
static_assert(sizeof(Triangle) == 6 && sizeof(SnappedVertex) == 8 && sizeof(Colour) == 4);
static_assert(kSmallExtent == 181 && kSmallDepthDifference == 1U << 29);

#endif

}  // namespace zstrip::detail
