// Potentially visible sets: for each cell of a grid, the meshlets that may be seen from somewhere in it. Baked on the
// host (`zstrip bake --visible-sets`), read in place; docs/formats.md says what each byte means.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/base/fixed.hpp"
#include "zstrip/base/status.hpp"

namespace zstrip {

inline constexpr std::uint8_t kVisibleSetsVersion = 1;
inline constexpr std::uint32_t kVisibleSetsAlignment = 4;  ///< of the first byte

/// Views of bytes that must stay alive and unchanged.
struct VisibleSets {
  Vec3 origin{0, 0, 0};                          ///< 16.16, world: the corner of least x, y and z
  Vec3 cell{1, 1, 1};                            ///< 16.16, > 0: the size of a cell
  std::uint16_t across = 0, up = 0, deep = 0;    ///< cells along x, y and z
  std::uint32_t meshlets = 0;                    ///< of all instances
  Fixed near_plane = 0;                          ///< 16.16: cameras with a nearer one may see more
  std::uint32_t scene_checksum = 0;              ///< of the scene that they were baked for
  std::span<const std::uint16_t> set_of_cell{};  ///< x first, then y, then z
  std::span<const std::uint32_t> sets{};         ///< (meshlets + 31) / 32 words each

  /// For VisibilityOptions::potentially_visible of a perspective camera with this eye. Empty, so that all is drawn,
  /// where the eye is in no cell.
  std::span<const std::uint32_t> at(const Vec3& eye) const;
};

/// Checks all of `bytes` and makes `opened` a view of them; on an error it stays as it was. Any bytes are safe.
/// `meshlets`: those of the scene, SceneCounts::meshlets. Errors: blob_alignment; blob_version (`needed`: its version,
/// `available`: the one that is read); blob_damaged (`needed`: the byte that is wrong, 16 if it is for another number
/// of meshlets, that after the last one if some are missing).
Status open_visible_sets(std::span<const std::byte> bytes, std::uint32_t meshlets, VisibleSets& opened);

namespace detail {

/// The bytes: words of 32 bits, little endian. Cells of the table have 16 bits, filled up to a whole word.
namespace visible_sets_at {
inline constexpr std::uint32_t kSize = 4, kChecksum = 8, kChecked = 12;  // of all bytes from kChecked on
inline constexpr std::uint32_t kScene = 12, kMeshlets = 16, kOrigin = 20, kCell = 32, kCounts = 44, kSets = 50;
inline constexpr std::uint32_t kNear = 52, kCells = 56;
}  // namespace visible_sets_at
inline constexpr std::byte kVisibleSetsMark[] = {std::byte{'z'}, std::byte{'s'}, std::byte{kVisibleSetsVersion},
                                                 std::byte{'v'}};

}  // namespace detail
}  // namespace zstrip
