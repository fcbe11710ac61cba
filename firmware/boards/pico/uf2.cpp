// uf2 BOARD ELF UF2: converts a program for the flash of a Pico (pico) or Pico 2 (pico2, pico2_riscv) to the file that
// is copied to the board's USB drive. Runs on the build machine. Format of ELF: Tool Interface Standard 1.2.
#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "pico/uf2_blocks.hpp"

namespace {

using namespace zstrip::pico;

/// Reads a little-endian number; throws if it lies beyond the end.
std::uint32_t number(const std::vector<std::uint8_t>& file, std::uint64_t at, unsigned bytes) {
  if (at > file.size() || file.size() - at < bytes) throw std::runtime_error("the ELF file is cut off");
  std::uint32_t value = 0;
  for (unsigned i = 0; i < bytes; ++i) value |= static_cast<std::uint32_t>(file[at + i]) << (8 * i);
  return value;
}

const Board& board_named(const std::string& name) {
  for (const Board* board : {&kPico, &kPico2, &kPico2Riscv}) {
    if (board->name == name) return *board;
  }
  throw std::runtime_error("no board " + name + ", but pico, pico2 and pico2_riscv");
}

/// Returns the bytes that the program headers load into flash, in whole pages; gaps are zeros.
Pages flash_pages(const std::vector<std::uint8_t>& file, std::uint32_t flash_bytes) {
  constexpr std::array<std::uint8_t, 6> kElf32LittleEndian{0x7F, 'E', 'L', 'F', 1, 1};
  if (file.size() < 52 || !std::equal(kElf32LittleEndian.begin(), kElf32LittleEndian.end(), file.begin())) {
    throw std::runtime_error("no 32-bit little-endian ELF file");
  }
  const std::uint32_t headers = number(file, 28, 4), header_size = number(file, 42, 2), count = number(file, 44, 2);
  Pages pages;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint64_t header = std::uint64_t{headers} + std::uint64_t{i} * header_size;
    constexpr std::uint32_t kLoad = 1;
    const std::uint32_t offset = number(file, header + 4, 4), address = number(file, header + 12, 4);
    const std::uint32_t size = number(file, header + 16, 4);
    if (number(file, header, 4) != kLoad || size == 0) continue;
    if (address < kFlash || address - kFlash > flash_bytes || size > flash_bytes - (address - kFlash)) {
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

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    std::cerr << "usage: uf2 BOARD ELF UF2\n";
    return 2;
  }
  try {
    const Board& board = board_named(arguments[1]);
    std::ifstream elf(arguments[2], std::ios::binary);
    if (!elf) throw std::runtime_error("cannot be read");
    const std::vector<std::uint8_t> file(std::istreambuf_iterator<char>(elf), {});
    const std::vector<std::uint8_t> blocks = to_uf2(flash_pages(file, board.flash_bytes), board);
    std::ofstream uf2(arguments[3], std::ios::binary);
    uf2.write(reinterpret_cast<const char*>(blocks.data()), static_cast<std::streamsize>(blocks.size()));
    uf2.close();
    if (!uf2) throw std::runtime_error(std::string("cannot write ") + arguments[3]);
  } catch (const std::exception& error) {
    std::cerr << "uf2: " << arguments[2] << ": " << error.what() << '\n';
    return 1;
  }
}
