// Reads ELF files, each access checked against the file's size. Source: Tool Interface Standard, ELF specification 1.2.
#include "elf_file.hpp"

#include <cxxabi.h>
#include <elf.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

namespace zstrip::budget {
namespace {

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : name_(file.string()) {
    std::ifstream stream(file, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(stream), {});
    if (!stream) fail("cannot be read");
  }

  [[noreturn]] void fail(const std::string& what) const { throw std::runtime_error(name_ + ": " + what); }

  const char* at(std::uint64_t offset, std::uint64_t size) const {
    if (offset > bytes_.size() || size > bytes_.size() - offset) fail("is cut short");
    return bytes_.data() + offset;
  }

  template <class Record>
  Record record(std::uint64_t offset) const {
    Record result;
    std::memcpy(&result, at(offset, sizeof result), sizeof result);
    return result;
  }

  std::string text(const Elf32_Shdr& table, std::uint32_t offset) const {
    const char* const begin = at(table.sh_offset, table.sh_size);
    const char* const end = begin + table.sh_size;
    if (offset >= table.sh_size) fail("has a name outside its table");
    return {begin + offset, std::find(begin + offset, end, '\0')};
  }

 private:
  std::string name_;
  std::string bytes_;
};

std::vector<Elf32_Shdr> section_headers(const Reader& reader) {
  const auto header = reader.record<Elf32_Ehdr>(0);
  if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 || header.e_ident[EI_CLASS] != ELFCLASS32 ||
      header.e_ident[EI_DATA] != ELFDATA2LSB || header.e_shentsize != sizeof(Elf32_Shdr)) {
    reader.fail("is not a 32-bit little-endian ELF file");
  }
  std::vector<Elf32_Shdr> headers;
  for (std::uint32_t i = 0; i < header.e_shnum; ++i) {
    headers.push_back(reader.record<Elf32_Shdr>(header.e_shoff + std::uint64_t{i} * sizeof(Elf32_Shdr)));
  }
  if (header.e_shstrndx >= headers.size()) reader.fail("has no names of sections");
  return headers;
}

std::vector<Symbol> read_symbols(const Reader& reader, const std::vector<Elf32_Shdr>& headers,
                                 const Elf32_Shdr& table) {
  if (table.sh_link >= headers.size()) reader.fail("has no names of symbols");
  std::vector<Symbol> symbols;
  for (std::uint32_t offset = 0; offset + sizeof(Elf32_Sym) <= table.sh_size; offset += sizeof(Elf32_Sym)) {
    const auto entry = reader.record<Elf32_Sym>(std::uint64_t{table.sh_offset} + offset);
    const auto type = ELF32_ST_TYPE(entry.st_info);
    if (entry.st_size == 0 || (type != STT_FUNC && type != STT_OBJECT)) continue;
    // The lowest bit of a function's address says Thumb.
    const std::uint32_t address = type == STT_FUNC ? entry.st_value & ~1U : entry.st_value;
    symbols.push_back({reader.text(headers[table.sh_link], entry.st_name), address, entry.st_size, type == STT_FUNC});
  }
  return symbols;
}

}  // namespace

std::uint32_t ElfFile::size_of(const std::string& section) const {
  for (const Section& each : sections) {
    if (each.name == section) return each.size;
  }
  return 0;
}

ElfFile read_elf(const std::filesystem::path& file) {
  const Reader reader(file);
  const std::vector<Elf32_Shdr> headers = section_headers(reader);
  const Elf32_Shdr& names = headers[reader.record<Elf32_Ehdr>(0).e_shstrndx];
  ElfFile result;
  for (const Elf32_Shdr& header : headers) {
    if (header.sh_type == SHT_SYMTAB) result.symbols = read_symbols(reader, headers, header);
    if ((header.sh_flags & SHF_ALLOC) == 0) continue;
    Section section{reader.text(names, header.sh_name), header.sh_addr, header.sh_size, {}};
    if (header.sh_type != SHT_NOBITS) {
      const auto* const begin = reinterpret_cast<const std::byte*>(reader.at(header.sh_offset, header.sh_size));
      section.bytes.assign(begin, begin + header.sh_size);
    }
    result.sections.push_back(std::move(section));
  }
  std::sort(result.symbols.begin(), result.symbols.end(), [](const Symbol& a, const Symbol& b) {
    return a.address != b.address ? a.address < b.address : a.name < b.name;
  });
  return result;
}

std::string demangled(const std::string& symbol) {
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> name(abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status),
                                                    std::free);
  return status == 0 ? name.get() : symbol;
}

}  // namespace zstrip::budget
