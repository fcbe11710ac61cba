// A test for each row of docs/measured/instructions.csv, InstructionBudget.NAME, and a test of the comparison itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <string>

#include "instruction_table.hpp"
#include "measure.hpp"

namespace zstrip::instruction_budget {
namespace {

const Programs kPrograms{ZSTRIP_COMMAND, ZSTRIP_FIRMWARE_BINARIES};

class KeepsItsBudget : public testing::Test {
 public:
  KeepsItsBudget(const measured::Table& table, const measured::Row& row) : table_(table), row_(row) {}
  void TestBody() override {
    const Case asked = case_of(row_);
    if (!compiled_like(table_, asked)) GTEST_SKIP() << "the figures are those of other compilers";
    const auto figure = measure(asked, kPrograms);
    if (!figure) GTEST_SKIP() << "valgrind, the compiler or the model is missing, or this is a sanitized build";
    EXPECT_EQ(complaint(table_, with_figure(row_, *figure)), "");
    std::cout << asked.name << ": " << *figure << ", recorded " << row_.back() << "\n";
  }

 private:
  const measured::Table& table_;
  const measured::Row& row_;
};

// A program that really is slower: the same frames in strips, whose geometry is transformed again for each. And one
// that is faster: a smaller picture.
TEST(InstructionBudgetCheck, AnotherProgramFails) {
  const measured::Table table = measured::read_table(ZSTRIP_INSTRUCTIONS, instructions_format());
  const auto row = std::ranges::find(table.rows, "m3_k5", [](const measured::Row& each) { return each.front(); });
  ASSERT_NE(row, table.rows.end());
  Case other = case_of(*row);
  if (!compiled_like(table, other)) GTEST_SKIP() << "the figures are those of other compilers";
  other.strip_rows = "80";
  other.frames = 2;
  const auto slower = measure(other, kPrograms);
  ASSERT_TRUE(slower);
  EXPECT_NE(complaint(table, with_figure(*row, *slower)).find("tests/measure instructions m3_k5 accepts it"),
            std::string::npos)
      << *slower;
  other.strip_rows = "auto";
  other.size = "160x120";
  const auto faster = measure(other, kPrograms);
  ASSERT_TRUE(faster);
  EXPECT_NE(complaint(table, with_figure(*row, *faster)).find(", -"), std::string::npos) << *faster;
}

TEST(InstructionBudgetCheck, FramesAreANumber) {
  EXPECT_THROW(case_of({"row", "K5", "m3", "320x240", "streamed", "auto", "z16", "sixty", "1"}), std::runtime_error);
}

}  // namespace
}  // namespace zstrip::instruction_budget

int main(int count, char** words) {
  using namespace zstrip::instruction_budget;
  testing::InitGoogleTest(&count, words);
  try {
    static const zstrip::measured::Table table =
        zstrip::measured::read_table(ZSTRIP_INSTRUCTIONS, instructions_format());
    for (const zstrip::measured::Row& row : table.rows) {
      testing::RegisterTest("InstructionBudget", row.front().c_str(), nullptr, nullptr, __FILE__, __LINE__,
                            [&row]() -> testing::Test* { return new KeepsItsBudget(table, row); });
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return RUN_ALL_TESTS();
}
