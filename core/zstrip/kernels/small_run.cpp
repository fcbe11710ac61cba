// The assembly of thumb/small_run.hpp and thumb2/listed_run.hpp, and the functions that it calls. With both coordinates
// of a vertex in one word, a run takes half of the instructions that GCC makes from the C++.
#include "zstrip/kernels/thumb/small_run.hpp"

#include <cstddef>

#include "zstrip/base/processor.hpp"
#include "zstrip/kernels/medium_triangle.hpp"
#include "zstrip/kernels/thumb/small_layout.hpp"
#include "zstrip/kernels/thumb/small_triangle.hpp"
#include "zstrip/kernels/thumb1/macros.hpp"
#include "zstrip/kernels/thumb2/listed_run.hpp"
#include "zstrip/kernels/thumb2/triangle_of_words.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1 || ZSTRIP_HAS_THUMB2

// clang-format off
#define ZSTRIP_SMALL_RUN(field, number)                         \
  field(run, ThumbSmallRun, scan, 0)                            \
  field(run, ThumbSmallRun, vertices, 112)                      \
  field(run, ThumbSmallRun, colours, 116)                       \
  number(run.left, offsetof(ThumbSmallRun, area.left), 120)     \
  number(run.top, offsetof(ThumbSmallRun, area.top), 124)       \
  number(run.right, offsetof(ThumbSmallRun, area.right), 128)   \
  number(run.bottom, offsetof(ThumbSmallRun, area.bottom), 132) \
  field(run, ThumbSmallRun, depth, 136)                         \
  field(run, ThumbSmallRun, colour, 140)                        \
  field(listed, ThumbListedRun, run, 0)                         \
  field(listed, ThumbListedRun, triangles, 148)                 \
  field(listed, ThumbListedRun, batch, 152)                     \
  field(listed, ThumbListedRun, next_carried, 156)              \
  field(listed, ThumbListedRun, minus_rows_below, 160)          \
  field(listed, ThumbListedRun, column, 164)                    \
  field(listed, ThumbListedRun, read, 168)                      \
  field(listed, ThumbListedRun, write, 172)                     \
  field(listed, ThumbListedRun, begin, 176)                     \
  field(listed, ThumbListedRun, end, 180)                       \
  field(listed, ThumbListedRun, end_of_last, 184)               \
  field(carried, CarriedTriangle, planes, 0)                    \
  field(carried, CarriedTriangle, width, 48)                    \
  field(carried, CarriedTriangle, rows, 52)                     \
  field(carried, CarriedTriangle, column, 56)                   \
  field(carried, CarriedTriangle, key, 60)                      \
  number(carried.size, sizeof(CarriedTriangle), 64)             \
  number(small.extent, kSmallExtent, 181)
// clang-format on
ZSTRIP_CHECK_LAYOUT(ZSTRIP_SMALL_RUN)
static_assert(kSmallDepthDifference == 1U << 29);
static_assert(sizeof(CarriedTriangles) <= kBinChunkBytes);

// Names functions that lie in other objects and that only the assembly calls: with link-time optimisation the linker
// takes from an archive only functions that C++ names. These pointers are in no program.
[[gnu::used]] static constexpr auto* kSetUp = &set_up_small_thumb;
[[gnu::used]] static constexpr auto* kScan = &scan_small_thumb;

// `used`: the assembly calls it by name.
[[gnu::used]] bool draw_medium_of_run([[maybe_unused]] const ThumbSmallRun& run,
                                      [[maybe_unused]] const SnappedVertex& v0,
                                      [[maybe_unused]] const SnappedVertex& v1,
                                      [[maybe_unused]] const SnappedVertex& v2) {
  if constexpr (kHasMediumTriangles) {
    const Colour* const colours[3] = {&run.scan.colours[0], &run.scan.colours[1], &run.scan.colours[2]};
    return draw_medium<true>({*run.strip, v0, v1, v2, run.scan.area}, colours, 0);
  }
  return false;
}

[[gnu::naked]] std::uint32_t draw_small_run_thumb(ThumbSmallRun&, const Triangle*, std::uint32_t) {
#if ZSTRIP_HAS_THUMB1
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_SMALL_SCAN) ZSTRIP_NAMES(ZSTRIP_SMALL_RUN)
#include "zstrip/kernels/thumb1/small_run.inc"
  );
#else
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_SMALL_SCAN)
          ZSTRIP_NAMES(ZSTRIP_SMALL_RUN) ".set .Lsmall_run_listed, 0\n"
#include "zstrip/kernels/thumb2/small_run.inc"
  );
#endif
}

#if ZSTRIP_HAS_THUMB2
[[gnu::naked]] std::uint32_t draw_listed_run_thumb2(ThumbListedRun&, const std::uint16_t*, std::uint32_t) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_SMALL_SCAN)
          ZSTRIP_NAMES(ZSTRIP_SMALL_RUN) ".set .Lsmall_run_listed, 1\n"
#include "zstrip/kernels/thumb2/small_run.inc"
  );
}
#endif

#endif

}  // namespace zstrip::detail
