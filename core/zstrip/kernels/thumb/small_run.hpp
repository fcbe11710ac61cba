// Runs of small triangles with interpolated colours, from indices to pixels, in assembly for Cortex-M.
#pragma once

#include <cstdint>

#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/small_scan.hpp"
#include "zstrip/raster/target.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace zstrip::detail {

/// Values that the triangles of a meshlet share, where the assembly expects them.
struct ThumbSmallRun {
  SmallScan scan;           ///< of the triangle at hand
  std::uintptr_t vertices;  ///< where the mesh's vertex 0 would be: the cache has a run of them
  std::uintptr_t colours;   ///< likewise
  Rect area;                ///< of the strip
  std::uint16_t* depth;     ///< the cell of the area's upper left corner
  std::uint16_t* colour;
  const StripTarget* strip;

  /// `vertices` and `colours` are those of mesh vertex `first_vertex` on.
  ThumbSmallRun(const StripTarget& target, const SnappedVertex* first_of_vertices, const Colour* first_of_colours,
                std::uint32_t first_vertex)
      : vertices(reinterpret_cast<std::uintptr_t>(first_of_vertices) - first_vertex * sizeof(SnappedVertex)),
        colours(reinterpret_cast<std::uintptr_t>(first_of_colours) - first_vertex * sizeof(Colour)),
        area(target.area),
        depth(target.depth),
        colour(target.colour),
        strip(&target) {
    scan.depth_stride = target.depth_stride;
    scan.colour_stride = target.colour_stride;
  }
};

/// Culls and draws triangles of one-sided surfaces whose vertices are narrow, with the depth test of z16 and nothing to
/// count. Stops at the first that is neither small nor medium; how many triangles come before it.
std::uint32_t draw_small_run_thumb(ThumbSmallRun& run, const Triangle* triangles, std::uint32_t count);

}  // namespace zstrip::detail
