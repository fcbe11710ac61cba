// One row of budgets.csv: a workload on a target, and the instructions that a frame of it may take.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace zstrip::instruction_budget {

/// A row with this mode is about the pipeline's code: the bytes of flash that the workload's pipeline takes on the
/// target.
inline constexpr std::string_view kCode = "code";

/// The words of a case are those of `zstrip bench`.
struct BudgetRow {
  std::string name;  ///< of the test: InstructionBudget.name
  std::string workload, target, size, mode, strip_rows, depth;
  std::uint32_t frames = 0;  ///< from frame 0 on
  std::uint64_t most = 0;    ///< instructions a frame, the mean of `frames`; of code bytes
};

/// What the programs were compiled with when the figures were taken; elsewhere they mean nothing.
struct Compilers {
  std::string host;   ///< as its __VERSION__ says
  std::string board;  ///< as arm-none-eabi-g++ -dumpfullversion says; empty if there is none
  bool operator==(const Compilers&) const = default;
};

struct BudgetFile {
  Compilers compilers;
  std::vector<BudgetRow> rows;
};

/// The compilers of this build.
Compilers compilers_here();

/// Throws std::runtime_error that names the line which is not as it must be.
BudgetFile read_budgets(const std::filesystem::path& file);
void write_budgets(const std::filesystem::path& file, const BudgetFile& budgets);

/// Most that a measurement may be above its budget, percent.
inline constexpr std::uint64_t kTolerance = 2;

/// Empty if `measured` is within the row's budget, else by how much they are over.
std::string complaint(const BudgetRow& row, std::uint64_t measured);

}  // namespace zstrip::instruction_budget
