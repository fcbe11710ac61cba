// Goes through sections, symbol by symbol.
#include "weight.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "reader_name.hpp"

namespace zstrip::flash {
namespace {

constexpr const char* kTexts = ".texts";   // project/flash.ld
constexpr std::uint32_t kInstruction = 2;  // bytes of the shortest

void add(Weight& weight, Group group, const std::string& name, std::uint32_t bytes) {
  if (bytes == 0) return;
  weight.groups[static_cast<std::size_t>(group)] += bytes;
  if (group == Group::rest) weight.rest[name] += bytes;
}

/// Of the innermost function that says more than that it calculates or calls others; else of the symbol.
Group group_at(std::uint32_t address, const budget::Symbol& symbol, const Inlined& inlined) {
  const auto found = inlined.find(address);
  if (found != inlined.end()) {
    for (const std::string& name : found->second) {
      const Group group = group_of(name);
      if (group != Group::rest && group != Group::library && group != Group::frame) return group;
    }
  }
  return group_of(symbol.name);
}

void weigh_section(Weight& weight, const budget::Section& section, const std::vector<budget::Symbol>& symbols,
                   const Inlined& inlined) {
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
      const std::string name = budget::without_arguments(budget::reader_name(symbol.name));
      for (std::uint32_t at = end - bytes; at < end;) {
        const std::uint32_t step = symbol.is_function ? std::min(kInstruction, end - at) : bytes;
        add(weight, group_at(section.address + at, symbol, inlined), name, step);
        at += step;
      }
    }
    done = std::max(done, end);
  }
  add(weight, Group::rest, unnamed, size - done);
}

}  // namespace

std::uint32_t Weight::bytes() const { return std::accumulate(groups.begin(), groups.end(), std::uint32_t{0}); }

Weight weigh(const budget::ElfFile& program, const Inlined& inlined) {
  Weight weight;
  for (const budget::Section& section : program.sections) weigh_section(weight, section, program.symbols, inlined);
  return weight;
}

std::string complaint_of_rest(const std::string& program, const Weight& weight) {
  if (10 * weight.of(Group::rest) <= weight.bytes()) return "";
  std::string lines = program + ": more than a tenth fits no pattern of tests/flash/groups.cpp:\n";
  for (const auto& [name, bytes] : weight.rest) lines += "  " + std::to_string(bytes) + " bytes: " + name + '\n';
  return lines;
}

}  // namespace zstrip::flash
