// The endings of `zstrip bake`'s output; see bake_kind.hpp.
#include "cli/bake_kind.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "text/text.hpp"

namespace zstrip::sim {

Result<BakeKind> bake_kind(const std::string& output) {
  std::error_code ignored;
  if (output.ends_with('/') || std::filesystem::is_directory(output, ignored)) return BakeKind::project;
  const std::string extension = lower(std::filesystem::path(output).extension().string());
  if (extension == ".hpp" || extension == ".h") return BakeKind::header;
  if (extension == ".ino") return BakeKind::sketch;
  if (extension == ".cpp") return BakeKind::program;
  if (extension == ".zsc") return BakeKind::blob;
  if (extension == ".uf2") return BakeKind::pico;
  return Failure{
      ExitStatus::usage,
      fmt::format(
          "-o '{}' must end in .hpp (C++ constants), .ino or .cpp (a sketch or a program that shows them), .zsc "
          "(a blob used in place) or .uf2 (a blob for the Raspberry Pi Pico or Pico 2), or in / (a folder with a whole "
          "program)",
          output)};
}

}  // namespace zstrip::sim
