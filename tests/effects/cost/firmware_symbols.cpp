// Reads the linked program.
#include "firmware_symbols.hpp"

#include "elf_file.hpp"
#include "reader_name.hpp"

namespace zstrip::effects_cost {

std::map<std::string, std::uint32_t> section_bytes(const std::filesystem::path& program) {
  std::map<std::string, std::uint32_t> bytes;
  for (const budget::Section& section : budget::read_elf(program).sections) bytes[section.name] += section.size;
  return bytes;
}

std::set<std::string> symbol_names(const std::filesystem::path& program) {
  std::set<std::string> names;
  for (const budget::Symbol& symbol : budget::read_elf(program).symbols) names.insert(budget::reader_name(symbol.name));
  return names;
}

}  // namespace zstrip::effects_cost
