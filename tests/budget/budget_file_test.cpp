// The comparison with budgets itself: it fails when it must, and says by how much and why.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "budget_file.hpp"
#include "memory_page.hpp"

namespace zstrip::budget {
namespace {

const Target kTarget{"a board", "a_program", "a machine", "a_scene", "", {8, 8}, Report::turntable, 0};

Usage small_usage() {
  Usage usage{.target = &kTarget};
  usage.code = 1000;
  usage.constants = 512;
  usage.arena = 96;
  usage.pixels = 128;
  usage.statics = 60;
  usage.stack_bound = 700;
  return usage;
}

/// A file of this test only.
std::filesystem::path scratch_file() {
  return std::filesystem::path(testing::TempDir()) /
         (std::string("zstrip_budget_") + testing::UnitTest::GetInstance()->current_test_info()->name());
}

Budgets budgets_of(const Usage& usage) {
  write_budgets(scratch_file(), {&usage, 1});
  Budgets budgets = read_budgets(scratch_file());
  std::filesystem::remove(scratch_file());
  return budgets;
}

TEST(Budget, IsKeptByWhatItWasMadeFrom) { EXPECT_EQ(over_budget(small_usage(), budgets_of(small_usage())), ""); }

TEST(Budget, SaysByHowMuchItIsExceeded) {
  const Budgets budgets = budgets_of(small_usage());
  for (const auto& [member, line] :
       {std::pair{&Usage::code, "code: 1025 bytes, 1 over the budget of 1024\n"},
        std::pair{&Usage::constants, "constants: 1025 bytes, 513 over the budget of 512\n"},
        std::pair{&Usage::initial_data, "initial_data: 1025 bytes, 1025 over the budget of 0\n"},
        std::pair{&Usage::arena, "arena: 1025 bytes, 929 over the budget of 96\n"},
        std::pair{&Usage::pixels, "pixels: 1025 bytes, 897 over the budget of 128\n"},
        std::pair{&Usage::statics, "statics: 1025 bytes, 961 over the budget of 64\n"},
        std::pair{&Usage::stack_bound, "stack: 1025 bytes, 321 over the budget of 704\n"}}) {
    Usage grown = small_usage();
    grown.*member = 1025;
    EXPECT_EQ(over_budget(grown, budgets), line);
  }
}

TEST(Budget, OfAnUnknownProgramIsNone) { EXPECT_EQ(over_budget(small_usage(), {}), "it has no budget\n"); }

TEST(Budget, NamesTheSymbolsThatGrew) {
  std::vector<SymbolSize> before{{"large", 100, false}, {"middle<1, 2>", 50, false}, {"variable", 8, true}};
  while (before.size() < kSymbolsOfMemory + 1) before.push_back({std::string(before.size(), 'f'), 20, false});
  std::vector<SymbolSize> now = before;
  EXPECT_EQ(grown_symbols(now, before), "");
  now[0].bytes = 101;
  now[1].bytes = 90;
  now[2].bytes = 12;
  now[3].bytes = 19;
  now.push_back({"fresh", 70, false});
  now.push_back({"tiny", 20, false});
  now.push_back({"large", 2, true});
  EXPECT_EQ(grown_symbols(now, before),
            "  flash, 70 bytes, not among the largest before: fresh\n"
            "  flash, 90 bytes, grown by 40: middle<1, 2>\n"
            "  RAM, 12 bytes, grown by 4: variable\n"
            "  RAM, 2 bytes, not among the largest before: large\n"
            "  flash, 101 bytes, grown by 1: large\n");
}

TEST(Budget, SymbolsAreReadAsTheyWereWritten) {
  SymbolTable symbols{{"one", {{"f<1, 2>", 7, false}, {"g", 6, true}}}, {"two", {{"h", 5, false}}}};
  write_symbols(scratch_file(), symbols);
  const SymbolTable read = read_symbols(scratch_file());
  std::filesystem::remove(scratch_file());
  ASSERT_EQ(read.size(), 2U);
  ASSERT_EQ(read.at("one").size(), 2U);
  EXPECT_EQ(read.at("one")[0].name, "f<1, 2>");
  EXPECT_EQ(read.at("one")[0].bytes, 7U);
  EXPECT_FALSE(read.at("one")[0].in_ram);
  EXPECT_TRUE(read.at("one")[1].in_ram);
  EXPECT_EQ(read.at("two")[0].name, "h");
}

TEST(Budget, RefusesAFileThatIsNone) {
  const std::string header = "program,scene,code,constants,initial_data,arena,pixels,statics,stack\n";
  for (const std::string& text :
       {std::string(), std::string("program,scene\n"), header + "a,b,1,2,3,4,5,6\n", header + "a,b,1,2,3,4,5,6,x\n",
        header + "a,b,1,2,3,4,5,6,-7\n", header + "a,b,1,2,3,4,5,6,99999999999\n",
        header + "a,b,1,2,3,4,5,6,7\na,b,1,2,3,4,5,6,7\n"}) {
    std::ofstream(scratch_file()) << text;
    EXPECT_THROW(read_budgets(scratch_file()), std::runtime_error) << text;
  }
  std::filesystem::remove(scratch_file());
  EXPECT_THROW(read_budgets(scratch_file()), std::runtime_error);
}

TEST(Budget, TablesStandBetweenTheirMarks) {
  const std::string begin = "<!-- tests/budget/update writes from here -->\n", end = "<!-- to here -->\n";
  EXPECT_EQ(page_with_tables("a\n" + begin + "old\n" + end + "b\n", "new\n"), "a\n" + begin + "new\n" + end + "b\n");
  EXPECT_THROW(page_with_tables("a\n" + begin, "new\n"), std::runtime_error);
  EXPECT_THROW(page_with_tables(end + begin, "new\n"), std::runtime_error);
}

}  // namespace
}  // namespace zstrip::budget
