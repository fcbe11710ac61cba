// Columns and rows of the table.
#include "programs.hpp"

namespace zstrip::flash {
namespace {

/// The sum is the figure; between groups the optimiser moves code at any change.
constexpr measured::Tolerance kGroup{.share = 0.05, .at_least = 256};

}  // namespace

measured::Table flash_format() {
  measured::Table table{
      .part = "flash",
      .columns = {{"program"}, {"machine"}, {"preset"}, {"bytes", measured::kFlash}, {"tables", measured::kExact}}};
  for (const GroupName& group : kGroups) table.columns.push_back({group.column, kGroup});
  return table;
}

measured::Row row_of(const std::string& program, const std::string& machine, const std::string& preset,
                     const Weight& weight) {
  measured::Row row{program, machine, preset, std::to_string(weight.bytes()), std::to_string(weight.tables)};
  for (const std::uint32_t bytes : weight.groups) row.push_back(std::to_string(bytes));
  return row;
}

}  // namespace zstrip::flash
