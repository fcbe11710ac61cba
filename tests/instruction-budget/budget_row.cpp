// The format of budgets.csv, and the comparison.
#include "budget_row.hpp"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <ranges>
#include <stdexcept>
#include <string_view>

#include "bench/child_process.hpp"

namespace zstrip::instruction_budget {
namespace {

constexpr std::string_view kHostLine = "# compiled for the host by g++ ";
constexpr std::string_view kBoardLine = "# compiled for boards by arm-none-eabi-g++ ";
constexpr std::string_view kHeading = "name,workload,target,size,mode,strip_rows,depth,frames,most";

template <typename Number>
Number number(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    throw std::runtime_error(fmt::format("'{}' is no number", text));
  }
  return value;
}

BudgetRow parse_row(const std::string& line) {
  std::vector<std::string> words;
  for (const auto word : line | std::views::split(',')) words.emplace_back(word.begin(), word.end());
  if (words.size() != 9) throw std::runtime_error("a row has 9 columns");
  return {words[0],
          words[1],
          words[2],
          words[3],
          words[4],
          words[5],
          words[6],
          number<std::uint32_t>(words[7]),
          number<std::uint64_t>(words[8])};
}

}  // namespace

Compilers compilers_here() {
  Compilers here{.host = __VERSION__, .board = ""};
  const auto version = sim::run_program({"arm-none-eabi-g++", "-dumpfullversion"}, std::chrono::seconds{30});
  if (version && version->exit_status == 0) here.board = version->text.substr(0, version->text.find('\n'));
  return here;
}

BudgetFile read_budgets(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  BudgetFile budgets;
  int count = 0;
  for (std::string line; std::getline(stream, line);) {
    ++count;
    try {
      if (line.starts_with(kHostLine)) {
        budgets.compilers.host = line.substr(kHostLine.size());
      } else if (line.starts_with(kBoardLine)) {
        budgets.compilers.board = line.substr(kBoardLine.size());
      } else if (line != kHeading) {
        budgets.rows.push_back(parse_row(line));
      }
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("{}:{}: {}", file.string(), count, error.what()));
    }
  }
  return budgets;
}

void write_budgets(const std::filesystem::path& file, const BudgetFile& budgets) {
  std::ofstream out(file);
  out << kHostLine << budgets.compilers.host << '\n' << kBoardLine << budgets.compilers.board << '\n';
  out << kHeading << '\n';
  for (const BudgetRow& row : budgets.rows) {
    out << fmt::format("{},{},{},{},{},{},{},{},{}\n", row.name, row.workload, row.target, row.size, row.mode,
                       row.strip_rows, row.depth, row.frames, row.most);
  }
  out.flush();
  if (!out) throw std::runtime_error("cannot write " + file.string());
}

std::string complaint(const BudgetRow& row, std::uint64_t measured) {
  if (100 * measured <= (100 + kTolerance) * row.most) return "";
  const double percent =
      100 * (static_cast<double>(measured) / static_cast<double>(row.most) - 1);  // infinite without a budget
  return fmt::format(
      "{} takes {} {}, {:.2f} % over its budget of {} ({} % are allowed); if that is worth it, run "
      "tests/instruction-budget/update and say why in the commit",
      row.name, measured, row.mode == kCode ? "bytes" : "instructions a frame", percent, row.most, kTolerance);
}

}  // namespace zstrip::instruction_budget
