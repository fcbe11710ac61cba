// Chooses the board, reads the program, and plans as the program does.
#include "cli/pico_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "bake/pico_scene.hpp"
#include "cli/nearest_name.hpp"
#include "cli/parse.hpp"
#include "text/number.hpp"
#include "zstrip/plan.hpp"

namespace zstrip::sim {

void add_pico_options(CLI::App& command, PicoArguments& arguments) {
  command
      .add_option("--with", arguments.program,
                  "Also put the program that shows the scene into the .uf2 file: zstrip_pico_player.uf2, "
                  "zstrip_pico2_player.uf2, or one of them with _hot")
      ->type_name("FILE");
}

Result<Done> check_not_for_pico(const PicoArguments& arguments) {
  if (arguments.program) {
    return Failure{ExitStatus::usage, "--with is the program of a file for the Raspberry Pi Pico: -o FILE.uf2"};
  }
  return Done{};
}

Result<PicoFile> parse_pico(const PicoArguments& arguments, const std::optional<std::string>& board,
                            const std::string& output) {
  PicoFile file;
  if (board) {
    std::vector<std::string_view> names;
    for (const pico::Board* const known : pico::kBoards) names.emplace_back(known->name);
    const auto found = std::ranges::find(names, *board);
    if (found == names.end()) return usage("-o FILE.uf2: " + unknown_name("--board", *board, names));
    file.board = *pico::kBoards[found - names.begin()];
  }
  if (!arguments.program) return file;
  Result<pico::Pages> read = read_pico_program(*arguments.program, file.board);
  if (!read) return read.failure();
  file.program = std::move(*read);
  const pico::Board& of_program = board_of(file.program, file.board);
  if (of_program.player_memory < file.board.player_memory) file.board = of_program;
  std::error_code ignored;  // a file that does not exist is not the other one
  if (std::filesystem::equivalent(*arguments.program, output, ignored)) {
    return Failure{ExitStatus::usage, fmt::format("-o '{}' is the file of --with; name another one", output)};
  }
  return file;
}

PlanArguments plan_arguments_for_pico(PlanArguments plan) {
  if (!plan.view.size) plan.view.size = fmt::format("{0}x{0}", pico::kPanelSide);
  if (!plan.view.format) plan.view.format = "rgb565_swapped";
  plan.memory.board.reset();  // with .uf2 files --board names the program
  plan.strip_buffers = 2;
  plan.mode = "any";
  return plan;
}

namespace {

std::uint32_t left_of(const pico::Board& board, std::uint64_t kept) {
  return kept < board.player_memory ? static_cast<std::uint32_t>(board.player_memory - kept) : 1;
}

/// Returns the status of the program's own plan, for a scene of which the program keeps `kept` more bytes.
Status planned_on_pico(const PlanRequest& request, const Staging& staging, std::uint64_t kept,
                       const pico::Board& board) {
  const View view{pico::kPanelSide, pico::kPanelSide, PixelFormat::rgb565_swapped, request.view.dither,
                  request.view.samples};
  const Effects effects = effects_of(staging.scene, staging.camera) | effects_of(view) | request.perspective;
  return plan(count(staging.scene), view, effects | effect::bins, {.bytes = left_of(board, kept), .strip_buffers = 2})
      .status;
}

}  // namespace

Result<PlanRequest> request_for_pico(const PlanRequest& request, const Staging& staging, const Animation& animation,
                                     const Turn& turn, const BlobCharacters* characters, const PicoFile& file) {
  const pico::Board& board = file.board;
  const std::uint64_t kept = kept_on_pico(staging.scene, animation, turn, characters);
  const auto planned_on = [&](const pico::Board& any) { return planned_on_pico(request, staging, kept, any); };
  if (const Status planned = planned_on(board); planned.error == Error::arena_too_small) {
    const auto* const larger = std::ranges::find_if(
        pico::kBoards, [&](const pico::Board* other) { return static_cast<bool>(planned_on(*other)); });
    std::string advice = "take fewer vertices or instances";
    if (larger != std::end(pico::kBoards)) {
      advice = fmt::format("{} has enough: --board {}", (*larger)->player, (*larger)->name);
      if (!file.program.empty()) advice += fmt::format(" --with {}.uf2", (*larger)->player);
    }
    return Failure{ExitStatus::budget,
                   fmt::format("takes {} of RAM, of the arena most for {}; {} has {} for a scene; {}",
                               counted(kept + planned.needed, "byte"), name(planned.purpose), board.player,
                               grouped(board.player_memory), advice)};
  }
  PlanRequest within = request;
  const std::uint32_t left = left_of(board, kept);
  const bool any = within.budget.bytes == 0 || within.ram_limit == RamLimit::usual;
  if (any || within.budget.bytes > left) within.budget.bytes = left;
  within.ram_limit = RamLimit::given;
  PlanRequest usual = within;
  usual.budget.strip_rows = pico::kStripRows;
  return within.budget.strip_rows == 0 && best_plan(staging, usual) ? usual : within;
}

}  // namespace zstrip::sim
