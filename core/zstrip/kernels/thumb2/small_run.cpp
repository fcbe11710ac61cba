// The assembly behind thumb/small_run.hpp. Without calls between the stages of a triangle, and with both coordinates
// of a vertex in one word, it takes half of what GCC makes of the C++. Offsets are thumb/small_layout.hpp's.
#include "zstrip/kernels/thumb/small_run.hpp"

#include "zstrip/kernels/thumb/medium_triangle.hpp"
#include "zstrip/kernels/thumb/small_layout.hpp"
#include "zstrip/kernels/thumb/small_triangle.hpp"
#include "zstrip/kernels/thumb2/triangle_of_words.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB2

// What the assembly calls. With link time optimisation the linker takes from an archive only what C++ names; no program
// keeps these.
[[gnu::used]] static constexpr auto* kSetUp = &set_up_small_thumb;
[[gnu::used]] static constexpr auto* kScan = &scan_small_thumb;
[[gnu::used]] static constexpr auto* kMedium = &draw_medium_of_run;

// r0 the run, r10 the next triangle, r11 its vertices, lr how many triangles are left; r1 to r3 the indices of a
// triangle's vertices, then their addresses. On the stack: what was left of the count, and the count.
[[gnu::naked]] std::uint32_t draw_small_run_thumb(ThumbSmallRun&, const Triangle*, std::uint32_t) {
  asm(
#include "zstrip/kernels/thumb2/small_run.inc"
      R"(
    zstrip_small_run 0
    .purgem zstrip_small_run
    .purgem zstrip_small_rows
    .purgem zstrip_small_move
    .purgem zstrip_triangle_area
    .purgem zstrip_triangle_box
  )");
}

#endif

}  // namespace zstrip::detail
