// Lists the subcommands.
#include "cli/commands.hpp"

#include "cli/bake_command.hpp"
#include "cli/blender_command.hpp"
#include "cli/boards_command.hpp"
#include "cli/command_line.hpp"
#include "cli/font_command.hpp"
#include "cli/plan_command.hpp"
#include "cli/render_command.hpp"
#include "cli/scenes_command.hpp"
#include "cli/sibling_program.hpp"

namespace zstrip::sim {

int run_command(int argc, char** argv) {
  return run_command_line(argc, argv, [](CLI::App& app, int& exit_code) {
    add_render_command(app, exit_code);
    add_plan_command(app, exit_code);
    add_bake_command(app, exit_code);
    add_font_command(app, exit_code);
    add_scenes_command(app, exit_code);
    add_boards_command(app, exit_code);
    add_blender_command(app, exit_code);
    add_sibling_commands(app);
  });
}

}  // namespace zstrip::sim
