// Common to both programs of the command: parsing, exit statuses, and the message of every failure.
#pragma once

namespace CLI {
class App;
}

namespace zstrip::sim {

/// Runs the subcommand of the command line and returns the exit status, for main's return value. `add_commands` adds
/// the subcommands, each of which stores its status in `exit_code`. Throws nothing.
int run_command_line(int argc, char** argv, void (*add_commands)(CLI::App& app, int& exit_code));

}  // namespace zstrip::sim
