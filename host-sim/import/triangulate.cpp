// Cuts polygons into triangles, ear by ear.
#include "import/triangulate.hpp"

#include <cmath>
#include <numeric>

namespace zstrip::sim {
namespace {

Vector from_to(const Vector& a, const Vector& b) { return {b[0] - a[0], b[1] - a[1], b[2] - a[2]}; }

/// Returns twice the area of the polygon as a vector along its normal.
Vector area_of(std::span<const Vector> polygon) {
  Vector sum{};
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vector part = vector_product(from_to(polygon[0], polygon[i]), from_to(polygon[0], polygon[i + 1]));
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += part[axis];
  }
  return sum;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vector> polygon) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const Vector normal = area_of(polygon);
  // Positive where the path from a over b to c turns to the left.
  const auto side = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Vector area = vector_product(from_to(polygon[a], polygon[b]), from_to(polygon[a], polygon[c]));
    return area[0] * normal[0] + area[1] * normal[1] + area[2] * normal[2];
  };
  std::vector<std::uint32_t> left(polygon.size());
  std::iota(left.begin(), left.end(), 0U);
  const auto is_ear = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (!(side(a, b, c) > 0)) return false;
    for (const std::uint32_t p : left) {
      if (p == a || p == b || p == c) continue;
      if (side(a, b, p) >= 0 && side(b, c, p) >= 0 && side(c, a, p) >= 0) return false;
    }
    return true;
  };
  std::size_t at = 0, tried = 0;
  while (left.size() > 3) {
    const std::size_t count = left.size();
    const std::size_t before = (at + count - 1) % count, after = (at + 1) % count;
    // A polygon without an ear crosses itself or has no area: any corner is cut off.
    if (tried >= count || is_ear(left[before], left[at], left[after])) {
      triangles.push_back({left[before], left[at], left[after]});
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
      tried = 0;
      at = at % left.size();
    } else {
      ++tried;
      at = after;
    }
  }
  if (left.size() == 3) triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

}  // namespace zstrip::sim
