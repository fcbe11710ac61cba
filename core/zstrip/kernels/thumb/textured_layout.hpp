// Where the assembly for medium textured triangles, in Thumb-1 and Thumb-2, expects what C++ hands to it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "zstrip/kernels/medium_textured.hpp"
#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/textured_scan.hpp"
#include "zstrip/kernels/thumb/medium_layout.hpp"
#include "zstrip/kernels/thumb/run_layout.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1 || ZSTRIP_HAS_THUMB2

static_assert(offsetof(TexturedScan, scan) == 0 && offsetof(TexturedScan, start) == 160 &&
              offsetof(TexturedScan, step_y) == 172 && offsetof(TexturedScan, step_x) == 184);
static_assert(offsetof(TexturedScan, base_u) == 196 && offsetof(TexturedScan, base_v) == 200 &&
              offsetof(TexturedScan, right_shift) == 212 && offsetof(TexturedScan, row) == 216);
static_assert(offsetof(TexturedVertex, depth) == 0 && offsetof(TexturedVertex, u) == 4 &&
              offsetof(TexturedVertex, v) == 8);
static_assert(TexturedScan::one_over_w == 0 && TexturedScan::u_over_w == 1 && TexturedScan::v_over_w == 2);

#endif

}  // namespace zstrip::detail
