// The zstrip command: reads the command line and runs one of its subcommands.
#include "cli/bake_command.hpp"
#include "cli/command_line.hpp"
#include "cli/font_command.hpp"
#include "cli/plan_command.hpp"
#include "cli/render_command.hpp"
#include "cli/scenes_command.hpp"
#include "cli/sibling_program.hpp"
#include "zstrip/visibility.hpp"

int main(int argc, char** argv) {
  if (const auto status = zstrip::sim::run_sibling_program(argc, argv)) return *status;
  zstrip::use_visibility_methods();
  return zstrip::sim::run_command_line(argc, argv, [](CLI::App& app, int& exit_code) {
    zstrip::sim::add_render_command(app, exit_code);
    zstrip::sim::add_plan_command(app, exit_code);
    zstrip::sim::add_bake_command(app, exit_code);
    zstrip::sim::add_font_command(app, exit_code);
    zstrip::sim::add_scenes_command(app, exit_code);
    zstrip::sim::add_sibling_commands(app);
  });
}
