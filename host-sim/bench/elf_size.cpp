// Sums up the segments that are loaded.
#include "bench/elf_size.hpp"

#include <elf.h>
#include <fmt/format.h>

#include <cstring>
#include <fstream>

namespace zstrip::sim {
namespace {

template <typename Record>
bool read_record(std::istream& file, std::uint64_t offset, Record& record) {
  file.seekg(static_cast<std::streamoff>(offset));
  return static_cast<bool>(file.read(reinterpret_cast<char*>(&record), sizeof record));
}

}  // namespace

Result<std::uint64_t> elf_load_bytes(const std::filesystem::path& program) {
  const Failure unreadable{ExitStatus::environment, fmt::format("{} is not a 32-bit ELF program", program.string())};
  std::ifstream file(program, std::ios::binary);
  Elf32_Ehdr header{};
  if (!read_record(file, 0, header) || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 ||
      header.e_ident[EI_CLASS] != ELFCLASS32 || header.e_phentsize != sizeof(Elf32_Phdr)) {
    return unreadable;
  }
  std::uint64_t bytes = 0;
  for (std::uint32_t i = 0; i < header.e_phnum; ++i) {
    Elf32_Phdr segment{};
    if (!read_record(file, header.e_phoff + i * sizeof(Elf32_Phdr), segment)) return unreadable;
    if (segment.p_type == PT_LOAD) bytes += segment.p_filesz;
  }
  return bytes;
}

}  // namespace zstrip::sim
