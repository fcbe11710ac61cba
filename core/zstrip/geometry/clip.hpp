// Clipping in homogeneous coordinates, before the division: near plane, far plane, guard band.
#pragma once

#include <cstdint>

#include "zstrip/geometry/project.hpp"

namespace zstrip::detail {

/// A clipped edge ends where w is small: its coordinates carry 16 more fraction bits than the linear forms.
inline constexpr int kClipBits = 16;

/// A vertex before projection, with everything that varies over a triangle.
struct ClipVertex {
  std::int64_t x, y, w;  ///< the instance's linear forms, times 2^kClipBits; below 2^46
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

/// x, y and depth of a vertex inside the clip volume; the same bits as project_narrow for a vertex that both accept.
struct WidePosition {
  std::int32_t x, y;
  std::uint32_t depth;
};
template <bool orthographic>
WidePosition project_wide(const CompiledInstance& instance, const RasterOrigin& origin, const ClipVertex& vertex);

}  // namespace zstrip::detail
