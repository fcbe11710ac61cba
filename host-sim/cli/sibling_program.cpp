// Finds a program next to this one and replaces this process by it.
#include "cli/sibling_program.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "cli/print.hpp"
#include "result.hpp"

namespace zstrip::sim {

void add_sibling_commands(CLI::App& app) {
  for (const SiblingCommand& command : kSiblingCommands) app.add_subcommand(command.name, command.description);
}

int become(const SiblingCommand& command, char** argv) {
  std::error_code error;
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe", error).replace_filename(command.program);
  ::execv(program.c_str(), argv);
  if (errno == ENOENT && std::getenv("ZSTRIP_BUILDS") != nullptr) return kNotBuilt;
  return print_failure(
      {ExitStatus::environment, fmt::format("cannot run {}: {}; 'zstrip {}' needs it: {}", program.string(),
                                            std::strerror(errno), argv[1], command.how)});
}

std::optional<int> run_sibling_program(int argc, char** argv) {
  if (argc < 2) return std::nullopt;
  const auto is_named = [&](const SiblingCommand& command) { return std::string_view(argv[1]) == command.name; };
  const auto* const found = std::ranges::find_if(kSiblingCommands, is_named);
  if (found == kSiblingCommands.end()) return std::nullopt;
  return become(*found, argv);
}

}  // namespace zstrip::sim
