// The cost of drawing on an emulated core, and on a board that has this core.
#pragma once

#include <vector>

#include "accuracy/measure.hpp"

namespace zstrip::sim {

/// Returns the board for which frames a second of a target "m0", "m3" or "m4f" are predicted.
std::string_view board_of(std::string_view target);

/// Returns the program that draws scenes with exactly these effects, without folder and suffix, for example
/// "zstrip_scene_m3_00000000003".
std::string board_program_name(std::string_view target, Effects effects);

/// Draws each of the staged scenes, and sets instructions, frames a second and flash. Failures: those of
/// bench_on_board.
Result<Done> measure_on_board(const AccuracyRequest& request, const std::vector<Staging>& staged, const View& view,
                              Effects effects, const Budget& budget, Cost& cost);

}  // namespace zstrip::sim
