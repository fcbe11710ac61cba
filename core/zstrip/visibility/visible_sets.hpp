// Potentially visible sets: for each cell of a grid, the meshlets that may be visible from some point in it. The host
// bakes them (`zstrip bake --visible-sets`), and they are read in place; docs/formats.md defines the format.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/base/crc32.hpp"
#include "zstrip/base/fixed.hpp"
#include "zstrip/status.hpp"

namespace zstrip {

inline constexpr std::uint8_t kVisibleSetsVersion = 1;     ///< the only version that is read
inline constexpr std::uint32_t kVisibleSetsAlignment = 4;  ///< bytes, for the first byte

/// Views of bytes that must stay alive and unchanged.
struct VisibleSets {
  Vec3 origin{0, 0, 0};                          ///< 16.16, world: the corner of least x, y and z
  Vec3 cell{1, 1, 1};                            ///< 16.16, > 0: the size of a cell
  std::uint16_t across = 0, up = 0, deep = 0;    ///< cells along x, y and z
  std::uint32_t meshlets = 0;                    ///< number of meshlets of all instances
  Fixed near_plane = 0;                          ///< 16.16; a camera with a nearer near plane may see more
  std::uint32_t scene_checksum = 0;              ///< checksum of the scene for which they were baked
  std::span<const std::uint16_t> set_of_cell{};  ///< x first, then y, then z
  std::span<const std::uint32_t> sets{};         ///< (meshlets + 31) / 32 words each

  /// Returns the set for VisibilityOptions::potentially_visible of a perspective camera with this eye. Empty if the eye
  /// is in no cell: then all meshlets are drawn.
  std::span<const std::uint32_t> at(const Vec3& eye) const;
};

namespace detail {

/// The offsets in the blob: words of 32 bits, little endian. Cells of the table have 16 bits; the table is filled up to
/// a whole word.
namespace visible_sets_at {
inline constexpr std::uint32_t kSize = 4, kChecksum = 8, kChecked = 12;  // of all bytes from kChecked on
inline constexpr std::uint32_t kScene = 12, kMeshlets = 16, kOrigin = 20, kCell = 32, kCounts = 44, kSets = 50;
inline constexpr std::uint32_t kNear = 52, kCells = 56;
}  // namespace visible_sets_at
inline constexpr std::byte kVisibleSetsMark[] = {std::byte{'z'}, std::byte{'s'}, std::byte{kVisibleSetsVersion},
                                                 std::byte{'v'}};

static_assert(std::endian::native == std::endian::little, "sets are little endian and used in place");

constexpr Status damaged_sets(std::size_t at) {
  return {.error = Error::blob_damaged, .needed = static_cast<std::uint32_t>(at)};
}

/// Reads a value from an aligned blob, which must be long enough.
template <class Value>
Value value_at(std::span<const std::byte> bytes, std::uint32_t at) {
  return *reinterpret_cast<const Value*>(bytes.data() + at);
}

inline Vec3 vector_at(std::span<const std::byte> bytes, std::uint32_t at) {
  return {value_at<Fixed>(bytes, at), value_at<Fixed>(bytes, at + 4), value_at<Fixed>(bytes, at + 8)};
}

}  // namespace detail

inline std::span<const std::uint32_t> VisibleSets::at(const Vec3& eye) const {
  const Fixed from[3] = {origin.x, origin.y, origin.z}, size[3] = {cell.x, cell.y, cell.z},
              to[3] = {eye.x, eye.y, eye.z};
  const std::uint16_t counts[3] = {across, up, deep};
  std::uint32_t place[3];
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t distance = std::int64_t{to[axis]} - from[axis];
    if (distance < 0 || distance >= std::int64_t{size[axis]} * counts[axis]) return {};
    // Both are below 2^32.
    place[axis] = static_cast<std::uint32_t>(distance) / static_cast<std::uint32_t>(size[axis]);
  }
  const std::size_t words = (meshlets + 31) / 32;
  const std::uint16_t set = set_of_cell[(std::size_t{place[2]} * up + place[1]) * across + place[0]];
  return sets.subspan(set * words, words);
}

