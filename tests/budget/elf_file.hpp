// What a linked program for a board consists of: sections and symbols of a 32-bit little-endian ELF file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace zstrip::budget {

struct Section {
  std::string name;
  std::uint32_t address;
  std::uint32_t size;
  std::vector<std::byte> bytes;  ///< empty for memory that is only reserved
};

struct Symbol {
  std::string name;  ///< as the linker knows it
  std::uint32_t address;
  std::uint32_t size;
  bool is_function;
};

struct ElfFile {
  std::vector<Section> sections;  ///< those that take memory on the board
  std::vector<Symbol> symbols;    ///< functions and objects with a size, by address

  /// 0 if there is no such section.
  std::uint32_t size_of(const std::string& section) const;
};

/// Throws std::runtime_error if the file is not a whole ELF file of this kind.
ElfFile read_elf(const std::filesystem::path& file);

/// The name as the source has it, for a symbol's; the same if it is not mangled.
std::string demangled(const std::string& symbol);

}  // namespace zstrip::budget
