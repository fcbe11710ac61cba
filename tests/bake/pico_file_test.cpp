// .uf2 files for the Pico and Pico 2: what the command writes is what the boot loader takes, and files that it reads
// may hold anything.
#include <array>
#include <filesystem>

#include "bake/pico_scene.hpp"
#include "bake/uf2_file.hpp"
#include "bake_fixture.hpp"

namespace zstrip::sim::test {
namespace {

using pico::kPico;
using pico::kPico2;
using pico::Page;
using pico::Pages;
using Bytes = std::vector<std::uint8_t>;

Page page_of(std::uint8_t value) {
  Page page;
  page.fill(value);
  return page;
}

/// What read_uf2 says of a file of three pages in whose block `block` the word at `at` is another one.
std::string said_of(std::size_t block, std::size_t at, std::uint32_t value) {
  Bytes file = pico::to_uf2({{pico::kFlash, page_of(1)},
                             {pico::kFlash + pico::kPage, page_of(2)},
                             {pico::kFlash + 2 * pico::kPage, page_of(3)}},
                            kPico);
  for (std::size_t i = 0; i < 4; ++i) {
    file[block * pico::kBlock + at + i] = static_cast<std::uint8_t>(value >> (8 * i));
  }
  const Result<Pages> read = read_uf2(file, kPico);
  return read ? "" : read.failure().message;
}

TEST(Uf2, ReadsWhatItWrites) {
  const Pages pages{{pico::kFlash, page_of(1)}, {pico::kFlash + pico::kPage, page_of(2)}};
  for (const pico::Board& board : {kPico, kPico2}) {
    const Bytes file = pico::to_uf2(pages, board);
    const Result<Pages> read = read_uf2(file, board);
    ASSERT_TRUE(read) << read.failure().message;
    EXPECT_EQ(*read, pages);
    EXPECT_FALSE(read_uf2(file, board.family == kPico.family ? kPico2 : kPico)) << "of the other board";
  }
}

TEST(Uf2, FlashOfAPico2IsLarger) {
  const Pages last{{0x103FFF00, page_of(1)}}, behind{{0x10400000, page_of(1)}};
  EXPECT_TRUE(read_uf2(pico::to_uf2(last, kPico2), kPico2));
  EXPECT_FALSE(read_uf2(pico::to_uf2(last, kPico), kPico));
  const Result<Pages> refused = read_uf2(pico::to_uf2(behind, kPico2), kPico2);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.failure().message.find("the Pico 2's flash: block 0 has 256 bytes for address 10400000"),
            std::string::npos)
      << refused.failure().message;
}

// Erratum RP2040-E14: else the loader erases a sector at the wrong time.
TEST(Uf2, SectorsAreWholeBeforeAGap) {
  const std::uint32_t far = pico::kFlash + 5 * pico::kSector;
  const Pages pages{{pico::kFlash + pico::kPage, page_of(1)}, {far + pico::kPage, page_of(2)}};
  const Result<Pages> read = read_uf2(pico::to_uf2(pages, kPico), kPico);
  ASSERT_TRUE(read) << read.failure().message;
  ASSERT_EQ(read->size(), pico::kSector / pico::kPage + 2);
  std::uint32_t number = 0;
  for (const auto& [address, page] : *read) {
    const std::uint32_t expected =
        number < 16 ? pico::kFlash + number * pico::kPage : far + (number - 16) * pico::kPage;
    EXPECT_EQ(address, expected);
    EXPECT_EQ(page, pages.contains(address) ? pages.at(address) : page_of(0xFF));
    ++number;
  }
}

TEST(Uf2, RefusesWhatIsNoFileForThePico) {
  const auto expect = [](std::size_t block, std::size_t at, std::uint32_t value, const char* words) {
    const std::string said = said_of(block, at, value);
    EXPECT_NE(said.find(words), std::string::npos) << at << ": " << said;
  };
  ASSERT_EQ(said_of(1, 20, 1), "");  // as it was
  expect(1, 0, 0x0A324656, "block 1 does not begin and end as one");
  expect(2, 4, 0, "block 2 does not begin and end as one");
  expect(0, 508, 0, "block 0 does not begin and end as one");
  expect(1, 8, 0x2001, "block 1 is not for the RP2040");       // not main flash
  expect(1, 28, 0xE48BFF57, "block 1 is not for the RP2040");  // another family
  expect(1, 20, 2, "block 1 says that it is 2 of 3, and there are 3");
  expect(1, 24, 4, "block 1 says that it is 1 of 4, and there are 3");
  expect(1, 16, 476, "block 1 has 476 bytes");
  expect(1, 12, 0x10000101, "address 10000101");
  expect(1, 12, 0x20000000, "address 20000000");
  expect(1, 12, 0x0FFFFF00, "address 0fffff00");
  expect(1, 12, 0x10200000, "address 10200000");
  expect(1, 12, 0x10000000, "as one before it does");
  EXPECT_FALSE(read_uf2({}, kPico));
  Bytes cut = pico::to_uf2({{pico::kFlash, page_of(1)}}, kPico);
  cut.pop_back();
  EXPECT_FALSE(read_uf2(cut, kPico));
}

TEST(PicoFile, HasNoSceneThatIsLargerThanItsPlace) {
  constexpr std::size_t kMegabyte = 1 << 20;
  for (const auto& [board, size] : {std::pair{kPico, kMegabyte}, {kPico2, 3 * kMegabyte}}) {
    Bytes blob(size);
    EXPECT_TRUE(to_pico_file(blob, {}, board));
    blob.resize(size + 4);
    const Result<Bytes> refused = to_pico_file(blob, {}, board);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.failure().status, ExitStatus::budget);
  }
}

