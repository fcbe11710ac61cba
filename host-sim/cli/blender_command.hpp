// `zstrip blender`.
#pragma once

namespace CLI {
class App;
}

namespace zstrip::sim {

/// Adds the subcommand; when it runs, it stores the exit status.
void add_blender_command(CLI::App& app, int& exit_code);

}  // namespace zstrip::sim
