// The assembly behind listed_run.hpp.
#include "zstrip/kernels/thumb2/listed_run.hpp"

#include <cstddef>

#include "zstrip/kernels/thumb/medium_triangle.hpp"
#include "zstrip/kernels/thumb/small_layout.hpp"
#include "zstrip/kernels/thumb/small_triangle.hpp"
#include "zstrip/kernels/thumb2/triangle_of_words.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB2

static_assert(offsetof(ThumbListedRun, triangles) == 148 && offsetof(ThumbListedRun, batch) == 152 &&
              offsetof(ThumbListedRun, next_carried) == 156 && offsetof(ThumbListedRun, minus_rows_below) == 160 &&
              offsetof(ThumbListedRun, column) == 164);
static_assert(offsetof(ThumbListedRun, read) == 168 && offsetof(ThumbListedRun, write) == 172 &&
              offsetof(ThumbListedRun, begin) == 176 && offsetof(ThumbListedRun, end) == 180 &&
              offsetof(ThumbListedRun, end_of_last) == 184);
static_assert(sizeof(CarriedTriangle) == 64 && offsetof(CarriedTriangle, width) == 48 &&
              offsetof(CarriedTriangle, key) == 60);
static_assert(sizeof(CarriedTriangles) <= kBinChunkBytes);

// What the assembly calls.
[[gnu::used]] static constexpr auto* kSetUpOfListed = &set_up_small_thumb;
[[gnu::used]] static constexpr auto* kScanOfListed = &scan_small_thumb;
[[gnu::used]] static constexpr auto* kMediumOfListed = &draw_medium_of_run;

// Registers as in small_run.cpp; r10 the next index.
[[gnu::naked]] std::uint32_t draw_listed_run_thumb2(ThumbListedRun&, const std::uint16_t*, std::uint32_t) {
  asm(
#include "zstrip/kernels/thumb2/small_run.inc"
      R"(
    zstrip_small_run 1
    .purgem zstrip_small_run
    .purgem zstrip_small_rows
    .purgem zstrip_small_move
    .purgem zstrip_triangle_area
    .purgem zstrip_triangle_box
  )");
}

#endif

}  // namespace zstrip::detail
