// Reads block by block; a block that the boot loader would skip or refuse is an error.
#include "bake/uf2_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace zstrip::sim {
namespace {

/// Returns a word of a block.
std::uint32_t word(std::span<const std::uint8_t> block, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= static_cast<std::uint32_t>(block[at + i]) << (8 * i);
  return value;
}

Failure no(const pico::Board& board, const std::string& why) {
  return {ExitStatus::input, fmt::format("is not a .uf2 file for the {}'s flash: {}", board.called, why)};
}

}  // namespace

Result<pico::Pages> read_uf2(std::span<const std::uint8_t> file, const pico::Board& board) {
  using namespace pico;
  if (file.empty() || file.size() % kBlock != 0) {
    return no(board, fmt::format("its {} bytes are not a multiple of {}", file.size(), kBlock));
  }
  const std::size_t blocks = file.size() / kBlock;
  Pages pages;
  for (std::size_t number = 0; number < blocks; ++number) {
    const std::span<const std::uint8_t> block = file.subspan(number * kBlock, kBlock);
    if (word(block, 0) != kBegin0 || word(block, 4) != kBegin1 || word(block, kBlockEnd) != kEnd) {
      return no(board, fmt::format("block {} does not begin and end as one", number));
    }
    if (word(block, 8) != kFamilyPresent || word(block, 28) != board.family) {
      return no(board, fmt::format("block {} is not for the {}", number, board.chip));
    }
    if (word(block, 20) != number || word(block, 24) != blocks) {
      return no(board, fmt::format("block {} says that it is {} of {}, and there are {}", number, word(block, 20),
                                   word(block, 24), blocks));
    }
    const std::uint32_t address = word(block, 12), size = word(block, 16);
    if (size != kPage || address % kPage != 0 || address < kFlash || address - kFlash >= board.flash_bytes) {
      return no(board, fmt::format("block {} has {} bytes for address {:08x}", number, size, address));
    }
    Page page;
    std::copy_n(block.begin() + kBlockHeader, kPage, page.begin());
    if (!pages.emplace(address, page).second) {
      return no(board, fmt::format("block {} fills address {:08x}, as one before it does", number, address));
    }
  }
  return pages;
}

}  // namespace zstrip::sim
