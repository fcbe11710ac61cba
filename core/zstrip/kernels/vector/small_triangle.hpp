// Small triangles, and runs of them, in vectors, with the depth test of z16.
#pragma once

#include <cstdint>

#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/processor.hpp"
#include "zstrip/raster/target.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// What draw_small_triangle takes.
struct SmallTriangle {
  const StripTarget& target;
  const SnappedVertex &v0, &v1, &v2;
  std::int32_t area;
  std::int32_t anchor_x, anchor_y;
  const Rect& box;
};

/// False, and nothing drawn, if there is no room for whole blocks of 4 x 2 pixels in the strip.
bool draw_small_flat_vector(const SmallTriangle& triangle, std::uint16_t colour);
/// The same with interpolated colours.
bool draw_small_gouraud_vector(const SmallTriangle& triangle, const Colour* const (&colours)[3]);

/// Culls and draws triangles of one-sided surfaces with interpolated colours, whose vertices are narrow. Stops at the
/// first that is not small, or has no room; how many triangles come before it. `vertices` and `colours` are those of
/// mesh vertex `first_vertex` on.
std::uint32_t draw_small_run_vector(const StripTarget& target, const SnappedVertex* vertices, const Colour* colours,
                                    std::uint32_t first_vertex, const Triangle* triangles, std::uint32_t count);

}  // namespace zstrip::detail
