// What drawing costs on an emulated core, and on a board that has one.
#pragma once

#include <vector>

#include "accuracy/measure.hpp"

namespace zstrip::sim {

/// The board whose frames a second are predicted for a target "m0", "m3" or "m4f".
std::string_view board_of(std::string_view target);

/// The program that draws scenes with exactly these effects, without folder and suffix, for example
/// "zstrip_scene_m3_0003".
std::string board_program_name(std::string_view target, Effects effects);

/// Draws each of the staged scenes and fills in instructions, frames a second and flash. Failures: those of
/// bench_on_board.
Result<Done> measure_on_board(const AccuracyRequest& request, const std::vector<Staging>& staged, const View& view,
                              Effects effects, const Budget& budget, Cost& cost);

}  // namespace zstrip::sim
