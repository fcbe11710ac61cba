// The Pico's program as files, without running it as tests/pico does: the second boot stage's checksum, and the .uf2
// file against the .elf file.
#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "programs.hpp"

namespace zstrip::boards {
namespace {

using Bytes = std::vector<unsigned char>;

Bytes contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(stream), {});
}

/// The flash from its beginning, as binutils see it.
Bytes flash_image() {
  const std::filesystem::path image =
      std::filesystem::path(testing::TempDir()) / ("zstrip-pico-" + std::to_string(::getpid()));
  const std::string command =
      "arm-none-eabi-objcopy -O binary '" + program("zstrip_pico_show").string() + "' '" + image.string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  Bytes bytes = contents(image);
  std::filesystem::remove(image);
  return bytes;
}

std::uint32_t word(const Bytes& bytes, std::size_t at) {
  return static_cast<std::uint32_t>(bytes.at(at) | bytes.at(at + 1) << 8 | bytes.at(at + 2) << 16) |
         static_cast<std::uint32_t>(bytes.at(at + 3)) << 24;
}

template <class Number>
Number mirrored(Number value, int bits) {
  Number result = 0;
  for (int bit = 0; bit < bits; ++bit) result = static_cast<Number>(result << 1 | (value >> bit & 1U));
  return result;
}

// zlib's CRC is the same one with all bits in the other order, and inverted at the end.
TEST(BoardPico, BootStageHasItsChecksum) {
  const Bytes flash = flash_image();
  ASSERT_GE(flash.size(), 256U);
  Bytes checked(flash.begin(), flash.begin() + 252);
  for (unsigned char& byte : checked) byte = mirrored<unsigned char>(byte, 8);
  const auto crc = static_cast<std::uint32_t>(crc32_z(crc32_z(0, nullptr, 0), checked.data(), checked.size()));
  EXPECT_EQ(word(flash, 252), mirrored<std::uint32_t>(~crc, 32));
  EXPECT_NE(word(flash, 0), 0U);
}

TEST(BoardPico, VectorTableFollowsTheBootStage) {
  const Bytes flash = flash_image();
  ASSERT_GE(flash.size(), 264U);
  EXPECT_EQ(word(flash, 256), 0x20001000U) << "the top of a stack of 4 KB at the beginning of the RAM";
  const std::uint32_t entry = word(flash, 260);
  EXPECT_EQ(entry % 2, 1U) << "Thumb code";
  EXPECT_GT(entry, 0x10000100U);
  EXPECT_LT(entry, 0x10000000U + flash.size());
}

TEST(BoardPico, Uf2HasTheWholeFlashImage) {
  Bytes flash = flash_image();
  const std::filesystem::path file = program("zstrip_pico_show").replace_extension(".uf2");
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "there was no compiler for this machine in the cross build";
  const Bytes uf2 = contents(file);
  ASSERT_EQ(uf2.size() % 512, 0U);
  const std::size_t blocks = uf2.size() / 512;
  flash.resize((flash.size() + 255) / 256 * 256);
  ASSERT_EQ(blocks, flash.size() / 256);
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::size_t at = 512 * block;
    EXPECT_EQ(word(uf2, at), 0x0A324655U);
    EXPECT_EQ(word(uf2, at + 4), 0x9E5D5157U);
    EXPECT_EQ(word(uf2, at + 8), 0x2000U);
    EXPECT_EQ(word(uf2, at + 12), 0x10000000U + 256 * block);
    EXPECT_EQ(word(uf2, at + 16), 256U);
    EXPECT_EQ(word(uf2, at + 20), block);
    EXPECT_EQ(word(uf2, at + 24), blocks);
    EXPECT_EQ(word(uf2, at + 28), 0xE48BFF56U);
    EXPECT_EQ(word(uf2, at + 508), 0x0AB16F30U);
    const auto begin = uf2.begin() + static_cast<std::ptrdiff_t>(at) + 32;
    ASSERT_TRUE(std::equal(begin, begin + 256, flash.begin() + 256 * static_cast<std::ptrdiff_t>(block))) << block;
  }
}

}  // namespace
}  // namespace zstrip::boards
