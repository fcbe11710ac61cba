// .uf2 files: any bytes are pages of a Pico's or Pico 2's flash, each as its block has it, or a failure; any pages
// become a file that a boot loader can take sector by sector, and from which they are read again.
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "bake/uf2_file.hpp"
#include "input.hpp"
#include "require.hpp"

namespace {

using namespace zstrip;
using Bytes = std::vector<std::uint8_t>;

std::uint32_t word(std::span<const std::uint8_t> block, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i > 0; --i) value = value << 8 | block[at + i - 1];
  return value;
}

/// Of a file that was read: its pages are those of its blocks, for this chip and in this flash.
void judge_pages(std::span<const std::uint8_t> file, const pico::Board& board, const pico::Pages& pages) {
  fuzz::require(pages.size() * pico::kBlock == file.size(), "a page for each block: %zu", pages.size());
  for (std::size_t at = 0; at < file.size(); at += pico::kBlock) {
    const std::span block = file.subspan(at, pico::kBlock);
    const std::uint32_t address = word(block, 12);
    fuzz::require(word(block, 0) == pico::kBegin0 && word(block, 28) == board.family, "blocks are for the %s",
                  board.chip);
    fuzz::require(address % pico::kPage == 0 && address >= pico::kFlash &&
                      address - pico::kFlash <= board.flash_bytes - pico::kPage,
                  "%08x is a page of the flash", address);
    const auto found = pages.find(address);
    fuzz::require(found != pages.end() && std::ranges::equal(found->second, block.subspan(32, pico::kPage)),
                  "the page at %08x is that of its block", address);
  }
}

void judge_reading(std::span<const std::uint8_t> file, const pico::Board& board) {
  const auto pages = sim::read_uf2(file, board);
  if (pages) return judge_pages(file, board, *pages);
  fuzz::require(pages.failure().status == sim::ExitStatus::input, "a damaged file is the input's fault");
  fuzz::require(pages.failure().message.starts_with("is not a .uf2 file"), "a failure says what the file is not: %s",
                pages.failure().message.c_str());
}

/// Which sector is to be erased a loader finds out from a block's number alone: the first of 16 begins one.
void judge_sectors(const Bytes& file) {
  constexpr std::size_t kPagesOfSector = pico::kSector / pico::kPage;
  for (std::size_t number = 0; number * pico::kBlock < file.size(); ++number) {
    const std::uint32_t address = word(std::span(file).subspan(number * pico::kBlock), 12);
    fuzz::require(address / pico::kPage % kPagesOfSector == number % kPagesOfSector,
                  "block %zu of a sector is for %08x", number, address);
  }
}

void judge_writing(fuzz::Input& input, const pico::Board& board) {
  pico::Pages pages;
  for (std::uint32_t count = 1 + input.below(8); count > 0; --count) {
    const std::uint32_t page = input.below(board.flash_bytes / pico::kPage);
    pages[pico::kFlash + page * pico::kPage].fill(input.any<std::uint8_t>());
  }
  Bytes file = pico::to_uf2(pages, board);
  judge_sectors(file);
  const auto read = sim::read_uf2(file, board);
  fuzz::require(read && *read == pico::in_whole_sectors(pages), "what is written is read");
  fuzz::require(std::ranges::includes(*read, pages), "pages are as they were");

  for (std::uint32_t changes = 1 + input.below(4); changes > 0; --changes) {
    const std::size_t block = input.below(static_cast<std::uint32_t>(file.size() / pico::kBlock));
    file[block * pico::kBlock + input.below(pico::kBlock)] = input.any<std::uint8_t>();
  }
  if (input.flag()) file.resize(input.below(static_cast<std::uint32_t>(file.size())));
  judge_reading(file, board);
}

}  // namespace

/// The bytes as a file; and as pages, and what is damaged of their file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  for (const pico::Board& board : {pico::kPico, pico::kPico2}) {
    judge_reading({data, size}, board);
    judge_writing(input, board);
  }
  return 0;
}
