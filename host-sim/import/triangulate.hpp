// Cuts polygons into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "motion/affine.hpp"

namespace zstrip::sim {

/// Limit for a polygon's corners: the time grows with their square.
inline constexpr std::size_t kMaxCorners = 5'000;

/// Returns corners of the polygon, three a triangle, with its winding. A polygon may be concave; one that crosses
/// itself is cut in some way. At most kMaxCorners corners, all finite.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vector> polygon);

}  // namespace zstrip::sim
