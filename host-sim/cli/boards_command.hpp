// `zstrip boards`.
#pragma once

namespace CLI {
class App;
}

namespace zstrip::sim {

/// Adds the subcommand; when it runs, it stores the exit status.
void add_boards_command(CLI::App& app, int& exit_code);

}  // namespace zstrip::sim
