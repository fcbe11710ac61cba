// Draws small triangles, and runs of them, in vectors, with the depth test of z16.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/pixels/target.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

struct SmallTriangle {
  const StripTarget& target;
  const SnappedVertex &v0, &v1, &v2;
  std::int32_t area;
  std::int32_t anchor_x, anchor_y;
  const Rect& box;
};

/// Returns false, and draws nothing, if the strip has no room for whole blocks of 4 x 2 pixels.
bool draw_small_flat_vector(const SmallTriangle& triangle, std::uint16_t colour);
bool draw_small_gouraud_vector(const SmallTriangle& triangle, const Colour* const (&colours)[3]);

/// The look of a run's triangles, except for their vertices.
struct SmallRunSurface {
  bool flat = false, double_sided = false;
  std::uint16_t flat_colour = 0;  ///< colour of flat triangles without vertex colours
};

/// Values that the triangles of a meshlet share.
struct VectorSmallRun {
  const StripTarget& target;
  const SnappedVertex* vertices;  ///< begin with mesh vertex `first_vertex`
  const Colour* colours;          ///< begin with the same vertex; null: flat_colour
  std::uint32_t first_vertex;
  SmallRunSurface surface = {};
};

/// Culls and draws triangles with narrow vertices. Stops at the first triangle that is neither small nor medium, or for
/// which blocks have no room, and returns the number of triangles before it.
std::uint32_t draw_small_run_vector(const VectorSmallRun& run, const Triangle* triangles, std::uint32_t count);

}  // namespace zstrip::detail
