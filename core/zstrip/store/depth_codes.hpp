// Depth records whose cells are codes: residuals of a prediction, or offsets from one value.
#pragma once

#include <cstddef>
#include <cstdint>

#include "zstrip/store/depth_record.hpp"

namespace zstrip::detail {

/// Decodes the bytes after the cover of a record with opcode kAlong, kDown, kColumn or kOffset + 0..15. `cover`: the
/// cells that have codes; nullptr if all cells have codes and the tile has 8 columns. Cells without a code may get any
/// value. Returns false if the bytes are not such a record. Reads only these bytes, and less than 4 bytes before them,
/// which must exist.
bool decode_codes(const std::uint8_t* bytes, std::size_t size, Opcode opcode, const Cover* cover,
                  const TileView<std::uint16_t>& tile);

}  // namespace zstrip::detail
