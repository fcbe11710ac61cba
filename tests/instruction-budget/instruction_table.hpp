// docs/measured/instructions.csv: workloads on targets, and the instructions that a frame of each takes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "measured/table.hpp"

namespace zstrip::instruction_budget {

/// A row with this mode is about the pipeline's code: the bytes of flash that the workload's pipeline takes on the
/// target.
inline constexpr std::string_view kCode = "code";

/// A row with this target is about a program for Linux, which QEMU's user mode runs.
inline constexpr std::string_view kAarch64 = "aarch64";

/// What a row asks for. The words of a case are those of `zstrip bench`.
struct Case {
  std::string name;  ///< of the test: InstructionBudget.name
  std::string workload, target, size, mode, strip_rows, depth;
  std::uint32_t frames = 0;  ///< from frame 0 on
};

/// Without rows and notes. The last column is instructions a frame, the mean of `frames`; of code bytes.
measured::Table instructions_format();

/// Throws std::runtime_error if `frames` is no number.
Case case_of(const measured::Row& row);

/// The row with another figure.
measured::Row with_figure(measured::Row row, std::uint64_t figure);

/// What the programs of this build are compiled with: notes for the host, for boards, for RISC-V and for AArch64.
std::vector<std::string> compiler_notes();

/// Whether the figure of a row of the table may be compared with what this build's programs take.
bool compiled_like(const measured::Table& table, const Case& row);

}  // namespace zstrip::instruction_budget
