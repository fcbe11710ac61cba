// Potentially visible sets: which meshlets no eye in a cell can see, because walls are between (Airey, Rohlf and
// Brooks, "Towards image realism with interactive update rates in complex building environments", 1990).
//
// A meshlet is left out if one plane of opaque triangles hides its box from the whole cell: the crossing of the plane
// with any segment from a convex cell to a convex box lies in the convex hull of the crossings of the segments between
// their corners, so that it is enough if the triangles cover that hull. Nothing is sampled. The hull is widened by what
// snapping moves edges, and what is not farther behind than two codes of depth is kept: both would show in a z-buffer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "result.hpp"
#include "zstrip/animation.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Cells along each axis, 1 to kMaxCells together.
struct CellCounts {
  std::uint16_t across = 8, up = 2, deep = 8;
};
inline constexpr std::uint32_t kMaxCells = 4096;

/// "8x2x8", or a usage error that names `option`.
Result<CellCounts> parse_cells(const std::string& text, const char* option);

struct BakedVisibleSets {
  std::vector<std::uint32_t> words;  ///< the bytes that open_visible_sets takes
  std::uint32_t meshlets = 0, cells = 0, sets = 0;
  double hidden = 0;  ///< share of all pairs of cell and meshlet that are left out

  std::span<const std::byte> bytes() const { return std::as_bytes(std::span(words)); }
};

/// For every perspective camera whose near plane is not nearer than this one's and no more than 60 degrees of whose
/// view are to any side of its axis. The grid is the bounding box of the instances that stand still. What moves is
/// always in the set and hides nothing. Usage errors: an orthographic camera, a scene without an instance that stands
/// still.
Result<BakedVisibleSets> bake_visible_sets(const Scene& scene, const Camera& camera, const Animation& animation,
                                           const CellCounts& cells);

/// Of meshes, materials and of the instances that stand still: what sets depend on.
std::uint32_t visibility_checksum(const Scene& scene, const Animation& animation);

}  // namespace zstrip::sim
