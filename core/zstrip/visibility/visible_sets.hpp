// The bytes of baked visible sets, which are read in place; the format is in docs/formats.md.
#pragma once

#include <cstddef>
#include <cstdint>

#include "zstrip/visibility.hpp"

namespace zstrip::detail {

/// The bytes: words of 32 bits, little endian. Cells of the table have 16 bits, filled up to a whole word.
namespace visible_sets_at {
inline constexpr std::uint32_t kSize = 4, kChecksum = 8, kChecked = 12;  // of all bytes from kChecked on
inline constexpr std::uint32_t kScene = 12, kMeshlets = 16, kOrigin = 20, kCell = 32, kCounts = 44, kSets = 50;
inline constexpr std::uint32_t kNear = 52, kCells = 56;
}  // namespace visible_sets_at
inline constexpr std::byte kVisibleSetsMark[] = {std::byte{'z'}, std::byte{'s'}, std::byte{kVisibleSetsVersion},
                                                 std::byte{'v'}};

}  // namespace zstrip::detail
