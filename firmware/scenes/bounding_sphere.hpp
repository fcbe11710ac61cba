// Computes the bounds of a meshlet at compile time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "zstrip/scene.hpp"
#include "zstrip_scenes/compile_time.hpp"

namespace zstrip::scenes {

struct BoundingSphere {
  Position centre;
  std::uint16_t radius;  ///< in grid steps of the largest half extent, rounded up
};

/// Returns the sphere around the centre of the box of these positions; at least one position.
consteval BoundingSphere bounding_sphere(std::span<const Position> positions, const Vec3& half_extent) {
  std::int32_t low[3] = {32767, 32767, 32767}, high[3] = {-32767, -32767, -32767};
  for (const Position& p : positions) {
    const std::int32_t values[3] = {p.x, p.y, p.z};
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], values[axis]);
      high[axis] = std::max(high[axis], values[axis]);
    }
  }
  std::int32_t middle[3] = {};
  for (int axis = 0; axis < 3; ++axis) middle[axis] = (low[axis] + high[axis]) >> 1;

  const double unit = std::max({half_extent.x, half_extent.y, half_extent.z});
  double farthest = 0;  // squared
  for (const Position& p : positions) {
    const double x = (p.x - middle[0]) * (half_extent.x / unit);
    const double y = (p.y - middle[1]) * (half_extent.y / unit);
    const double z = (p.z - middle[2]) * (half_extent.z / unit);
    farthest = std::max(farthest, x * x + y * y + z * z);
  }
  return {{static_cast<std::int16_t>(middle[0]), static_cast<std::int16_t>(middle[1]),
           static_cast<std::int16_t>(middle[2])},
          static_cast<std::uint16_t>(compile_time::square_root(farthest) + 1)};
}

}  // namespace zstrip::scenes
