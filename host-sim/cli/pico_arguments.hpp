// The options of `zstrip bake` for files for a Raspberry Pi Pico or Pico 2, and the options that the program on the
// board leaves open.
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

class BlobCharacters;

/// The options as given on the command line.
struct PicoArguments {
  std::optional<std::string> program;
};

/// The part of --board's help that is about .uf2 files.
inline constexpr const char* kPicoBoardHelp =
    ". For a .uf2 file: pico, a Raspberry Pi Pico (default), or pico2, a Pico 2; pico_hot or pico2_hot: for the "
    "program "
    "that has hot code in RAM, and less RAM for a scene";

void add_pico_options(CLI::App& command, PicoArguments& arguments);

/// Fails if one of these options is given, because the output is another file.
Result<Done> check_not_for_pico(const PicoArguments& arguments);

/// The board of a file, and the program that is also in it. If the program is for a board with less memory than that of
/// the option, the program's board is used.
struct PicoFile {
  pico::Board board = pico::kPico;
  pico::Pages program;
};

/// `board`: of --board. `output`: must not be the program's file.
Result<PicoFile> parse_pico(const PicoArguments& arguments, const std::optional<std::string>& board,
                            const std::string& output);

/// Sets the options that are not given to the program's own values, because the program plans by itself.
PlanArguments plan_arguments_for_pico(PlanArguments plan);

/// Returns a request within the memory of the program, with the program's number of rows if it fits. Fails if none of
/// the program's plans fits: it plans by itself, without the options. `characters`: null if there are none.
Result<PlanRequest> request_for_pico(const PlanRequest& request, const Staging& staging, const Animation& animation,
                                     const Turn& turn, const BlobCharacters* characters, const PicoFile& file);

}  // namespace zstrip::sim
