// The options of visibility methods, and the figures that they count.
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/scene/bsp_tree.hpp"

namespace zstrip {

/// The depth of a triangle by which painter and front_to_back sort: one number, so that some order is always wrong.
enum class SortKey : std::uint8_t {
  middle,    ///< halfway between its nearest and its farthest vertex
  nearest,   ///< its nearest vertex
  farthest,  ///< its farthest vertex
};

/// Set before begin_frame; what it points to must live until the last draw_strip.
struct VisibilityOptions {
  /// Levels of splitting of the midpoint methods, 0..kMaxIterations; more count as that.
  std::uint8_t iterations = 2;
  SortKey key = SortKey::middle;  ///< of painter and front_to_back
  /// The next three only with method::culling; without it back faces and small triangles are culled, spheres are not
  /// used.
  bool cull_back_faces = true;
  bool cull_small = true;        ///< triangles whose box has no pixel centre
  bool cull_by_spheres = false;  ///< meshlets whose bounding sphere, Meshlet::centre and radius, is outside the picture
  /// With method::culling: a bit for each meshlet of all instances in drawing order, 1 if it may be seen from where the
  /// camera is; meshlets beyond the last word are drawn. Empty: all are.
  std::span<const std::uint32_t> potentially_visible{};
  /// With method::culling and hierarchical_z, of streamed plans: two halves of a bit a meshlet likewise, seen_words(n)
  /// in all, kept from frame to frame by the caller. draw_strip sets bits of the second half, for meshlets that no
  /// bound hides; begin_frame makes it the first half. Those of the first half are drawn first, so that the others find
  /// a z-buffer to be hidden by (temporal coherence). Any contents are right.
  std::span<std::uint32_t> seen_before{};
  /// With method::bsp: the tree of the scene's only instance; its transform is a rotation, a uniform scale and a
  /// translation.
  const BspTree* tree = nullptr;
  /// Null, or where draw_strip counts how often each pixel of Frame::depth_area() is written, up to 255: row by row,
  /// one byte a pixel of a whole strip. Only with effect::statistics.
  std::uint8_t* overdraw = nullptr;
};

inline constexpr std::uint8_t kMaxIterations = 6;  ///< of VisibilityOptions::iterations

/// Words of VisibilityOptions::seen_before for so many meshlets, SceneCounts::meshlets.
constexpr std::uint32_t seen_words(std::uint32_t meshlets) { return (meshlets + 31) / 32 * 2; }

/// Counted by renderers with effect::statistics and a method, from begin_frame on.
struct VisibilityStatistics {
  std::uint32_t comparisons = 0;  ///< of a depth with a cell of the z-buffer or with a bound of a tile or node
  std::uint32_t cells_read = 0;   ///< besides, to find the farthest depth of tiles
  std::uint32_t writes = 0;       ///< pixels written, each time
  std::uint32_t instances = 0;    ///< hidden as a whole, in a strip
  std::uint32_t meshlets = 0;     ///< likewise
  std::uint32_t drawn_first = 0;  ///< meshlets in strips, because they were seen before
  std::uint32_t triangles = 0;    ///< hidden as a whole, in a strip
  std::uint32_t run_pixels = 0;   ///< pixels in runs that a tile hides
  std::uint32_t splits = 0;       ///< triangles or pieces that were split
  std::uint32_t untested = 0;     ///< pixels drawn without a test
  std::uint32_t back_faces = 0;   ///< of the whole frame; the next four with method::culling only, 0 where switched off
  std::uint32_t small = 0;        ///< front faces without a pixel centre
  std::uint32_t outside = 0;      ///< triangles of meshlets outside the picture by their spheres
  std::uint32_t outside_cells = 0;  ///< triangles of meshlets that the visible set leaves out
};

}  // namespace zstrip
