// The option --board.
#include "cli/board_arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "cli/nearest_name.hpp"
#include "cli/parse.hpp"
#include "text/number.hpp"

namespace zstrip::sim {

std::vector<std::string_view> names_of_boards() {
  std::vector<std::string_view> names;
  for (const BoardModel& board : board_models()) names.push_back(board.name);
  return names;
}

Result<const BoardModel*> parse_board(const std::string& text) {
  if (const BoardModel* const board = find_board(text)) return board;
  return usage(unknown_name("--board", text, names_of_boards()));
}

void add_board_option(CLI::App& command, std::optional<std::string>& board, const std::string& more) {
  command
      .add_option(
          "--board", board,
          fmt::format("Plan for the RAM of a board, less {} bytes for the rest of the program, instead of --ram: "
                      "{}{}",
                      grouped(kReservedRam), fmt::join(names_of_boards(), ", "), more))
      ->type_name("NAME");
}

}  // namespace zstrip::sim
