// zstrip-measure: the subcommands of the command that measure. The command runs it.
#include "accuracy/accuracy_command.hpp"
#include "accuracy/tune_command.hpp"
#include "bench/bench_command.hpp"
#include "cli/command_line.hpp"
#include "fit/fit_command.hpp"
#include "zstrip/visibility.hpp"

int main(int argc, char** argv) {
  zstrip::use_visibility_methods();
  return zstrip::sim::run_command_line(argc, argv, [](CLI::App& app, int& exit_code) {
    zstrip::sim::add_bench_command(app, exit_code);
    zstrip::sim::add_accuracy_command(app, exit_code);
    zstrip::sim::add_tune_command(app, exit_code);
    zstrip::sim::add_fit_command(app, exit_code);
  });
}
