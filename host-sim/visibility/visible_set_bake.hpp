// Potentially visible sets: the meshlets that no eye in a cell can see, because walls are between (Airey, Rohlf and
// Brooks, "Towards image realism with interactive update rates in complex building environments", 1990).
//
// A meshlet is left out if one plane of opaque triangles hides its box from the whole cell. The crossing of the plane
// with any segment from a convex cell to a convex box lies in the convex hull of the crossings of the segments between
// their corners. So it is enough if the triangles cover that hull. The test is exact, without sampling. The hull is
// widened by the distance that snapping moves edges, and meshlets that are less than two codes of depth behind the
// plane are kept: both would be visible in a z-buffer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "result.hpp"
#include "zstrip/animation.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// The cells along each axis; 1 to kMaxCells in total.
struct CellCounts {
  std::uint16_t across = 8, up = 2, deep = 8;
};
inline constexpr std::uint32_t kMaxCells = 4096;

/// Parses "8x2x8"; the usage error names `option`.
Result<CellCounts> parse_cells(const std::string& text, const char* option);

struct BakedVisibleSets {
  std::vector<std::uint32_t> words;  ///< the bytes for open_visible_sets
  std::uint32_t meshlets = 0, cells = 0, sets = 0;
  double hidden = 0;  ///< share of all pairs of cell and meshlet that are left out

  std::span<const std::byte> bytes() const { return std::as_bytes(std::span(words)); }
};

/// For every perspective camera whose near plane is at least as far away as this one's, and whose view is at most 60
/// degrees to any side of its axis. The grid is the bounding box of the instances that do not move. Moving instances
/// are always in the set and hide nothing. Usage errors: an orthographic camera, a scene in which all instances move.
Result<BakedVisibleSets> bake_visible_sets(const Scene& scene, const Camera& camera, const Animation& animation,
                                           const CellCounts& cells);

/// Returns a checksum of all data that sets depend on: meshes, materials and the instances that do not move.
std::uint32_t visibility_checksum(const Scene& scene, const Animation& animation);

}  // namespace zstrip::sim
