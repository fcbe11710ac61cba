// The Pico 2's program as files: what the RP2350's boot ROM looks for in the flash before it starts a program, read as
// the ROM reads it (RP2350 data sheet, 5.9), and the .uf2 file against the .elf file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "pico_files.hpp"

namespace zstrip::boards {
namespace {

constexpr const char* kPico2Program = "zstrip_pico2_show";
constexpr std::uint32_t kFlashBegin = 0x10000000, kRamBegin = 0x20000000, kRamEnd = kRamBegin + 520 * 1024;
constexpr std::uint32_t kBlockBegin = 0xFFFFDED3, kBlockEnd = 0xAB123579;
constexpr std::size_t kSearched = 4096;

void put_word(Bytes& bytes, std::size_t at, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) bytes.at(at + static_cast<std::size_t>(i)) = static_cast<unsigned char>(value >> (8 * i));
}

/// Where the first block begins; kSearched: nowhere that is searched.
std::size_t first_block(const Bytes& flash) {
  std::size_t at = 0;
  while (at < std::min(kSearched, flash.size() - 4) && word(flash, at) != kBlockBegin) at += 4;
  return at;
}

/// Why the ROM would not start what is in the flash as a program for its Arm processors, secure; empty: it would.
std::string boot_complaint(const Bytes& flash) {
  const std::size_t begin = first_block(flash);
  if (begin >= kSearched) return "no block";
  std::uint32_t type = 0, vectors = kFlashBegin;
  std::size_t at = begin + 4;
  for (;;) {
    const std::uint32_t head = word(flash, at);
    constexpr std::uint32_t kLast = 0xFF;
    if ((head & 0xFF) == kLast) break;
    // The size has two bytes where the type's highest bit is set.
    const std::uint32_t words = (head & 0x80) != 0 ? head >> 8 & 0xFFFF : head >> 8 & 0xFF;
    if (words == 0) return "an item without a size";
    if (at + 4 * words > begin + 0x180) return "a block that is too long";
    switch (head & 0xFF) {
      case 0x42:
        if (words != 1) return "the size of the image type's item";
        type = head >> 16;
        break;
      case 0x03:
        if (words != 2) return "the size of the vector table's item";
        vectors = word(flash, at + 4);
        break;
      default: return "an item that this program does not need";
    }
    at += 4 * words;
  }
  if ((word(flash, at) >> 8 & 0xFFFF) != (at - begin - 4) / 4) return "the size of all items";
  if (word(flash, at + 4) != 0) return "a next block";
  if (word(flash, at + 8) != kBlockEnd) return "no end";
  if ((type & 0xF) != 1) return "no executable image";
  if ((type >> 4 & 3) != 2) return "not secure";
  if ((type >> 8 & 7) != 0) return "not for Arm";
  if ((type >> 12 & 7) != 1) return "not for an RP2350";
  if ((type & 0x88C0) != 0) return "a flag, or a bit that is reserved";
  if (vectors % 128 != 0 || vectors < kFlashBegin || vectors - kFlashBegin + 64 > flash.size()) {
    return "the vector table's place";
  }
  const std::uint32_t stack = word(flash, vectors - kFlashBegin), entry = word(flash, vectors - kFlashBegin + 4);
  if (stack % 8 != 0 || stack <= kRamBegin || stack > kRamEnd) return "the stack";
  if (entry % 2 != 1 || entry < kFlashBegin || entry - kFlashBegin >= flash.size()) return "the entry";
  return "";
}

TEST(BoardPico2, BootRomFindsTheProgram) {
  const Bytes flash = flash_image(kPico2Program);
  ASSERT_GE(flash.size(), kSearched);
  EXPECT_EQ(boot_complaint(flash), "");
  EXPECT_EQ(word(flash, 0), 0x20001000U) << "the top of a stack of 4 KB at the beginning of the RAM";
  for (std::size_t vector = 1; vector < 16; ++vector) {
    EXPECT_EQ(word(flash, 4 * vector) % 2, 1U) << "Thumb code";
    EXPECT_LT(word(flash, 4 * vector), kFlashBegin + flash.size());
  }
}

TEST(BoardPico2, ThereIsOneBlock) {
  const Bytes flash = flash_image(kPico2Program);
  std::size_t begins = 0;
  for (std::size_t at = 0; at + 4 <= flash.size(); at += 4) begins += word(flash, at) == kBlockBegin;
  EXPECT_EQ(begins, 1U) << "another could be taken for it";
}

/// Each word of it counts: the check above would find a wrong one.
TEST(BoardPico2, EachWordOfTheBlockIsNeeded) {
  const Bytes flash = flash_image(kPico2Program);
  const std::size_t begin = first_block(flash);
  ASSERT_LT(begin, kSearched);
  std::size_t end = begin;
  while (word(flash, end) != kBlockEnd) end += 4;
  for (std::size_t at = begin; at <= end; at += 4) {
    for (int bit = 0; bit < 32; ++bit) {
      // What a ROM does not read: the third and fourth byte of the vector table's item, the fourth of the last one.
      const std::uint32_t head = word(flash, at) & 0xFF;
      const bool is_item = at > begin && at < end - 4;
      if (is_item && ((head == 0x03 && bit >= 16) || (head == 0xFF && bit >= 24))) continue;
      // Another multiple of 128 in the flash could be a vector table's address.
      if (word(flash, at) == kFlashBegin && bit >= 7 && bit < 16) continue;
      Bytes changed = flash;
      put_word(changed, at, word(flash, at) ^ 1U << bit);
      EXPECT_NE(boot_complaint(changed), "") << "word " << (at - begin) / 4 << ", bit " << bit;
    }
  }
}

TEST(BoardPico2, Uf2HasTheWholeFlashImage) {
  const Bytes uf2 = uf2_file(kPico2Program);
  if (uf2.empty()) GTEST_SKIP() << "there was no compiler for this machine in the cross build";
  const Bytes flash = flash_image(kPico2Program);
  EXPECT_EQ(uf2_complaint(uf2, flash, 0xE48BFF59), "");
  for (std::size_t at = 0; at < 512; ++at) {
    Bytes changed = uf2;
    changed[at] ^= 1;
    if (at >= 288 && at < 508) continue;  // nobody reads what is behind a block's bytes
    EXPECT_NE(uf2_complaint(changed, flash, 0xE48BFF59), "") << at;
  }
}

}  // namespace
}  // namespace zstrip::boards
