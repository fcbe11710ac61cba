// The columns of the table, and what its notes say.
#include "instruction_table.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <stdexcept>

#include "bench/child_process.hpp"

namespace zstrip::instruction_budget {

measured::Table instructions_format() {
  return {.part = "instructions",
          .columns = {{"name"},
                      {"workload"},
                      {"target"},
                      {"size"},
                      {"mode"},
                      {"strip_rows"},
                      {"depth"},
                      {"frames"},
                      {"measured", measured::kInstructions}}};
}

Case case_of(const measured::Row& row) {
  Case result{row.at(0), row.at(1), row.at(2), row.at(3), row.at(4), row.at(5), row.at(6)};
  const std::string& text = row.at(7);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result.frames);
  if (error != std::errc{} || end != text.data() + text.size()) throw std::runtime_error("'" + text + "' is no number");
  return result;
}

measured::Row with_figure(measured::Row row, std::uint64_t figure) {
  row.back() = std::to_string(figure);
  return row;
}

std::vector<std::string> compiler_notes() {
  const auto with_version = [](const std::string& compiler) {
    const auto version = sim::run_program({compiler, "-dumpfullversion"}, std::chrono::seconds{30});
    const bool known = version && version->exit_status == 0;
    return compiler + " " + (known ? version->text.substr(0, version->text.find('\n')) : "");
  };
  return {"compiled for the host by g++ " __VERSION__, "compiled for boards by " + with_version("arm-none-eabi-g++"),
          "compiled for RISC-V by " + with_version("riscv64-unknown-elf-g++"),
          "compiled for aarch64 by " + with_version("aarch64-linux-gnu-g++")};
}

bool compiled_like(const measured::Table& table, const Case& row) {
  const std::size_t of_target = row.target == "host" ? 0 : row.target == "rv32" ? 2 : row.target == kAarch64 ? 3 : 1;
  return std::ranges::find(table.notes, compiler_notes()[of_target]) != table.notes.end();
}

}  // namespace zstrip::instruction_budget
