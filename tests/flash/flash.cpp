// Weighs the minimal programs of project/. `tests/measure flash` and a test run it; effects/cost/part.hpp has the
// words.
#include "effects/cost/part.hpp"
#include "memory_table.hpp"
#include "programs.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::flash;
namespace fs = std::filesystem;

Weight weight_of(const std::string& program, const fs::path& build, const std::string& machine,
                 const std::string& preset) {
  const fs::path file = build / (machine + "_" + preset) / program;
  const budget::ElfFile elf = budget::read_elf(file);
  return weigh(elf, read_inlined(file, elf));
}

std::vector<measured::Row> measure(const std::string& program, const fs::path& build,
                                   const effects_cost::Names& machines) {
  std::vector<measured::Row> rows;
  for (const std::string& machine : machines) {
    for (const Preset& preset : kPresets) {
      rows.push_back(row_of(program, machine, preset.name, weight_of(program, build, machine, preset.name)));
    }
  }
  return rows;
}

std::string check(const std::string& program, const fs::path& build) {
  std::string lines;
  for (const Preset& preset : kPresets) {
    lines += complaint_of_rest(program + ", " + preset.name, weight_of(program, build, kMachines[0].name, preset.name));
  }
  return lines;
}

}  // namespace

int main(int count, char** words) {
  effects_cost::Part part{
      .format = flash_format(),
      .notes = {budget::compiler_note("-O2, or with -Os and link time optimisation (`ZSTRIP_PRESET=size`)")},
      .names = {},
      .programs = [](const std::string& program) { return std::set<std::string>{program}; },
      .measure = measure,
      .page = flash_page,
      .check = check};
  for (const Program& program : kPrograms) part.names.emplace_back(program.name);
  return run_part(count, words, part);
}