class BakePico : public Bake {
 protected:
  Pages pages(const std::string& name, const pico::Board& board = kPico) {
    const std::string file = read(path(name));
    const Result<Pages> found = read_uf2({reinterpret_cast<const std::uint8_t*>(file.data()), file.size()}, board);
    EXPECT_TRUE(found) << found.failure().message;
    return found ? *found : Pages{};
  }
  std::string file_of(const Pages& content, const std::string& name, const pico::Board& board = kPico) {
    const Bytes bytes = pico::to_uf2(content, board);
    return file(name, std::string(bytes.begin(), bytes.end()));
  }
  /// What only looks like one: it says what it reads, and which board's player it is.
  static Pages program(const pico::Board& board = kPico) {
    Page page = page_of(0x11);
    std::ranges::copy(std::string_view(board.no_scene), page.begin() + 50);
    return {{pico::kFlash, page_of(0x22)}, {pico::kFlash + pico::kPage, page}};
  }
};

TEST_F(BakePico, FileHasTheBlobAtItsPlaceAloneOrBesideAProgram) {
  const std::vector<std::string> picture{"--size", "240x240", "--format", "rgb565_swapped"};
  std::vector<std::string> bake{"bake", kHouseModel, "-o", "house.zsc"};
  bake.insert(bake.end(), picture.begin(), picture.end());
  report(bake);
  const std::string blob = read(path("house.zsc"));
  const Json baked = report({"bake", kHouseModel, "-o", "house.uf2"});
  EXPECT_LE(baked.at("plan").at("ram_bytes").at("arena").get<std::uint32_t>(), kPico.player_memory);
  report({"bake", kHouseModel, "-o", "both.uf2", "--with", file_of(program(), "program.uf2")});

  const Pages alone = pages("house.uf2"), both = pages("both.uf2");
  ASSERT_EQ(alone.size(), (blob.size() + pico::kPage - 1) / pico::kPage);
  std::string content;
  for (const auto& [address, page] : alone) {
    EXPECT_EQ(address, pico::kScene + content.size());
    content.append(page.begin(), page.end());
    EXPECT_EQ(both.at(address), page);
  }
  EXPECT_EQ(content.substr(0, blob.size()), blob);
  for (const auto& [address, page] : program()) EXPECT_EQ(both.at(address), page);
  EXPECT_EQ(both.size(), alone.size() + pico::kSector / pico::kPage);
}

