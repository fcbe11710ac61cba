// Writes docs/measured/flash.md: the programs, then the groups of two of them.
#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>

#include "programs.hpp"

namespace zstrip::flash {
namespace {

constexpr const char* kGroupedMachine = "m3";
constexpr const char* kGroupedPrograms[] = {"k5_unclipped", "k5", "k5_run_time", "ct"};

constexpr const char* kCounted = R"(
**Counted**: all of a linked program that lies in flash: code and `main`, constants, texts, values that variables begin
with, `memcpy`, `memmove` and `memset`, libgcc, padding. Linked with `--gc-sections`.

**Not counted**: the scene's tables (vertices, triangles, texels, materials, the program's constants that name them;
column `tables` of the CSV); start-up code, vector table and driver, which the programs do not have; code that prints,
which an empty function replaces; RAM, stack.

## What takes them
On a Cortex-M3:

)";

constexpr const char* kGroupsExplained = R"(
Functions are grouped by name (`tests/flash/groups.cpp`). Inlined code counts for the function that it was inlined from,
by the debug information, not for the caller; inlined arithmetic counts for the code that needs it. With -O2 functions
of the core that are not templates count as a whole. Link time optimisation makes this less exact: code that it merges
counts for one function only. So a group says where to look, and the difference of two programs says what a feature
takes: clipping, for example, also needs spans in 64 bits and a division from libgcc. A figure within its tolerance
keeps its recorded value, so the sum of the groups may differ a little from the program.
)";

/// With a comma before each three digits.
std::string grouped(std::string digits) {
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, 1, ',');
  return digits;
}

std::string cell(const measured::Table& table, const char* program, const char* machine, const char* preset,
                 const char* column) {
  const measured::Row* const row = table.find({program, machine, preset});
  if (row == nullptr) throw std::runtime_error(std::string("there is no row of ") + program + ", " + machine);
  const auto found = std::ranges::find(table.columns, column, &measured::Column::name);
  return grouped(row->at(static_cast<std::size_t>(found - table.columns.begin())));
}

void write_programs(std::ostringstream& page, const measured::Table& table) {
  page << "| Program | Scene | Renderer ";
  for (const Machine& machine : kMachines) {
    for (const Preset& preset : kPresets) page << "| " << machine.processor << ", " << preset.options << ' ';
  }
  page << "|\n|---|---|---|--:|--:|--:|--:|\n";
  for (const Program& program : kPrograms) {
    page << "| `" << program.name << "` | " << program.scene << " | " << program.renderer;
    for (const Machine& machine : kMachines) {
      for (const Preset& preset : kPresets) {
        page << " | " << cell(table, program.name, machine.name, preset.name, "bytes");
      }
    }
    page << " |\n";
  }
}

void write_groups(std::ostringstream& page, const measured::Table& table) {
  std::string line = "|---|";
  page << "| Group ";
  for (const char* const name : kGroupedPrograms) {
    for (const Preset& preset : kPresets) {
      page << "| `" << name << "`, " << preset.options << ' ';
      line += "--:|";
    }
  }
  page << "|\n" << line << '\n';
  for (const GroupName& group : kGroups) {
    std::string cells;
    bool is_empty = true;
    for (const char* const program : kGroupedPrograms) {
      for (const Preset& preset : kPresets) {
        const std::string bytes = cell(table, program, kGroupedMachine, preset.name, group.column);
        is_empty = is_empty && bytes == "0";
        cells += " | " + bytes;
      }
    }
    if (!is_empty) page << "| " << group.words << cells << " |\n";
  }
}

}  // namespace

std::string flash_page(const measured::Table& table) {
  std::ostringstream page;
  page << "# Flash of minimal programs, measured\n\n"
          "Bytes of code and constants without the scene's tables. [flash.csv](flash.csv) has the same figures and\n"
          "those of all groups; `tests/measure flash` writes both.\n\n";
  for (const std::string& note : table.notes) page << "- " << note << '\n';
  page << "- K5 and CT: 320x240 pixels in RGB565, strips of 8 rows, the camera learned at run time\n"
          "- pyramid: the program of docs/program.md as it stands\n"
          "- `unclipped`: `effect::unclipped`, for what does not come near the camera\n"
          "- `Renderer`: scene, picture and plan are learned and checked at run time\n\n";
  write_programs(page, table);
  page << kCounted;
  write_groups(page, table);
  page << kGroupsExplained;
  return page.str();
}

}  // namespace zstrip::flash
