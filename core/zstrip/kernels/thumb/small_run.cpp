// The assembly behind thumb/small_run.hpp and thumb2/listed_run.hpp, and what it calls. With both coordinates of a
// vertex in one word a run takes half of what GCC makes of the C++.
#include "zstrip/kernels/thumb/small_run.hpp"

#include <cstddef>

#include "zstrip/kernels/medium_triangle.hpp"
#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/thumb/small_layout.hpp"
#include "zstrip/kernels/thumb/small_triangle.hpp"
#include "zstrip/kernels/thumb1/macros.hpp"
#include "zstrip/kernels/thumb2/listed_run.hpp"
#include "zstrip/kernels/thumb2/triangle_of_words.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1 || ZSTRIP_HAS_THUMB2

static_assert(offsetof(ThumbSmallRun, scan) == 0 && sizeof(SmallScan) == 112);
static_assert(offsetof(ThumbSmallRun, vertices) == 112 && offsetof(ThumbSmallRun, colours) == 116);
static_assert(offsetof(ThumbSmallRun, area) == 120 && offsetof(Rect, left) == 0 && offsetof(Rect, top) == 4 &&
              offsetof(Rect, right) == 8 && offsetof(Rect, bottom) == 12);
static_assert(offsetof(ThumbSmallRun, depth) == 136 && offsetof(ThumbSmallRun, colour) == 140);
static_assert(kSmallExtent == 181 && kSmallDepthDifference == 1U << 29);
static_assert(offsetof(ThumbListedRun, triangles) == 148 && offsetof(ThumbListedRun, batch) == 152 &&
              offsetof(ThumbListedRun, next_carried) == 156 && offsetof(ThumbListedRun, minus_rows_below) == 160 &&
              offsetof(ThumbListedRun, column) == 164);
static_assert(offsetof(ThumbListedRun, read) == 168 && offsetof(ThumbListedRun, write) == 172 &&
              offsetof(ThumbListedRun, begin) == 176 && offsetof(ThumbListedRun, end) == 180 &&
              offsetof(ThumbListedRun, end_of_last) == 184);
static_assert(sizeof(CarriedTriangle) == 64 && offsetof(CarriedTriangle, width) == 48 &&
              offsetof(CarriedTriangle, key) == 60);
static_assert(sizeof(CarriedTriangles) <= kBinChunkBytes);

// Of other objects, and only the assembly calls them. With link time optimisation the linker takes from an archive only
// what C++ names; no program keeps these.
[[gnu::used]] static constexpr auto* kSetUp = &set_up_small_thumb;
[[gnu::used]] static constexpr auto* kScan = &scan_small_thumb;

// A triangle that is not small, with the area and the colours of the run's scan. False: it is no medium one either.
// Used: the assembly calls it by its name.
[[gnu::used]] bool draw_medium_of_run(const ThumbSmallRun& run, const SnappedVertex& v0, const SnappedVertex& v1,
                                      const SnappedVertex& v2) asm("zstrip_draw_medium_of_run");
bool draw_medium_of_run([[maybe_unused]] const ThumbSmallRun& run, [[maybe_unused]] const SnappedVertex& v0,
                        [[maybe_unused]] const SnappedVertex& v1, [[maybe_unused]] const SnappedVertex& v2) {
  if constexpr (kHasMediumTriangles) {
    const Colour* const colours[3] = {&run.scan.colours[0], &run.scan.colours[1], &run.scan.colours[2]};
    return draw_medium<true>({*run.strip, v0, v1, v2, run.scan.area}, colours, 0);
  }
  return false;
}

[[gnu::naked]] std::uint32_t draw_small_run_thumb(ThumbSmallRun&, const Triangle*, std::uint32_t) {
#if ZSTRIP_HAS_THUMB1
  asm(
#include "zstrip/kernels/thumb1/small_run.inc"
  );
#else
  asm(".set .Lsmall_run_listed, 0\n"
#include "zstrip/kernels/thumb2/small_run.inc"
  );
#endif
}

#if ZSTRIP_HAS_THUMB2
[[gnu::naked]] std::uint32_t draw_listed_run_thumb2(ThumbListedRun&, const std::uint16_t*, std::uint32_t) {
  asm(".set .Lsmall_run_listed, 1\n"
#include "zstrip/kernels/thumb2/small_run.inc"
  );
}
#endif

#endif

}  // namespace zstrip::detail