/// By the numbers of its documents, not by the command's own.
TEST_F(BakePico, FileForAPico2HasItsFamilyAndTheSameBlob) {
  report({"bake", kHouseModel, "-o", "house.uf2"});
  report({"bake", kHouseModel, "-o", "house2.uf2", "--board", "pico2"});
  report({"bake", kHouseModel, "-o", "both2.uf2", "--board", "pico2", "--with",
          file_of(program(kPico2), "2.uf2", kPico2)});
  for (const std::string name : {"house2.uf2", "both2.uf2"}) {
    const std::string file = read(path(name));
    ASSERT_EQ(file.size() % 512, 0U);
    for (std::size_t block = 0; block < file.size(); block += 512) {
      EXPECT_EQ(file.substr(block + 28, 4), "\x59\xFF\x8B\xE4") << name << ", block " << block / 512;
    }
  }
  const Pages alone = pages("house2.uf2", kPico2), both = pages("both2.uf2", kPico2);
  EXPECT_EQ(alone.begin()->first, 0x10100000U);
  EXPECT_EQ(alone, pages("house.uf2"));
  for (const auto& [address, page] : alone) EXPECT_EQ(both.at(address), page);
  for (const auto& [address, page] : program(kPico2)) EXPECT_EQ(both.at(address), page);
}

TEST_F(BakePico, Pico2HasMemoryForMore) {
  const std::vector<std::string> bake{"bake", "random10k", "--strip-rows", "60", "-o", "x.uf2"};
  EXPECT_EQ(zstrip(bake).status, 5);
  std::vector<std::string> bake_for_pico2 = bake;
  bake_for_pico2.insert(bake_for_pico2.end(), {"--board", "pico2"});
  const Json baked = report(bake_for_pico2);
  const auto arena = baked.at("plan").at("ram_bytes").at("arena").get<std::uint32_t>();
  EXPECT_GT(arena, kPico.player_memory);
  EXPECT_LE(arena, kPico2.player_memory);
}

/// Of the player, whether the option names it or it is the program of the file.
TEST_F(BakePico, HotCodeLeavesLessMemory) {
  const auto status_of = [this](const std::vector<std::string>& options) {
    std::vector<std::string> bake{"bake", "random10k", "-o", "x.uf2"};
    bake.insert(bake.end(), options.begin(), options.end());
    return zstrip(bake);
  };
  // With a program that has too little, the board alone would not help.
  const auto refused = [&](const std::vector<std::string>& options, const std::string& with = "") {
    const Outcome outcome = status_of(options);
    EXPECT_EQ(outcome.status, 5) << outcome.err;
    for (const std::string& words :
         {std::string("'random10k' takes 24"), std::string(" bytes of RAM, of the arena most for vertices; "),
          std::string("; zstrip_pico_player_hot has 223,232 for a scene; "),
          "; zstrip_pico_player has enough: --board pico" + with + "\n"}) {
      EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    }
    EXPECT_FALSE(std::filesystem::exists(path("x.uf2")));
  };
  const std::string usual = file_of(program(), "usual.uf2"), hot = file_of(program(pico::kPicoHot), "hot.uf2");
  refused({"--board", "pico_hot"});
  refused({"--with", hot}, " --with zstrip_pico_player.uf2");
  refused({"--board", "pico_hot", "--with", usual}, " --with zstrip_pico_player.uf2");
  refused({"--board", "pico_hot", "--split-columns", "--strip-buffers", "1"});  // the program plans without
  EXPECT_EQ(status_of({}).status, 0);
  EXPECT_EQ(status_of({"--with", usual}).status, 0);
  EXPECT_EQ(status_of({"--board", "pico2_hot"}).status, 0);
  EXPECT_EQ(status_of({"--board", "pico2_hot", "--with", file_of(program(kPico2), "2.uf2", kPico2)}).status, 0);
}

/// Of four boards, by a scene of which the program keeps more than any of them has.
TEST_F(BakePico, SceneThatNoPlayerHasMemoryForIsSaid) {
  std::string scene = "model = [{ name = \"cube\", built_in = \"cube\" }]\ninstance = [";
  for (int i = 0; i < 4000; ++i) scene += "{ model = \"cube\" },";
  file("many.toml", scene + "]\n");
  for (const pico::Board* const board : pico::kBoards) {
    const Outcome outcome = zstrip({"bake", "many.toml", "-o", "x.uf2", "--board", board->name});
    EXPECT_EQ(outcome.status, 5);
    EXPECT_NE(outcome.err.find(std::string("of the arena most for instances; ") + board->player + " has "),
              std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find("; take fewer vertices or instances\n"), std::string::npos) << outcome.err;
  }
}

