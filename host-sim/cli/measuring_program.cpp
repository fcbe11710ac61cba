// Finds zstrip-measure beside this program and becomes it.
#include "cli/measuring_program.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "cli/print.hpp"
#include "result.hpp"

namespace zstrip::sim {

void add_measuring_commands(CLI::App& app) {
  for (const MeasuringCommand& command : kMeasuringCommands) app.add_subcommand(command.name, command.description);
}

std::optional<int> run_measuring_program(int argc, char** argv) {
  if (argc < 2) return std::nullopt;
  const auto is_named = [&](const MeasuringCommand& command) { return std::string_view(argv[1]) == command.name; };
  if (std::ranges::none_of(kMeasuringCommands, is_named)) return std::nullopt;
  std::error_code error;
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe", error).replace_filename("zstrip-measure");
  ::execv(program.c_str(), argv);
  return print_failure(
      {ExitStatus::environment, fmt::format("cannot run {}: {}; 'zstrip {}' needs it: build the target zstrip-measure",
                                            program.string(), std::strerror(errno), argv[1])});
}

}  // namespace zstrip::sim
