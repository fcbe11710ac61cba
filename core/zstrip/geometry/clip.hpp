// Clipping in homogeneous coordinates, before the division: near plane, far plane, guard band.
#pragma once

#include <cstdint>

#include "zstrip/geometry/instance.hpp"

namespace zstrip::detail {

/// A vertex before projection, with everything that varies over a triangle.
struct ClipVertex {
  std::int32_t x, y, w;  ///< the instance's linear forms
  std::int32_t r, g, b;  ///< 8.16
  std::int32_t u, v;     ///< texels, 16.16
};

/// Three corners and one more for each of the six planes.
inline constexpr int kMaxPolygon = 9;

struct ClipPolygon {
  ClipVertex vertices[kMaxPolygon];
  int count;
};

/// Clips `polygon` (on entry a triangle) in place; count 0 if nothing is left. Two polygons that share an edge get the
/// same new vertex on it, whatever its direction.
void clip_perspective(ClipPolygon& polygon, const CompiledInstance& instance);
void clip_orthographic(ClipPolygon& polygon, const CompiledInstance& instance);

}  // namespace zstrip::detail
