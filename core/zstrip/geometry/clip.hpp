// Clipping in homogeneous coordinates, before the division: near plane, far plane, guard band.
#pragma once

#include <cstdint>

#include "zstrip/geometry/project.hpp"

namespace zstrip::detail {

/// Extra fraction bits of clipped coordinates: a clipped edge ends where w is small, so that the bits of the linear
/// forms are not enough.
inline constexpr int kClipBits = 16;

/// A vertex before projection, with all values that vary over a triangle.
struct ClipVertex {
  std::int64_t x, y, w;  ///< the instance's linear forms, times 2^kClipBits; below 2^46
  std::int32_t r, g, b;  ///< 8.16
  std::int32_t u, v;     ///< texels, 16.16
};

/// Three corners and one vertex for each of the six planes.
inline constexpr int kMaxPolygon = 9;

/// The vertices, and room in which clipping moves them to the end, with the first one repeated after the last. Of nine
/// vertices, the i-th is read at 4 + i; before that, at most 2 i are written, and none from kMaxPolygon on.
struct ClipPolygon {
  ClipVertex vertices[kMaxPolygon + 5];
  int count;  ///< at most kMaxPolygon
};

/// Clips `polygon` (initially a triangle) in place; count 0 if nothing is left. Two polygons that share an edge get the
/// same new vertex on it, whatever the edge's direction. A segment is clipped as a polygon of two vertices: the first
/// two vertices of the result are its ends, in their order; the others repeat them.
void clip_perspective(ClipPolygon& polygon, const CompiledInstance& instance);
void clip_orthographic(ClipPolygon& polygon, const CompiledInstance& instance);

/// Returns 1 / w from all bits of w; leading zeros are counted as for w without the extra fraction.
constexpr Reciprocal reciprocal_of_wide(std::int64_t w) {
  const auto bits = static_cast<std::uint64_t>(w);
  const int zeros = std::countl_zero(bits);
  return {reciprocal(static_cast<std::uint32_t>((bits << zeros) >> 32)), zeros - (32 - kClipBits)};
}

/// x, y and depth of a vertex inside the clip volume. Same bits as from project_narrow, if both accept it.
struct WidePosition {
  std::int32_t x, y;
  std::uint32_t depth;
};
template <bool orthographic>
WidePosition project_wide(const CompiledInstance& instance, const RasterOrigin& origin, const ClipVertex& vertex);

/// Returns the depth in a format other than z16.
template <bool orthographic, DepthFormat format>
std::uint32_t project_wide_depth(const CompiledInstance& instance, const RasterOrigin& origin,
                                 const ClipVertex& vertex) {
  const Reciprocal r = orthographic ? Reciprocal{0, 0} : reciprocal_of_wide(vertex.w);
  return project_depth<orthographic, format>(instance, origin, static_cast<std::int32_t>(vertex.w >> kClipBits), r);
}

}  // namespace zstrip::detail
