// uf2 ELF UF2: a program for the RP2040's flash as the file that is copied to the board when it shows up as a drive.
// Runs on the machine that builds. Format: "USB Flashing Format (UF2)", Microsoft; ELF: Tool Interface Standard 1.2.
#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr std::uint32_t kFlash = 0x10000000, kFlashBytes = 2 << 20, kPage = 256;
using Page = std::array<std::uint8_t, kPage>;

/// Little-endian; throws where it would read behind the end.
std::uint32_t number(const std::vector<std::uint8_t>& file, std::uint64_t at, unsigned bytes) {
  if (at > file.size() || file.size() - at < bytes) throw std::runtime_error("the ELF file is cut off");
  std::uint32_t value = 0;
  for (unsigned i = 0; i < bytes; ++i) value |= static_cast<std::uint32_t>(file[at + i]) << (8 * i);
  return value;
}

/// What the program headers load into flash, in whole pages; gaps are zeros.
std::map<std::uint32_t, Page> flash_pages(const std::vector<std::uint8_t>& file) {
  constexpr std::array<std::uint8_t, 6> kElf32LittleEndian{0x7F, 'E', 'L', 'F', 1, 1};
  if (file.size() < 52 || !std::equal(kElf32LittleEndian.begin(), kElf32LittleEndian.end(), file.begin())) {
    throw std::runtime_error("no 32-bit little-endian ELF file");
  }
  const std::uint32_t headers = number(file, 28, 4), header_size = number(file, 42, 2), count = number(file, 44, 2);
  std::map<std::uint32_t, Page> pages;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint64_t header = std::uint64_t{headers} + std::uint64_t{i} * header_size;
    constexpr std::uint32_t kLoad = 1;
    const std::uint32_t offset = number(file, header + 4, 4), address = number(file, header + 12, 4);
    const std::uint32_t size = number(file, header + 16, 4);
    if (number(file, header, 4) != kLoad || size == 0) continue;
    if (address < kFlash || address - kFlash > kFlashBytes || size > kFlashBytes - (address - kFlash)) {
      throw std::runtime_error("the program is loaded to other memory than the flash");
    }
    for (std::uint32_t byte = 0; byte < size; ++byte) {
      const std::uint32_t to = address + byte;
      pages[to / kPage * kPage][to % kPage] = static_cast<std::uint8_t>(number(file, std::uint64_t{offset} + byte, 1));
    }
  }
  if (pages.empty()) throw std::runtime_error("the program has nothing for the flash");
  return pages;
}

void write(std::ofstream& stream, const std::map<std::uint32_t, Page>& pages) {
  const auto put = [&stream](std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) stream.put(static_cast<char>(value >> shift & 0xFFU));
  };
  constexpr std::uint32_t kBegin0 = 0x0A324655, kBegin1 = 0x9E5D5157, kEnd = 0x0AB16F30;
  constexpr std::uint32_t kFamilyPresent = 0x2000, kRp2040 = 0xE48BFF56;
  std::uint32_t block = 0;
  for (const auto& [address, page] : pages) {
    for (const std::uint32_t word : {kBegin0, kBegin1, kFamilyPresent, address, kPage, block++,
                                     static_cast<std::uint32_t>(pages.size()), kRp2040}) {
      put(word);
    }
    constexpr std::size_t kData = 476;
    for (std::size_t i = 0; i < kData; ++i) stream.put(i < kPage ? static_cast<char>(page[i]) : '\0');
    put(kEnd);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::cerr << "usage: uf2 ELF UF2\n";
    return 2;
  }
  try {
    std::ifstream elf(arguments[1], std::ios::binary);
    if (!elf) throw std::runtime_error("cannot be read");
    const std::vector<std::uint8_t> file(std::istreambuf_iterator<char>(elf), {});
    const auto pages = flash_pages(file);
    std::ofstream uf2(arguments[2], std::ios::binary);
    write(uf2, pages);
    uf2.close();
    if (!uf2) throw std::runtime_error(std::string("cannot write ") + arguments[2]);
  } catch (const std::exception& error) {
    std::cerr << "uf2: " << arguments[1] << ": " << error.what() << '\n';
    return 1;
  }
}
