// Asks addr2line.
#include "inlined.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <ios>
#include <sstream>
#include <stdexcept>

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
  const std::string command = "arm-none-eabi-addr2line -a -i -f -e '" + program.string() + "' <'" + list + "'";
  FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string text;
  std::array<char, 65536> buffer;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), count);
  if (pclose(pipe) != 0) throw std::runtime_error("failed: " + command);
  return parse_inlined(text);
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
