// What the two programs of the command share: parsing, exit statuses, and the message of every failure.
#pragma once

namespace CLI {
class App;
}

namespace zstrip::sim {

/// Runs the subcommand that the words name and returns the exit status, for main's return value. `add_commands` adds
/// the subcommands, each of which puts its status into `exit_code`. Nothing is thrown.
int run_command_line(int argc, char** argv, void (*add_commands)(CLI::App& app, int& exit_code));

}  // namespace zstrip::sim
