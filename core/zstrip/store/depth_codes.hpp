// Depth records whose cells are codes: residuals of a prediction, or offsets from one value.
#pragma once

#include <cstddef>
#include <cstdint>

#include "zstrip/store/depth_record.hpp"

namespace zstrip::detail {

/// `bytes`: what follows the cover in a record with opcode kAlong, kDown, kColumn or kOffset + 0..15. `cover`: cells
/// that have codes; nullptr if all do and the tile has 8 columns. Cells without a code come out as anything. False if
/// the bytes are no such record; reads only them, and less than 4 bytes before them, which must be there.
bool decode_codes(const std::uint8_t* bytes, std::size_t size, Opcode opcode, const Cover* cover,
                  const TileView<std::uint16_t>& tile);

}  // namespace zstrip::detail
