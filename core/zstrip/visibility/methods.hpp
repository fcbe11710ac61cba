// The visibility methods, as an application selects them.
#pragma once

#include "zstrip/effects.hpp"

namespace zstrip {

// Named like the options on the command line. NOLINTBEGIN(readability-identifier-naming)
/// Ways to find visible surfaces other than a plain z-buffer; docs/visibility.md compares them. effects_of never
/// returns them. They keep depth as z16; refused_by_methods lists the effects of scenes that each method cannot draw.
namespace method {
/// Draws triangles from far to near, without depth memory. Wrong where no order of triangles is right. Needs
/// Purpose::sorting.
inline constexpr Effects painter{0, 1U << 0};
/// Draws triangles from near to far with the z-buffer, so that few pixels are written twice. Needs Purpose::sorting.
inline constexpr Effects front_to_back{0, 1U << 1};
/// Keeps farthest depths of 8x8 tiles and a pyramid above them, to skip hidden instances, meshlets, triangles and runs
/// of pixels. Draws the same pixels as the z-buffer. Needs Purpose::depth_bounds.
inline constexpr Effects hierarchical_z{0, 1U << 2};
/// Splits triangles at their centroids, and draws or rejects the pieces by samples. Some pixels are wrong by design.
inline constexpr Effects midpoint{0, 1U << 3};
/// Splits as midpoint does, but confirms samples by bounds of tiles, or tests pixels. Draws the same pixels as the
/// z-buffer. Needs Purpose::depth_bounds.
inline constexpr Effects midpoint_safe{0, 1U << 4};
/// With the painter: draws triangles in the scene's own order, which the caller has sorted. Needs no memory.
inline constexpr Effects in_order{0, 1U << 5};
/// With the painter: draws triangles in the order of a baked tree, VisibilityOptions::tree.
inline constexpr Effects bsp{0, 1U << 6};
/// Culls as set in VisibilityOptions, and counts. Can be combined with every method, or used alone with the z-buffer.
inline constexpr Effects culling{0, 1U << 7};

inline constexpr Effects sorted{0, painter.methods | front_to_back.methods};
inline constexpr Effects bounded{0, hierarchical_z.methods | midpoint_safe.methods};  ///< methods that keep bounds of
                                                                                      ///< tiles
inline constexpr Effects splitting{0, midpoint.methods | midpoint_safe.methods};
inline constexpr Effects orders{0, in_order.methods | bsp.methods};  ///< methods that replace the painter's key
inline constexpr Effects own{0, (1U << 7) - 1};
inline constexpr Effects any{0, own.methods | culling.methods};
}  // namespace method
// NOLINTEND(readability-identifier-naming)

/// True if a frame begins with a sorted list of its triangles, in Purpose::sorting.
constexpr bool sorts_triangles(Effects effects) {
  return effects.any(method::sorted) && !effects.has(method::in_order);
}

}  // namespace zstrip
