// A baked scene as a file for the boot loader of a Pico or Pico 2, alone or with the program that shows it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pico/uf2_blocks.hpp"
#include "result.hpp"
#include "zstrip/animation.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/turn.hpp"

namespace zstrip::sim {

/// A program that shows baked scenes of this version; of a file of the option --with.
Result<pico::Pages> read_pico_program(const std::string& path, const pico::Board& board);

/// `program`: none of it may be left out. Fails where the scene is too large for its part of the flash.
Result<std::vector<std::uint8_t>> to_pico_file(std::span<const std::uint8_t> blob, const pico::Pages& program,
                                               const pico::Board& board);

/// Bytes that the program has for the arena and two strips of this scene, besides which it keeps tables and what moves.
std::uint32_t pico_budget(const Scene& scene, const Animation& animation, const Turn& turn, const pico::Board& board);

/// Fails for what the program does not draw.
Result<Done> check_for_pico(Effects effects);

}  // namespace zstrip::sim
