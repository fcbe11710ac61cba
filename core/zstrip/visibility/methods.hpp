// The visibility methods, by which an application calls them.
#pragma once

#include "zstrip/effects.hpp"

namespace zstrip {

// Named as options name them.
// NOLINTBEGIN(readability-identifier-naming)
/// Ways to find what is visible other than a plain z-buffer; docs/visibility.md compares them. Never called for by a
/// scene. They keep depth as z16; refused_by_methods has the effects of scenes that each cannot draw.
namespace method {
/// Triangles from far to near, without depth memory: wrong where no order is right. Takes Purpose::sorting.
inline constexpr Effects painter{0, 1U << 0};
/// Triangles from near to far, and the z-buffer: few pixels are written twice. Takes Purpose::sorting.
inline constexpr Effects front_to_back{0, 1U << 1};
/// Farthest depths of 8x8 tiles and a pyramid above them, by which instances, meshlets, triangles and runs of pixels
/// are skipped that are hidden: the z-buffer's pixels. Takes Purpose::depth_bounds.
inline constexpr Effects hierarchical_z{0, 1U << 2};
/// Triangles are split at their centroids, and drawn or rejected by samples: wrong pixels are part of it.
inline constexpr Effects midpoint{0, 1U << 3};
/// Splits as midpoint does, but confirms samples by bounds of tiles, or tests pixels: the z-buffer's pixels. Takes
/// Purpose::depth_bounds.
inline constexpr Effects midpoint_safe{0, 1U << 4};
/// With the painter: triangles in the scene's own order, which the caller has sorted. Takes no memory.
inline constexpr Effects in_order{0, 1U << 5};
/// With the painter: the order of a tree that was baked, VisibilityOptions::tree.
inline constexpr Effects bsp{0, 1U << 6};
/// Culling as set in VisibilityOptions, and counted. Goes with every method, and alone with the z-buffer.
inline constexpr Effects culling{0, 1U << 7};

inline constexpr Effects sorted{0, painter.methods | front_to_back.methods};          ///< any of these sorts
inline constexpr Effects bounded{0, hierarchical_z.methods | midpoint_safe.methods};  ///< any keeps bounds of tiles
inline constexpr Effects splitting{0, midpoint.methods | midpoint_safe.methods};      ///< any splits at centroids
inline constexpr Effects orders{0, in_order.methods | bsp.methods};  ///< any replaces the painter's key
inline constexpr Effects own{0, (1U << 7) - 1};                      ///< all but culling: other ways to see
inline constexpr Effects any{0, own.methods | culling.methods};      ///< all
}  // namespace method
// NOLINTEND(readability-identifier-naming)

/// True if a frame begins with a list of its triangles in order, in Purpose::sorting.
constexpr bool sorts_triangles(Effects effects) {
  return effects.any(method::sorted) && !effects.has(method::in_order);
}

}  // namespace zstrip
