// Kernel: runs of small triangles with interpolated colours, from their indices to depth and colour, of a one-sided
// surface whose vertices are narrow: culled, bounded, drawn as by small_triangle.hpp. With the depth test of z16 and
// nothing to count. Vectors also have runs of triangles of one colour, of surfaces with one side or two.
//
// Vertices are 12.4 raster coordinates and 16.16 depth codes, no difference of two coordinates has more than 15 bits
// and a sign; colours are 8 bits a channel. Every implementation writes what portable/small_run.hpp writes, bit by bit.
#pragma once

#include <cstdint>
#include <type_traits>

#include "zstrip/kernels/portable/small_run.hpp"
#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/thumb/small_run.hpp"
#include "zstrip/kernels/thumb2/listed_run.hpp"
#include "zstrip/kernels/vector/small_triangle.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// True if the processor has runs that are quicker than a loop over draw_small_triangle; and even runs of one; and runs
/// of triangles of one colour.
inline constexpr bool kHasSmallRuns = kHasThumb || kHasVectors;
inline constexpr bool kHasSmallRunsOfOne = kHasThumb;
inline constexpr bool kHasFlatSmallRuns = kHasVectors;
/// True if it has runs that follow the list of a strip.
inline constexpr bool kHasListedRuns = kHasThumb2 && !kForSize;

/// Values that the triangles of a meshlet share, made of the target, its vertices and colours, and the first one's
/// index.
using SmallRun =
    std::conditional_t<kHasThumb, ThumbSmallRun, std::conditional_t<kHasVectors, VectorSmallRun, PortableSmallRun>>;

/// `surface` is read where kHasFlatSmallRuns.
template <class Run = SmallRun>
Run small_run(const StripTarget& target, const SnappedVertex* vertices, const Colour* colours,
              std::uint32_t first_vertex, [[maybe_unused]] const SmallRunSurface& surface) {
  if constexpr (kHasFlatSmallRuns) {
    return Run{target, vertices, colours, first_vertex, surface};
  } else {
    return Run{target, vertices, colours, first_vertex};
  }
}

/// The processor's implementation.
constexpr auto chosen_small_run() {
  if constexpr (kHasThumb) {
    return &draw_small_run_thumb;
  } else if constexpr (kHasVectors) {
    return &draw_small_run_vector;
  } else {
    return &draw_small_run_portable;
  }
}

/// Called with a SmallRun, triangles and `count`: draws `count` of them, or as many as come before one that is not
/// small, or that the implementation leaves to others; how many these are. No function of its own: the call is the
/// implementation's.
inline constexpr auto draw_small_run = chosen_small_run();  // NOLINT(readability-identifier-naming)

}  // namespace zstrip::detail