/// Checks all of `bytes` and makes `opened` a view of them; on an error `opened` keeps its value. Any bytes are safe.
/// `meshlets`: SceneCounts::meshlets of the scene. Errors: blob_alignment; blob_version (`needed`: the blob's version,
/// `available`: the supported version); blob_damaged (`needed`: offset of the wrong byte, 16 if the blob is for another
/// number of meshlets, the offset after the last byte if bytes are missing).
[[gnu::noinline]] inline Status open_visible_sets(std::span<const std::byte> bytes, std::uint32_t meshlets,
                                                  VisibleSets& opened) {
  using namespace detail::visible_sets_at;
  if (reinterpret_cast<std::uintptr_t>(bytes.data()) % kVisibleSetsAlignment != 0) {
    return {.error = Error::blob_alignment};
  }
  if (bytes.size() < kCells) return detail::damaged_sets(bytes.size());
  constexpr std::size_t kVersion = 2;
  for (std::size_t i = 0; i < std::size(detail::kVisibleSetsMark); ++i) {
    if (i != kVersion && bytes[i] != detail::kVisibleSetsMark[i]) return detail::damaged_sets(i);
  }
  const auto version = static_cast<std::uint8_t>(bytes[kVersion]);
  if (version != kVisibleSetsVersion) {
    return {.error = Error::blob_version, .needed = version, .available = kVisibleSetsVersion};
  }
  const auto size = detail::value_at<std::uint32_t>(bytes, kSize);
  if (size > bytes.size()) return detail::damaged_sets(bytes.size());
  bytes = bytes.first(size);
  if (size < kCells) return detail::damaged_sets(kSize);
  if (crc32(bytes.subspan(kChecked)) != detail::value_at<std::uint32_t>(bytes, kChecksum))
    return detail::damaged_sets(kChecksum);
  VisibleSets found{.origin = detail::vector_at(bytes, kOrigin),
                    .cell = detail::vector_at(bytes, kCell),
                    .across = detail::value_at<std::uint16_t>(bytes, kCounts),
                    .up = detail::value_at<std::uint16_t>(bytes, kCounts + 2),
                    .deep = detail::value_at<std::uint16_t>(bytes, kCounts + 4),
                    .meshlets = detail::value_at<std::uint32_t>(bytes, kMeshlets),
                    .near_plane = detail::value_at<Fixed>(bytes, kNear),
                    .scene_checksum = detail::value_at<std::uint32_t>(bytes, kScene)};
  if (found.meshlets != meshlets) return detail::damaged_sets(kMeshlets);
  if (found.cell.x <= 0 || found.cell.y <= 0 || found.cell.z <= 0) return detail::damaged_sets(kCell);
  const std::uint64_t cells = std::uint64_t{found.across} * found.up * found.deep;
  const std::uint32_t sets = detail::value_at<std::uint16_t>(bytes, kSets);
  const std::uint64_t words = (std::uint64_t{meshlets} + 31) / 32 * sets;
  const std::uint64_t sets_at = kCells + (cells * 2 + 3) / 4 * 4;
  if (size != sets_at + words * 4) return detail::damaged_sets(kSize);
  found.set_of_cell = {reinterpret_cast<const std::uint16_t*>(bytes.data() + kCells), static_cast<std::size_t>(cells)};
  found.sets = {reinterpret_cast<const std::uint32_t*>(bytes.data() + sets_at), static_cast<std::size_t>(words)};
  for (std::size_t i = 0; i < found.set_of_cell.size(); ++i) {
    if (found.set_of_cell[i] >= sets) return detail::damaged_sets(kCells + 2 * i);
  }
  opened = found;
  return {};
}

}  // namespace zstrip
