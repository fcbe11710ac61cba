// Reads programs for the Pico from .uf2 files with any contents.
#pragma once

#include <cstdint>
#include <span>

#include "pico/uf2_blocks.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Returns the pages that the blocks fill. Checks the whole file: each block, that all blocks exist, are in order and
/// for the board's chip, and that none overlaps another one. The failure's message continues "'FILE' ...".
Result<pico::Pages> read_uf2(std::span<const std::uint8_t> file, const pico::Board& board);

}  // namespace zstrip::sim
