// The Pico's program as files, without running it as tests/pico does: the second boot stage's checksum, the .uf2 file
// against the .elf file, and what `zstrip bake` knows of the players of Pico and Pico 2.
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "pico/flash_map.hpp"
#include "pico_files.hpp"

namespace zstrip::boards {
namespace {

constexpr const char* kPicoProgram = "zstrip_pico_show";

template <class Number>
Number mirrored(Number value, int bits) {
  Number result = 0;
  for (int bit = 0; bit < bits; ++bit) result = static_cast<Number>(result << 1 | (value >> bit & 1U));
  return result;
}

// zlib's CRC is the same one with all bits in the other order, and inverted at the end.
TEST(BoardPico, BootStageHasItsChecksum) {
  const Bytes flash = flash_image(kPicoProgram);
  ASSERT_GE(flash.size(), 256U);
  Bytes checked(flash.begin(), flash.begin() + 252);
  for (unsigned char& byte : checked) byte = mirrored<unsigned char>(byte, 8);
  const auto crc = static_cast<std::uint32_t>(crc32_z(crc32_z(0, nullptr, 0), checked.data(), checked.size()));
  EXPECT_EQ(word(flash, 252), mirrored<std::uint32_t>(~crc, 32));
  EXPECT_NE(word(flash, 0), 0U);
}

TEST(BoardPico, VectorTableFollowsTheBootStage) {
  const Bytes flash = flash_image(kPicoProgram);
  ASSERT_GE(flash.size(), 264U);
  EXPECT_EQ(word(flash, 256), 0x20001000U) << "the top of a stack of 4 KB at the beginning of the RAM";
  const std::uint32_t entry = word(flash, 260);
  EXPECT_EQ(entry % 2, 1U) << "Thumb code";
  EXPECT_GT(entry, 0x10000100U);
  EXPECT_LT(entry, 0x10000000U + flash.size());
}

TEST(BoardPico, Uf2HasTheWholeFlashImage) {
  const Bytes uf2 = uf2_file(kPicoProgram);
  if (uf2.empty()) GTEST_SKIP() << "there was no compiler for this machine in the cross build";
  EXPECT_EQ(uf2_complaint(uf2, flash_image(kPicoProgram), 0xE48BFF56), "");
}

/// Their memory, and the words by which `zstrip bake --with` knows them apart.
TEST(BoardPico, PlayersAreAsBakeKnowsThem) {
  for (const pico::Board* const board : pico::kBoards) {
    EXPECT_EQ(variable_bytes(board->player, "_ZN12_GLOBAL__N_16memoryE"), board->player_memory) << board->player;
    const Bytes flash = flash_image(board->player);
    for (const pico::Board* const other : pico::kBoards) {
      const std::string_view words = other->no_scene;
      EXPECT_EQ(std::search(flash.begin(), flash.end(), words.begin(), words.end()) != flash.end(), other == board)
          << board->player << ": " << words;
    }
  }
}

}  // namespace
}  // namespace zstrip::boards
