// Runs `zstrip bench` for one row, or a program for AArch64.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "instruction_table.hpp"

namespace zstrip::instruction_budget {

struct Programs {
  std::filesystem::path zstrip;    ///< the command
  std::filesystem::path firmware;  ///< the folder of the programs for boards
};

/// Instructions a frame, or bytes of code; empty where this machine cannot count them (no valgrind, a sanitized build,
/// no compiler for AArch64, no file of the model).
/// Throws std::runtime_error with the command's own words if it fails.
std::optional<std::uint64_t> measure(const Case& row, const Programs& programs);

}  // namespace zstrip::instruction_budget
