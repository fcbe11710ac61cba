// Asks addr2line.
#include "inlined.hpp"

#include <cstdlib>
#include <fstream>
#include <ios>
#include <sstream>
#include <stdexcept>

#include "tool_output.hpp"

namespace zstrip::flash {
namespace {

constexpr const char* kUnknown = "??";

}  // namespace

Inlined read_inlined(const std::filesystem::path& program, const budget::ElfFile& elf) {
  const std::string list = program.string() + ".addresses";
  std::ofstream addresses(list);
  addresses << std::hex;
  for (const budget::Symbol& symbol : elf.symbols) {
    for (std::uint32_t at = 0; symbol.is_function && at < symbol.size; at += 2)
      addresses << symbol.address + at << '\n';
  }
  addresses.close();
  if (!addresses) throw std::runtime_error("cannot write " + list);
  return parse_inlined(
      budget::output_of("arm-none-eabi-addr2line -a -i -f -e '" + program.string() + "' <'" + list + "'"));
}

Inlined parse_inlined(const std::string& text) {
  Inlined inlined;
  std::istringstream lines(text);
  std::uint32_t address = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("0x")) {
      address = static_cast<std::uint32_t>(std::strtoul(line.c_str(), nullptr, 16));
    } else {
      if (line != kUnknown) inlined[address].push_back(line);
      std::getline(lines, line);  // its place
    }
  }
  return inlined;
}

}  // namespace zstrip::flash
