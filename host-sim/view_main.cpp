// zstrip-view: the subcommand of the command that opens a window. The command runs it.
#include "cli/command_line.hpp"
#include "view/view_command.hpp"
#include "zstrip/visibility.hpp"

int main(int argc, char** argv) {
  zstrip::use_visibility_methods();
  return zstrip::sim::run_command_line(
      argc, argv, [](CLI::App& app, int& exit_code) { zstrip::sim::add_view_command(app, exit_code); });
}