TEST_F(BakePico, ProgramsThatWouldNotShowItAreRefused) {
  const auto refused = [this](const std::string& output, const std::string& with, int status, const char* words) {
    const Outcome outcome = zstrip({"bake", kHouseModel, "-o", output, "--with", with});
    EXPECT_EQ(outcome.status, status);
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(path(output)));
  };
  const std::string good = file_of(program(), "program.uf2");
  refused("house.zsc", good, 2, "--with is the program of a file for the Raspberry Pi Pico");
  refused("x.uf2", file_of(program(), "pico2.uf2", kPico2), 4, "block 0 is not for the RP2040");
  refused("x.uf2", "nothing.uf2", 4, "does not exist");
  refused("x.uf2", file("text.uf2", "text"), 4, "is not a .uf2 file");
  refused("x.uf2", file_of({{pico::kFlash, page_of(1)}}, "other.uf2"), 4, "is not the program");
  Pages without_boot_stage = program();
  without_boot_stage.erase(pico::kFlash);
  without_boot_stage[pico::kFlash + pico::kSector] = program().rbegin()->second;
  without_boot_stage.erase(pico::kFlash + pico::kPage);
  refused("x.uf2", file_of(without_boot_stage, "no_boot.uf2"), 4, "is not the program");
  Pages with_scene = program();
  with_scene[pico::kScene] = page_of(0);
  refused("x.uf2", file_of(with_scene, "scene.uf2"), 4, "where the scene goes");
  const Outcome over = zstrip({"bake", kHouseModel, "-o", "program.uf2", "--with", "program.uf2"});
  EXPECT_EQ(over.status, 2);
  EXPECT_EQ(pages("program.uf2"), program());
}

TEST_F(BakePico, BoardsAreForTheirFiles) {
  const auto refused = [this](std::vector<std::string> bake, int status, const char* words) {
    bake.insert(bake.begin(), {"bake", kHouseModel});
    const Outcome outcome = zstrip(bake);
    EXPECT_EQ(outcome.status, status);
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  };
  refused({"-o", "x.zsc", "--board", "pico_hot"}, 2, "--board");
  refused({"-o", "x.uf2", "--board", "bluepill"}, 2, "-o FILE.uf2: --board");
  refused({"-o", "x.uf2", "--board", "pico3"}, 2, "pico2");
  const std::string good = file_of(program(), "program.uf2");
  refused({"-o", "x.uf2", "--board", "pico2", "--with", good}, 4, "block 0 is not for the RP2350");
  const std::string other = file_of({{pico::kFlash, page_of(1)}}, "other2.uf2", kPico2);
  refused({"-o", "x.uf2", "--board", "pico2", "--with", other}, 4, "take zstrip_pico2_player.uf2");
}

/// They were baked without a word, and the panel showed 240x240 pixels of them.
TEST_F(BakePico, PicturesThatThePanelDoesNotShowAreRefused) {
  const auto refused = [this](const std::vector<std::string>& options, const std::string& words) {
    std::vector<std::string> bake{"bake", kHouseModel, "-o", "x.uf2"};
    bake.insert(bake.end(), options.begin(), options.end());
    const Outcome outcome = zstrip(bake);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(path("x.uf2")));
  };
  refused({"--size", "320x480"}, "--size 320x480: the program for the Pico shows pictures of 240x240 pixels");
  refused({"--format", "mono"}, "--format mono: the program for the Pico draws rgb565_swapped");
  EXPECT_EQ(zstrip({"bake", kHouseModel, "-o", "X.UF2", "--size", "240x240"}).status, 0);
}

TEST_F(BakePico, WhatTheProgramCannotDrawIsSaidWhenItIsBaked) {
  const std::string scene = "[picture]\ndepth_format = \"z24\"\n[[model]]\nname = \"house\"\nfile = \"" + kHouseModel +
                            "\"\n[[instance]]\nmodel = \"house\"\n";
  const Outcome depth = zstrip({"bake", file("z24.toml", scene), "-o", "x.uf2"});
  EXPECT_EQ(depth.status, 2);
  EXPECT_NE(depth.err.find("leave 'depth_format' out"), std::string::npos) << depth.err;
  const Outcome large = zstrip({"bake", "random10k", "--strip-rows", "60", "-o", "x.uf2"});
  EXPECT_EQ(large.status, 5);
  EXPECT_FALSE(std::filesystem::exists(path("x.uf2")));
}

}  // namespace
}  // namespace zstrip::sim::test
