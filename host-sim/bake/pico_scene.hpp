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
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// A program that shows baked scenes of this version; of a file of the option --with.
Result<pico::Pages> read_pico_program(const std::string& path, const pico::Board& board);

/// The board whose player a program is, of the chip of `board`; that one where the program does not say.
const pico::Board& board_of(const pico::Pages& program, const pico::Board& board);

/// `program`: none of it may be left out. Fails where the scene is too large for its part of the flash.
Result<std::vector<std::uint8_t>> to_pico_file(std::span<const std::uint8_t> blob, const pico::Pages& program,
                                               const pico::Board& board);

/// Bytes that the program keeps of this scene beside the arena and two strips: tables, and what moves.
std::uint64_t kept_on_pico(const Scene& scene, const Animation& animation, const Turn& turn);

/// Fails for a picture that is not of the size and the pixels of the program's panel.
Result<Done> check_view_for_pico(const View& view);

/// Fails for what the program does not draw.
Result<Done> check_for_pico(Effects effects);

}  // namespace zstrip::sim
