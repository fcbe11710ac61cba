// The option --board: a board by its name.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/board_model.hpp"
#include "result.hpp"

namespace CLI {
class App;
}

namespace zstrip::sim {

/// Returns the names of all boards, as `zstrip boards` lists them.
std::vector<std::string_view> names_of_boards();

/// A usage error that lists similar names if there is no board of this name.
Result<const BoardModel*> parse_board(const std::string& text);

/// Adds --board to commands that plan for its RAM; `board` must live as long as the command. `more` is added to its
/// help.
void add_board_option(CLI::App& command, std::optional<std::string>& board, const std::string& more = {});

}  // namespace zstrip::sim
