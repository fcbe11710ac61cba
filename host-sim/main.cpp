// The zstrip command: reads the command line and runs one of its subcommands, with the common pipelines.
#include <cstdlib>
#include <span>

#include "cli/commands.hpp"
#include "cli/sibling_program.hpp"
#include "zstrip/frame/pipeline_rows.hpp"

namespace {

char** arguments;

}  // namespace

namespace zstrip::detail {

/// Replaces the function of zstrip::core_any. It is called if a pipeline is not among the common ones, before anything
/// was printed or written: the program that has all pipelines then starts with the same words.
std::span<const PipelineRow> rows_of_depth() { std::exit(sim::become(sim::kAnyPipeline, arguments)); }

}  // namespace zstrip::detail

int main(int argc, char** argv) {
  if (const auto status = zstrip::sim::run_sibling_program(argc, argv)) return *status;
  arguments = argv;
  return zstrip::sim::run_command(argc, argv);
}
