// Reads the symbol table.
#include "bench/elf_symbols.hpp"

#include <elf.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <span>

namespace zstrip::sim {
namespace {

/// Reads a record of the file; returns false if the file ends before it.
template <typename Record>
bool read_record(std::span<const char> file, std::uint64_t offset, Record& record) {
  if (offset > file.size() || file.size() - offset < sizeof record) return false;
  std::memcpy(&record, file.data() + offset, sizeof record);
  return true;
}

std::string text_at(std::span<const char> file, std::uint64_t offset) {
  std::string text;
  for (; offset < file.size() && file[offset] != 0; ++offset) text += file[offset];
  return text;
}

}  // namespace

Result<std::vector<ElfFunction>> elf_functions(const std::filesystem::path& program) {
  const Failure unreadable{ExitStatus::environment,
                           fmt::format("{} is not a 32-bit ELF program with symbols", program.string())};
  std::ifstream stream(program, std::ios::binary);
  const std::string content(std::istreambuf_iterator<char>(stream), {});
  const std::span<const char> file(content);
  Elf32_Ehdr header{};
  if (!read_record(file, 0, header) || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 ||
      header.e_ident[EI_CLASS] != ELFCLASS32 || header.e_shentsize != sizeof(Elf32_Shdr)) {
    return unreadable;
  }
  std::vector<ElfFunction> functions;
  for (std::uint32_t i = 0; i < header.e_shnum; ++i) {
    Elf32_Shdr table{}, names{};
    if (!read_record(file, header.e_shoff + std::uint64_t{i} * sizeof table, table)) return unreadable;
    if (table.sh_type != SHT_SYMTAB) continue;
    if (!read_record(file, header.e_shoff + std::uint64_t{table.sh_link} * sizeof names, names)) return unreadable;
    for (std::uint64_t at = 0; at + sizeof(Elf32_Sym) <= table.sh_size; at += sizeof(Elf32_Sym)) {
      Elf32_Sym symbol{};
      if (!read_record(file, table.sh_offset + at, symbol)) return unreadable;
      if (ELF32_ST_TYPE(symbol.st_info) != STT_FUNC || symbol.st_size == 0) continue;
      functions.push_back({text_at(file, std::uint64_t{names.sh_offset} + symbol.st_name), symbol.st_value & ~1U,
                           symbol.st_size});  // the lowest bit of a function's address marks Thumb code
    }
  }
  if (functions.empty()) return unreadable;
  std::ranges::sort(functions, {}, &ElfFunction::address);
  return functions;
}

}  // namespace zstrip::sim
