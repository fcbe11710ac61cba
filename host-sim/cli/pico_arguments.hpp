// The options of `zstrip bake` for files for a Raspberry Pi Pico or Pico 2, and what the program there leaves to
// choose.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/plan_arguments.hpp"
#include "pico/uf2_blocks.hpp"
#include "result.hpp"
#include "zstrip/animation.hpp"
#include "zstrip/scene/turn.hpp"

namespace zstrip::sim {

/// As given on the command line.
struct PicoArguments {
  std::optional<std::string> board;
  std::optional<std::string> program;
};

void add_pico_options(CLI::App& command, PicoArguments& arguments);

/// Fails if one of them is given: for other files.
Result<Done> check_not_for_pico(const PicoArguments& arguments);

/// What a file is for, and the program that it has besides. Where that has less memory than the option's board, it
/// counts.
struct PicoFile {
  pico::Board board = pico::kPico;
  pico::Pages program;
};

/// `output`: must not be the program's file.
Result<PicoFile> parse_pico(const PicoArguments& arguments, const std::string& output);

/// What the options leave open is as the program draws, which plans by itself.
PlanArguments plan_arguments_for_pico(PlanArguments plan);

/// Within the memory of the program, with as many rows as it takes where they fit. Fails where no plan of the
/// program's fits: it plans by itself, whatever the options say.
Result<PlanRequest> request_for_pico(const PlanRequest& request, const Staging& staging, const Animation& animation,
                                     const Turn& turn, const PicoFile& file);

}  // namespace zstrip::sim
