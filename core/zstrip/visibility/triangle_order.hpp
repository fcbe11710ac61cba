// Sorts triangles for the painter and for front-to-back drawing.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "zstrip/geometry/extent.hpp"
#include "zstrip/visibility/memory.hpp"
#include "zstrip/visibility/options.hpp"

namespace zstrip::detail {

/// A front face that may be in the picture.
struct SortedTriangle {
  std::uint32_t key;       ///< the greatest is drawn first by front_to_back, last by the painter
  std::uint16_t instance;  ///< index into Scene::instances
  std::uint16_t meshlet;   ///< index into Mesh::meshlets
  std::uint16_t triangle;  ///< index into the meshlet's triangles
  std::uint16_t batch;     ///< the batch of its meshlet, if binned
  Extent extent;           ///< the strips that it touches
};
static_assert(sizeof(SortedTriangle) == kSortedTriangleBytes);

/// Returns the key for the depths of three vertices.
constexpr std::uint32_t depth_key(SortKey key, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const std::uint32_t farthest = std::min(std::min(a, b), c);
  const std::uint32_t nearest = std::max(std::max(a, b), c);
  switch (key) {
    case SortKey::nearest: return nearest;
    case SortKey::farthest: return farthest;
    case SortKey::middle: break;
  }
  return farthest + (nearest - farthest) / 2;
}

/// Sorts by descending key; with equal keys the first one in the scene comes first, because the z-buffer prefers it,
/// too. A heap sort, without recursion; it need not be stable, because the order is total.
inline void sort_near_to_far(std::span<SortedTriangle> triangles) {
  const auto before = [](const SortedTriangle& a, const SortedTriangle& b) {
    if (a.key != b.key) return a.key > b.key;
    if (a.instance != b.instance) return a.instance < b.instance;
    return a.meshlet != b.meshlet ? a.meshlet < b.meshlet : a.triangle < b.triangle;
  };
  std::make_heap(triangles.begin(), triangles.end(), before);
  std::sort_heap(triangles.begin(), triangles.end(), before);
}

}  // namespace zstrip::detail
