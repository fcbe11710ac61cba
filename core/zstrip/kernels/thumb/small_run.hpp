// Draws runs of small triangles with interpolated colours, from indices to pixels, in assembly for Cortex-M.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/pixels/small_scan.hpp"
#include "zstrip/pixels/target.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace zstrip::detail {

/// Values that the triangles of a meshlet share. The assembly depends on the order of the members.
struct ThumbSmallRun {
  SmallScan scan;           ///< scan of the current triangle
  std::uintptr_t vertices;  ///< the address of the mesh's vertex 0, although the cache holds only a run of vertices
  std::uintptr_t colours;   ///< the address of the colour of vertex 0
  Rect area;
  std::uint16_t* depth;  ///< the cell of the area's upper left corner
  std::uint16_t* colour;
  const StripTarget* strip;

  /// `vertices` and `colours` begin with mesh vertex `first_vertex`.
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

/// Culls and draws triangles of one-sided surfaces with narrow vertices, with the depth test of z16, without counting.
/// Stops at the first triangle that is neither small nor medium, and returns the number of triangles before it.
std::uint32_t draw_small_run_thumb(ThumbSmallRun& run, const Triangle* triangles, std::uint32_t count);

/// Draws a triangle that is not small, with the area and the colours of the run's scan. Returns false if it is not a
/// medium one either. The assembly calls it by name.
bool draw_medium_of_run(const ThumbSmallRun& run, const SnappedVertex& v0, const SnappedVertex& v1,
                        const SnappedVertex& v2) asm("zstrip_draw_medium_of_run");

}  // namespace zstrip::detail
