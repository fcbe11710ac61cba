// Reads programs for the Pico from .uf2 files, which may hold anything.
#pragma once

#include <cstdint>
#include <span>

#include "pico/uf2_blocks.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// The pages that the blocks fill. All of the file is checked: each block, that all are there, in order and for the
/// board's chip, and that none fills what another one does. The failure's message continues "'FILE' ...".
Result<pico::Pages> read_uf2(std::span<const std::uint8_t> file, const pico::Board& board);

}  // namespace zstrip::sim
