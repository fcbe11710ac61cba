// Kernel: draws runs of small triangles with interpolated colours, from their indices to depth and colour: culls them,
// computes their bounds, and draws them as small_triangle.hpp does. The surface is one-sided, and its vertices are
// narrow. Only for the depth test of z16, without counting. Vectors also draw runs of triangles with one colour,
// one-sided or two-sided.
//
// Vertices are 12.4 raster coordinates and 16.16 depth codes; the difference of two coordinates has at most 15 bits and
// a sign; colours are 8 bits a channel. Every implementation writes the same bits as portable/small_run.hpp.
#pragma once

#include <cstdint>
#include <type_traits>

#include "zstrip/base/processor.hpp"
#include "zstrip/kernels/mve/small_run.hpp"
#include "zstrip/kernels/portable/small_run.hpp"
#include "zstrip/kernels/thumb/small_run.hpp"
#include "zstrip/kernels/thumb2/listed_run.hpp"
#include "zstrip/kernels/vector/small_triangle.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// True if the processor has runs that are faster than a loop over draw_small_triangle; if even runs of one triangle
/// are; and if it has runs of triangles with one colour.
inline constexpr bool kHasSmallRuns = kHasThumb || kHasVectors;
inline constexpr bool kHasSmallRunsOfOne = kHasThumb;
inline constexpr bool kHasFlatSmallRuns = kHasVectors;
/// True if the processor has runs that follow the list of a strip.
inline constexpr bool kHasListedRuns = kHasThumb2 && !kForSize;

/// Values that the triangles of a meshlet share: the target, the vertices and colours, and the index of the first one.
using SmallRun =
    std::conditional_t<kHasThumb, ThumbSmallRun, std::conditional_t<kHasVectors, VectorSmallRun, PortableSmallRun>>;

/// `surface` is read only if kHasFlatSmallRuns.
template <class Run = SmallRun>
Run small_run(const StripTarget& target, const SnappedVertex* vertices, const Colour* colours,
              std::uint32_t first_vertex, [[maybe_unused]] const SmallRunSurface& surface) {
  if constexpr (kHasFlatSmallRuns) {
    return Run{target, vertices, colours, first_vertex, surface};
  } else {
    return Run{target, vertices, colours, first_vertex};
  }
}

/// Returns the processor's implementation.
constexpr auto chosen_small_run() {
  if constexpr (kHasMve) {
    return &draw_small_run_mve;
  } else if constexpr (kHasThumb) {
    return &draw_small_run_thumb;
  } else if constexpr (kHasVectors) {
    return &draw_small_run_vector;
  } else {
    return &draw_small_run_portable;
  }
}

/// Takes a SmallRun, triangles and `count`. Draws triangles up to the first one that is not small or that the
/// implementation does not support, at most `count`, and returns their number. A pointer, not a function, so that calls
/// go directly to the implementation.
inline constexpr auto draw_small_run = chosen_small_run();  // NOLINT(readability-identifier-naming)

}  // namespace zstrip::detail
