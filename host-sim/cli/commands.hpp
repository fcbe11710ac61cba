// The subcommands of the command, whichever pipelines its program has.
#pragma once

namespace zstrip::sim {

/// Calls run_command_line with all subcommands except those of other programs, which only its help lists.
int run_command(int argc, char** argv);

}  // namespace zstrip::sim
