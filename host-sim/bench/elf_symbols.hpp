// The functions of a program for a board.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "result.hpp"

namespace zstrip::sim {

struct ElfFunction {
  std::string name;       ///< mangled
  std::uint32_t address;  ///< of its first instruction
  std::uint32_t bytes;
};

/// Returns the functions of a 32-bit ELF program with symbols, in order of address.
Result<std::vector<ElfFunction>> elf_functions(const std::filesystem::path& program);

}  // namespace zstrip::sim
