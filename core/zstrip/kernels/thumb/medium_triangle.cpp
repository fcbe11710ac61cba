// What the assembly for runs of small triangles calls for one that is not small.
#include "zstrip/kernels/thumb/medium_triangle.hpp"

#include "zstrip/kernels/medium_triangle.hpp"
#include "zstrip/kernels/thumb/small_run.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1 || ZSTRIP_HAS_THUMB2

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

#endif

}  // namespace zstrip::detail
