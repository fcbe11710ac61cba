// The memory of visibility methods in the arena: sorted triangles, and bounds of the depth of tiles.
#pragma once

#include <cstdint>

#include "zstrip/effects.hpp"
#include "zstrip/status.hpp"
#include "zstrip/visibility/methods.hpp"

namespace zstrip {

inline constexpr std::uint32_t kSortedTriangleBytes = 16;  // its place in the order, and its indices
inline constexpr std::uint32_t kDepthTileBytes = 6;        // nearest and farthest code of 8x8 cells, and the number of
                                                           // pending cells
inline constexpr std::uint32_t kDepthNodeBytes = 2;        // farthest code of 2x2 tiles or nodes
inline constexpr std::uint32_t kDepthTileShift = 3;
/// The greatest index of a triangle, meshlet or instance that can be sorted.
inline constexpr std::uint32_t kMaxSortedIndex = 0xFFFF;

namespace detail {

/// Returns the bytes for the tiles of a strip's z-buffer and the pyramid above them, up to a single node.
constexpr std::uint64_t depth_bounds_bytes(std::uint32_t columns, std::uint32_t rows) {
  std::uint64_t across = (columns + 7U) >> kDepthTileShift;
  std::uint64_t down = (rows + 7U) >> kDepthTileShift;
  std::uint64_t bytes = across * down * kDepthTileBytes;
  while (across > 1 || down > 1) {
    across = (across + 1) / 2;
    down = (down + 1) / 2;
    bytes += across * down * kDepthNodeBytes;
  }
  return bytes;
}

/// Returns the bytes of a method before rounding to the arena's alignment. `triangles` of the whole scene, columns and
/// rows of a strip.
constexpr std::uint64_t visibility_bytes(Effects effects, std::uint32_t triangles, std::uint32_t columns,
                                         std::uint32_t rows) {
  std::uint64_t bytes = 0;
  if (sorts_triangles(effects)) bytes += std::uint64_t{triangles} * kSortedTriangleBytes;
  if (effects.any(method::bounded)) bytes += depth_bounds_bytes(columns, rows);
  return bytes;
}

/// Returns the purpose of these bytes for errors and reports.
constexpr Purpose visibility_purpose(Effects effects) {
  return sorts_triangles(effects) ? Purpose::sorting : Purpose::depth_bounds;
}

/// Returns the bytes of a cell of the z-buffer; 0 for the painter, which has no z-buffer.
constexpr std::uint32_t depth_cell_bytes(Effects effects) {
  return effects.has(method::painter) ? 0 : depth_bytes(depth_format(effects));
}

}  // namespace detail
}  // namespace zstrip
