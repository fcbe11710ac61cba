// How programs are weighed: which group a name is of, what is a table of the scene, what counts once. And that the
// recorded table is whole.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "programs.hpp"

namespace zstrip::flash {
namespace {

budget::Section section(const char* name, std::uint32_t address, std::uint32_t size) {
  return {name, address, size, std::vector<std::byte>(size)};
}

TEST(FlashGroups, FollowFromNames) {
  EXPECT_EQ(group_of("main"), Group::frame);
  EXPECT_EQ(group_of("memcpy"), Group::library);
  EXPECT_EQ(group_of("__udivmoddi4"), Group::library);
  EXPECT_EQ(group_of("_ZN6zstrip6detail16clip_perspectiveERNS0_11ClipPolygonE"), Group::clipping);
  EXPECT_EQ(group_of("_ZN6zstrip6detail9unclipped13is_box_narrowEv"), Group::set_up) << "what it needs no clipping for";
  EXPECT_EQ(group_of("_ZN6zstrip6detail8EdgeWalkIlE6divideEv"), Group::spans);
  EXPECT_EQ(group_of("_ZN6zstrip6detail6divideEv"), Group::frame) << "into strips";
  EXPECT_EQ(group_of("_ZN6zstrip11divide_longEym"), Group::library);
  EXPECT_EQ(group_of("zstrip_scan_small_thumb"), Group::small_triangles);
  EXPECT_EQ(group_of("_ZN6zstrip8validateERKNS_5SceneE"), Group::checks);
  EXPECT_EQ(group_of("_ZSt11countl_zeroImEiT_"), Group::library) << "not a check that counts";
  EXPECT_EQ(group_of("something_new"), Group::rest);
}

TEST(FlashGroups, TablesAreThoseOfTheScene) {
  EXPECT_TRUE(is_table("_ZN6zstrip6scenes14kKnotPositionsE"));
  EXPECT_TRUE(is_table("_ZN12_GLOBAL__N_16kSceneE"));
  EXPECT_TRUE(is_table("_ZL10kPositions"));
  EXPECT_FALSE(is_table("_ZN6zstrip6detail8kInverseE")) << "of the renderer";
  EXPECT_FALSE(is_table("_ZN12_GLOBAL__N_15kPlanE"));
  EXPECT_FALSE(is_table("keeper"));
}

TEST(FlashWeight, CountsEachByteOnce) {
  budget::ElfFile program;
  program.sections = {
      section(".text", 0, 40), section(".texts", 40, 7), section(".rodata", 48, 32), {".bss", 80, 1000, {}}};
  program.symbols = {{"main", 4, 12, true},
                     {"memmove", 16, 8, true},
                     {"memmove_too", 16, 8, true},
                     {"new_name", 24, 16, true},
                     {"_ZN6zstrip6scenes6kTableE", 48, 24, false},
                     {"_ZN6zstrip6detail8kInverseE", 72, 8, false},
                     {"variable", 80, 1000, false}};
  const Weight weight = weigh(program, {});
  EXPECT_EQ(weight.of(Group::frame), 12U);
  EXPECT_EQ(weight.of(Group::library), 8U + 8U);
  EXPECT_EQ(weight.of(Group::texts), 7U);
  EXPECT_EQ(weight.of(Group::rest), 4U + 16U) << "what has no name, and what no pattern fits";
  EXPECT_EQ(weight.tables, 24U);
  EXPECT_EQ(weight.bytes(), 40U + 7U + 8U);
  const std::string lines = complaint_of_rest("it", weight);
  EXPECT_NE(lines.find("it: more than a tenth"), std::string::npos) << lines;
  EXPECT_NE(lines.find("16 bytes: new_name"), std::string::npos) << lines;
}

TEST(FlashWeight, InlinedCodeIsOfTheFunctionThatItIsOf) {
  budget::ElfFile program;
  program.sections = {section(".text", 0x100, 12)};
  program.symbols = {{"main", 0x100, 12, true}};
  const Inlined inlined = parse_inlined(
      "0x00000100\n_ZN6zstrip10reciprocalEm\nmath.hpp:3\n_ZN6zstrip6detail8crossingEv\nclip.cpp:5\nmain\nmain.cpp:1\n"
      "0x00000102\n_ZN6zstrip6detail8crossingEv\nclip.cpp:6\nmain\nmain.cpp:1\n"
      "0x00000104\n_ZN6zstrip10reciprocalEm\nmath.hpp:3\nmain\nmain.cpp:2\n"
      "0x00000106\n??\n??:0\n"
      "0x00000108\nmain\nmain.cpp:3\n");
  EXPECT_FALSE(inlined.contains(0x106));
  const Weight weight = weigh(program, inlined);
  EXPECT_EQ(weight.of(Group::clipping), 4U);
  EXPECT_EQ(weight.of(Group::frame), 8U) << "of which 2 are arithmetic, 2 unknown and 2 not even asked for";
  EXPECT_EQ(weight.bytes(), 12U);
}

TEST(FlashWeight, ATenthThatFitsNoPatternIsAllowed) {
  Weight weight;
  weight.groups[static_cast<std::size_t>(Group::spans)] = 90;
  weight.groups[static_cast<std::size_t>(Group::rest)] = 10;
  EXPECT_EQ(complaint_of_rest("it", weight), "");
  ++weight.groups[static_cast<std::size_t>(Group::rest)];
  EXPECT_NE(complaint_of_rest("it", weight), "");
}

TEST(FlashTable, HasEveryProgram) {
  const measured::Table table = measured::read_table(ZSTRIP_MEASURED "/flash.csv", flash_format());
  EXPECT_EQ(table.rows.size(), std::size(kPrograms) * std::size(kMachines) * std::size(kPresets));
  for (const Program& program : kPrograms) {
    for (const Machine& machine : kMachines) {
      for (const Preset& preset : kPresets) {
        EXPECT_NE(table.find({program.name, machine.name, preset.name}), nullptr) << program.name << machine.name;
      }
    }
  }
}

TEST(FlashTable, PageIsWrittenFromIt) {
  std::ifstream stream(ZSTRIP_MEASURED "/flash.md");
  const std::string page{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_EQ(page, flash_page(measured::read_table(ZSTRIP_MEASURED "/flash.csv", flash_format())))
      << "tests/measure flash writes both";
}

}  // namespace
}  // namespace zstrip::flash
