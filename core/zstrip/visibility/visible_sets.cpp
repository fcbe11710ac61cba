// Opens baked sets and finds an eye's cell; see visible_sets.hpp.
#include "zstrip/visibility/visible_sets.hpp"

#include <bit>
#include <iterator>

#include "zstrip/base/crc32.hpp"

namespace zstrip {
namespace {

static_assert(std::endian::native == std::endian::little, "sets are little endian and used in place");

constexpr Status damaged(std::size_t at) {
  return {.error = Error::blob_damaged, .needed = static_cast<std::uint32_t>(at)};
}

/// Of an aligned blob that has this byte.
template <class Value>
Value value_at(std::span<const std::byte> bytes, std::uint32_t at) {
  return *reinterpret_cast<const Value*>(bytes.data() + at);
}

Vec3 vector_at(std::span<const std::byte> bytes, std::uint32_t at) {
  return {value_at<Fixed>(bytes, at), value_at<Fixed>(bytes, at + 4), value_at<Fixed>(bytes, at + 8)};
}

}  // namespace

std::span<const std::uint32_t> VisibleSets::at(const Vec3& eye) const {
  const Fixed from[3] = {origin.x, origin.y, origin.z}, size[3] = {cell.x, cell.y, cell.z},
              to[3] = {eye.x, eye.y, eye.z};
  const std::uint16_t counts[3] = {across, up, deep};
  std::uint32_t place[3];
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t distance = std::int64_t{to[axis]} - from[axis];
    if (distance < 0 || distance >= std::int64_t{size[axis]} * counts[axis]) return {};
    // Below 2^32, both of them.
    place[axis] = static_cast<std::uint32_t>(distance) / static_cast<std::uint32_t>(size[axis]);
  }
  const std::size_t words = (meshlets + 31) / 32;
  const std::uint16_t set = set_of_cell[(std::size_t{place[2]} * up + place[1]) * across + place[0]];
  return sets.subspan(set * words, words);
}

Status open_visible_sets(std::span<const std::byte> bytes, std::uint32_t meshlets, VisibleSets& opened) {
  using namespace detail::visible_sets_at;
  if (reinterpret_cast<std::uintptr_t>(bytes.data()) % kVisibleSetsAlignment != 0) {
    return {.error = Error::blob_alignment};
  }
  if (bytes.size() < kCells) return damaged(bytes.size());
  constexpr std::size_t kVersion = 2;
  for (std::size_t i = 0; i < std::size(detail::kVisibleSetsMark); ++i) {
    if (i != kVersion && bytes[i] != detail::kVisibleSetsMark[i]) return damaged(i);
  }
  const auto version = static_cast<std::uint8_t>(bytes[kVersion]);
  if (version != kVisibleSetsVersion) {
    return {.error = Error::blob_version, .needed = version, .available = kVisibleSetsVersion};
  }
  const auto size = value_at<std::uint32_t>(bytes, kSize);
  if (size > bytes.size()) return damaged(bytes.size());
  bytes = bytes.first(size);
  if (size < kCells) return damaged(kSize);
  if (crc32(bytes.subspan(kChecked)) != value_at<std::uint32_t>(bytes, kChecksum)) return damaged(kChecksum);
  VisibleSets found{.origin = vector_at(bytes, kOrigin),
                    .cell = vector_at(bytes, kCell),
                    .across = value_at<std::uint16_t>(bytes, kCounts),
                    .up = value_at<std::uint16_t>(bytes, kCounts + 2),
                    .deep = value_at<std::uint16_t>(bytes, kCounts + 4),
                    .meshlets = value_at<std::uint32_t>(bytes, kMeshlets),
                    .near_plane = value_at<Fixed>(bytes, kNear),
                    .scene_checksum = value_at<std::uint32_t>(bytes, kScene)};
  if (found.meshlets != meshlets) return damaged(kMeshlets);
  if (found.cell.x <= 0 || found.cell.y <= 0 || found.cell.z <= 0) return damaged(kCell);
  const std::uint64_t cells = std::uint64_t{found.across} * found.up * found.deep;
  const std::uint32_t sets = value_at<std::uint16_t>(bytes, kSets);
  const std::uint64_t words = (std::uint64_t{meshlets} + 31) / 32 * sets;
  const std::uint64_t sets_at = kCells + (cells * 2 + 3) / 4 * 4;
  if (size != sets_at + words * 4) return damaged(kSize);
  found.set_of_cell = {reinterpret_cast<const std::uint16_t*>(bytes.data() + kCells), static_cast<std::size_t>(cells)};
  found.sets = {reinterpret_cast<const std::uint32_t*>(bytes.data() + sets_at), static_cast<std::size_t>(words)};
  for (std::size_t i = 0; i < found.set_of_cell.size(); ++i) {
    if (found.set_of_cell[i] >= sets) return damaged(kCells + 2 * i);
  }
  opened = found;
  return {};
}

}  // namespace zstrip
