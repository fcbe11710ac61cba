// The subcommand `zstrip bench`.
#pragma once

namespace CLI {
class App;
}

namespace zstrip::sim {

/// Adds the subcommand to `app`. When parsing selects it, it runs and puts its ExitStatus into `exit_code`, which must
/// outlive the parsing.
void add_bench_command(CLI::App& app, int& exit_code);

}  // namespace zstrip::sim
