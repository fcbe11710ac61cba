// The bounding sphere of a meshlet whose vertices were moved.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "zstrip/base/unit_vector.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// Sets the meshlet's sphere, for a mesh whose half extents are equal: its centre is that of the bounding box of the
/// vertices, its radius reaches all of them.
inline void bound(Meshlet& meshlet, std::span<const Position> positions) {
  std::int32_t low[3] = {32767, 32767, 32767}, high[3] = {-32768, -32768, -32768};
  const std::span vertices = positions.subspan(meshlet.first_vertex, meshlet.vertex_count);
  for (const Position& p : vertices) {
    const std::int32_t place[3] = {p.x, p.y, p.z};
    for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], place[i]), high[i] = std::max(high[i], place[i]);
  }
  const auto middle = [&](int i) { return static_cast<std::int16_t>((low[i] + high[i]) >> 1); };
  meshlet.centre = {middle(0), middle(1), middle(2)};
  std::uint32_t farthest = 0;  // a square: at most three of 2^30
  for (const Position& p : vertices) {
    const std::int32_t x = p.x - meshlet.centre.x, y = p.y - meshlet.centre.y, z = p.z - meshlet.centre.z;
    farthest = std::max(farthest, static_cast<std::uint32_t>(x * x) + static_cast<std::uint32_t>(y * y) +
                                      static_cast<std::uint32_t>(z * z));
  }
  const std::uint32_t root = root_of_word(farthest);
  meshlet.radius = static_cast<std::uint16_t>(root * root == farthest ? root : root + 1);
}

}  // namespace zstrip::detail
