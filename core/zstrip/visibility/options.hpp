// The options of visibility methods, and their statistics.
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/scene/bsp_tree.hpp"

namespace zstrip {

/// The depth by which painter and front_to_back sort a triangle. It is one number, so that every key gives a wrong
/// order for some triangles.
enum class SortKey : std::uint8_t {
  middle,  ///< halfway between its nearest and its farthest vertex
  nearest,
  farthest,
};

/// Set before begin_frame. All memory that it refers to must live until the last draw_strip.
struct VisibilityOptions {
  /// Levels of splitting of the midpoint methods, 0..kMaxIterations; greater values count as kMaxIterations.
  std::uint8_t iterations = 2;
  SortKey key = SortKey::middle;  ///< sort key of painter and front_to_back
  /// The next three options need method::culling. Without it back faces and small triangles are culled, and spheres are
  /// not used.
  bool cull_back_faces = true;
  bool cull_small = true;        ///< triangles whose box has no pixel centre
  bool cull_by_spheres = false;  ///< meshlets whose bounding sphere, Meshlet::centre and radius, is outside the picture
  /// With method::culling: one bit for each meshlet of all instances in drawing order, 1 if it may be visible from the
  /// camera's position. Meshlets after the last word are drawn. Empty: all are drawn.
  std::span<const std::uint32_t> potentially_visible{};
  /// With method::culling and hierarchical_z, in streamed plans: two sets of one bit a meshlet, seen_words(n) words in
  /// all, which the caller keeps from frame to frame. draw_strip sets bits of the second set for meshlets that no bound
  /// hides; begin_frame makes it the first set. Meshlets of the first set are drawn first, so that their depth hides
  /// others (temporal coherence). Any contents give the right picture.
  std::span<std::uint32_t> seen_before{};
  /// With method::bsp: the tree of the scene's only instance; its transform is a rotation, a uniform scale and a
  /// translation.
  const BspTree* tree = nullptr;
  /// Null, or the memory in which draw_strip counts how often each pixel of Frame::depth_area() is written, up to 255:
  /// row by row, one byte for each pixel of a whole strip. Needs effect::statistics.
  std::uint8_t* overdraw = nullptr;
};

inline constexpr std::uint8_t kMaxIterations = 6;  ///< maximum of VisibilityOptions::iterations

/// Returns the words of VisibilityOptions::seen_before for SceneCounts::meshlets.
constexpr std::uint32_t seen_words(std::uint32_t meshlets) { return (meshlets + 31) / 32 * 2; }

/// The counts of renderers with effect::statistics and a method, from begin_frame on.
struct VisibilityStatistics {
  std::uint32_t comparisons = 0;  ///< comparisons of a depth with a cell of the z-buffer, or with a bound of a tile or
                                  ///< node
  std::uint32_t cells_read = 0;   ///< further cells read to find the farthest depth of tiles
  std::uint32_t writes = 0;       ///< pixels written; each write counts
  std::uint32_t instances = 0;    ///< completely hidden in a strip
  std::uint32_t meshlets = 0;     ///< completely hidden in a strip
  std::uint32_t drawn_first = 0;  ///< meshlets that were drawn first in a strip, because they were visible before
  std::uint32_t triangles = 0;    ///< completely hidden in a strip
  std::uint32_t run_pixels = 0;   ///< pixels of runs that a tile hides
  std::uint32_t splits = 0;       ///< triangles or pieces that were split
  std::uint32_t untested = 0;     ///< pixels drawn without a test
  std::uint32_t back_faces = 0;   ///< in the whole frame; this and the next three need method::culling, and are 0 for
                                  ///< tests that are disabled
  std::uint32_t small = 0;        ///< front faces without a pixel centre
  std::uint32_t outside = 0;      ///< triangles of meshlets whose spheres are outside the picture
  std::uint32_t outside_cells = 0;  ///< triangles of meshlets that the visible set does not contain
};

}  // namespace zstrip
