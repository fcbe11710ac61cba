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

class BlobCharacters;

/// Reads a program that shows baked scenes of this version, from the file of the option --with.
Result<pico::Pages> read_pico_program(const std::string& path, const pico::Board& board);

/// Returns the board for whose player the program was built, with the chip of `board`; `board` if the program does not
/// say.
const pico::Board& board_of(const pico::Pages& program, const pico::Board& board);

/// `program`: must be complete. Fails if the scene is too large for its part of the flash.
Result<std::vector<std::uint8_t>> to_pico_file(std::span<const std::uint8_t> blob, const pico::Pages& program,
                                               const pico::Board& board);

/// Returns the bytes that the program keeps of this scene besides the arena and two strips: tables, and moving parts.
/// `characters`: null if there are none.
std::uint64_t kept_on_pico(const Scene& scene, const Animation& animation, const Turn& turn,
                           const BlobCharacters* characters);

/// Fails if size or format of the picture are not those of the program's panel.
Result<Done> check_view_for_pico(const View& view);

/// Fails for effects that the program does not draw.
Result<Done> check_for_pico(Effects effects);

}  // namespace zstrip::sim
