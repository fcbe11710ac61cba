// Goes through sections, symbol by symbol.
#include "weight.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "reader_name.hpp"

namespace zstrip::flash {
namespace {

constexpr const char* kTexts = ".texts";  // project/flash.ld

void add(Weight& weight, Group group, const std::string& name, std::uint32_t bytes) {
  if (bytes == 0) return;
  weight.groups[static_cast<std::size_t>(group)] += bytes;
  if (group == Group::rest) weight.rest[name] += bytes;
}

void weigh_section(Weight& weight, const budget::Section& section, const std::vector<budget::Symbol>& symbols) {
  const auto size = static_cast<std::uint32_t>(section.bytes.size());
  if (section.name == kTexts) {
    add(weight, Group::texts, section.name, size);
    return;
  }
  const std::string unnamed = "without a name, in " + section.name;
  std::uint32_t done = 0;  // bytes of the section
  for (const budget::Symbol& symbol : symbols) {
    if (symbol.address < section.address || symbol.address - section.address >= size) continue;
    const std::uint32_t begin = symbol.address - section.address;
    const std::uint32_t end = begin + std::min(symbol.size, size - begin);
    if (begin > done) add(weight, Group::rest, unnamed, begin - done);
    const std::uint32_t bytes = end - std::min(end, std::max(begin, done));
    if (!symbol.is_function && is_table(symbol.name)) {
      weight.tables += bytes;
    } else {
      add(weight, group_of(symbol.name), budget::without_arguments(budget::reader_name(symbol.name)), bytes);
    }
    done = std::max(done, end);
  }
  add(weight, Group::rest, unnamed, size - done);
}

}  // namespace

std::uint32_t Weight::bytes() const { return std::accumulate(groups.begin(), groups.end(), std::uint32_t{0}); }

Weight weigh(const budget::ElfFile& program) {
  Weight weight;
  for (const budget::Section& section : program.sections) weigh_section(weight, section, program.symbols);
  return weight;
}

std::string complaint_of_rest(const std::string& program, const Weight& weight) {
  if (10 * weight.of(Group::rest) <= weight.bytes()) return "";
  std::string lines = program + ": more than a tenth fits no pattern of tests/flash/groups.cpp:\n";
  for (const auto& [name, bytes] : weight.rest) lines += "  " + std::to_string(bytes) + " bytes: " + name + '\n';
  return lines;
}

}  // namespace zstrip::flash
