// The Pico 2's programs as files: what the RP2350's boot ROM looks for in the flash before it starts a program, read as
// the ROM reads it (RP2350 data sheet, 5.9), and the .uf2 file against the .elf file.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "pico_files.hpp"
#include "programs.hpp"

namespace zstrip::boards {
namespace {

constexpr const char* kPico2Program = "zstrip_pico2_show";
constexpr const char* kPico2Player = "zstrip_pico2_player";
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

/// The stack is at the beginning of the RAM.
void expect_to_start(const Bytes& flash, std::uint32_t stack_bytes) {
  ASSERT_GE(flash.size(), kSearched);
  EXPECT_EQ(boot_complaint(flash), "");
  EXPECT_EQ(word(flash, 0), kRamBegin + stack_bytes);
  for (std::size_t vector = 1; vector < 16; ++vector) {
    EXPECT_EQ(word(flash, 4 * vector) % 2, 1U) << "Thumb code";
    EXPECT_LT(word(flash, 4 * vector), kFlashBegin + flash.size());
  }
  std::size_t begins = 0;
  for (std::size_t at = 0; at + 4 <= flash.size(); at += 4) begins += word(flash, at) == kBlockBegin;
  EXPECT_EQ(begins, 1U) << "another could be taken for the block";
}

TEST(BoardPico2, BootRomFindsTheProgram) { expect_to_start(flash_image(kPico2Program), 4096); }

TEST(BoardPico2, BootRomFindsTheProgramThatShowsBakedScenes) { expect_to_start(flash_image(kPico2Player), 8192); }

#ifdef ZSTRIP_RISCV_PROGRAMS
/// The block is the first of the flash; entry and stack stand in it.
TEST(BoardPico2, BootRomFindsTheProgramForRiscv) {
  const Bytes flash = flash_image("zstrip_pico2_riscv_show", "riscv64-unknown-elf");
  ASSERT_GE(flash.size(), kSearched);
  const std::uint32_t entry = word(flash, 12);
  const std::uint32_t block[] = {kBlockBegin,      0x11010142, 0x00000344, entry,
                                 kRamBegin + 4096, 0x000004FF, 0,          kBlockEnd};
  for (std::size_t i = 0; i < std::size(block); ++i) EXPECT_EQ(word(flash, 4 * i), block[i]) << "word " << i;
  EXPECT_EQ(entry % 2, 0U);
  EXPECT_GE(entry, kFlashBegin + sizeof block);
  EXPECT_LT(entry, kFlashBegin + flash.size());
}
#endif

/// What `zstrip bake --board pico2 --with` reads.
TEST(BoardPico2, ProgramThatShowsBakedScenesLeavesTheirPlaceAndNamesIt) {
  const Bytes flash = flash_image(kPico2Player);
  constexpr std::size_t kScene = 0x100000;
  EXPECT_LE(flash.size(), kScene);
  constexpr std::string_view kWords =
      "no scene of version 6 at 10100000 in the flash. zstrip bake MODEL -o scene.uf2 --board pico2";
  EXPECT_NE(std::search(flash.begin(), flash.end(), kWords.begin(), kWords.end()), flash.end());
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

#ifdef ZSTRIP_COMMAND
/// The command's file is the whole program, which the boot ROM finds, and the scene's blob at its address.
TEST(BoardPico2, BakedFileHasTheProgramAndTheScene) {
  const std::filesystem::path player = program(kPico2Player).replace_extension(".uf2");
  if (!std::filesystem::exists(player)) GTEST_SKIP() << "there was no compiler for this machine in the cross build";
  const std::string folder = std::filesystem::path(testing::TempDir()) / ("pico2-" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  const std::string bake = "'" ZSTRIP_COMMAND "' bake teapot --quiet -o '" + folder;
  ASSERT_EQ(std::system((bake + "/scene.zsc' --size 240x240 --format rgb565_swapped").c_str()), 0);
  ASSERT_EQ(std::system((bake + "/both.uf2' --board pico2 --with '" + player.string() + "'").c_str()), 0);
  const Bytes blob = file_contents(folder + "/scene.zsc"), uf2 = file_contents(folder + "/both.uf2");
  std::filesystem::remove_all(folder);
  ASSERT_FALSE(blob.empty());
  for (std::size_t block = 0; block < uf2.size(); block += 512) ASSERT_EQ(word(uf2, block + 28), 0xE48BFF59U);

  Bytes flash, scene;
  for (const auto& [address, page] : uf2_pages(uf2)) {
    Bytes& part = address < 0x10100000 ? flash : scene;
    ASSERT_EQ(address, (address < 0x10100000 ? 0x10000000 : 0x10100000) + part.size());
    part.insert(part.end(), page.begin(), page.end());
  }
  const Bytes image = flash_image(kPico2Player);
  ASSERT_GE(flash.size(), image.size());
  EXPECT_TRUE(std::equal(image.begin(), image.end(), flash.begin()));
  EXPECT_EQ(boot_complaint(flash), "");
  ASSERT_GE(scene.size(), blob.size());
  EXPECT_TRUE(std::equal(blob.begin(), blob.end(), scene.begin()));
}
#endif

TEST(BoardPico2, Uf2HasTheWholeFlashImage) {
  for (const char* const program : {kPico2Program, kPico2Player}) {
    const Bytes uf2 = uf2_file(program);
    if (uf2.empty()) GTEST_SKIP() << "there was no compiler for this machine in the cross build";
    EXPECT_EQ(uf2_complaint(uf2, flash_image(program), 0xE48BFF59), "") << program;
  }
}

TEST(BoardPico2, Uf2IsReadByteByByte) {
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
