// Chooses the board, reads the program, plans as it does.
#include "cli/pico_arguments.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "bake/pico_scene.hpp"
#include "cli/one_of.hpp"

namespace zstrip::sim {

void add_pico_options(CLI::App& command, PicoArguments& arguments) {
  command
      .add_option("--board", arguments.board,
                  "Which board a .uf2 file is for: pico, a Raspberry Pi Pico (default), or pico2, a Pico 2")
      ->option_text("BOARD")
      ->check(one_of({pico::kPico.name, pico::kPico2.name}));
  command
      .add_option("--with", arguments.program,
                  "Into a .uf2 file, too: the program that shows it, zstrip_pico_player.uf2 or zstrip_pico2_player.uf2")
      ->type_name("FILE");
}

Result<Done> check_not_for_pico(const PicoArguments& arguments) {
  if (arguments.program) {
    return Failure{ExitStatus::usage, "--with is the program of a file for the Raspberry Pi Pico: -o FILE.uf2"};
  }
  if (arguments.board) {
    return Failure{ExitStatus::usage, "--board is of a file for a Raspberry Pi Pico or Pico 2: -o FILE.uf2"};
  }
  return Done{};
}

Result<PicoFile> parse_pico(const PicoArguments& arguments, const std::string& output) {
  PicoFile file;
  if (arguments.board && *arguments.board == pico::kPico2.name) file.board = pico::kPico2;
  if (!arguments.program) return file;
  Result<pico::Pages> read = read_pico_program(*arguments.program, file.board);
  if (!read) return read.failure();
  file.program = std::move(*read);
  std::error_code ignored;  // what is not there is not the same
  if (std::filesystem::equivalent(*arguments.program, output, ignored)) {
    return Failure{ExitStatus::usage, fmt::format("-o '{}' is the file of --with; name another one", output)};
  }
  return file;
}

PlanArguments plan_arguments_for_pico(PlanArguments plan) {
  if (!plan.view.size) plan.view.size = fmt::format("{0}x{0}", pico::kPanelSide);
  if (!plan.view.format) plan.view.format = "rgb565_swapped";
  plan.strip_buffers = 2;
  plan.mode = "any";
  return plan;
}

PlanRequest request_for_pico(const PlanRequest& request, const Staging& staging, const Animation& animation,
                             const Turn& turn, const pico::Board& board) {
  PlanRequest within = request;
  const std::uint32_t left = pico_budget(staging.scene, animation, turn, board);
  if (within.budget.bytes == 0 || within.budget.bytes > left) within.budget.bytes = left;
  PlanRequest usual = within;
  usual.budget.strip_rows = pico::kStripRows;
  return within.budget.strip_rows == 0 && best_plan(staging, usual) ? usual : within;
}

}  // namespace zstrip::sim
