// Which functions are inlined at an address of a program, from its debug information.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "elf_file.hpp"

namespace zstrip::flash {

/// By the address of an instruction: functions as the linker calls them, the innermost first.
using Inlined = std::map<std::uint32_t, std::vector<std::string>>;

/// At each even address of the program's functions of which something is known. Writes a file beside the program.
/// Throws std::runtime_error.
Inlined read_inlined(const std::filesystem::path& program, const budget::ElfFile& elf);

/// What addr2line -a -i -f prints: an address, then a line with a function and one with its place for each of them.
Inlined parse_inlined(const std::string& text);

}  // namespace zstrip::flash
