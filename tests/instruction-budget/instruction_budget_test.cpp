// A test for each row of budgets.csv, InstructionBudget.NAME, and tests of the comparison itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "budget_row.hpp"
#include "measure.hpp"

namespace zstrip::instruction_budget {
namespace {

const Programs kPrograms{ZSTRIP_COMMAND, ZSTRIP_FIRMWARE_BINARIES};

// Figures of other compilers are no budget.
bool compiled_like(const BudgetFile& budgets, const BudgetRow& row) {
  const Compilers here = compilers_here();
  return row.target == "host" ? here.host == budgets.compilers.host : here.board == budgets.compilers.board;
}

class KeepsItsBudget : public testing::Test {
 public:
  KeepsItsBudget(const BudgetFile& budgets, const BudgetRow& row) : budgets_(budgets), row_(row) {}
  void TestBody() override {
    if (!compiled_like(budgets_, row_)) GTEST_SKIP() << "the budgets are those of other compilers";
    const auto measured = measure(row_, kPrograms);
    if (!measured) GTEST_SKIP() << "valgrind is missing, or this is a sanitized build";
    EXPECT_EQ(complaint(row_, *measured), "");
    std::cout << row_.name << ": " << *measured << " of " << row_.most << "\n";
  }

 private:
  const BudgetFile& budgets_;
  const BudgetRow& row_;
};

TEST(InstructionBudgetCheck, TwoPercentAreAllowedAndNoMore) {
  BudgetRow row;
  row.name = "row";
  row.most = 100'000;
  EXPECT_EQ(complaint(row, 0), "");
  EXPECT_EQ(complaint(row, 102'000), "");
  EXPECT_NE(complaint(row, 102'001).find("2.00 % over"), std::string::npos) << complaint(row, 102'001);
  EXPECT_NE(complaint(row, 150'000).find("50.00 % over"), std::string::npos) << complaint(row, 150'000);
}

TEST(InstructionBudgetCheck, ARowWithoutABudgetFails) { EXPECT_NE(complaint(BudgetRow{}, 1), ""); }

// A program that really is slower: the same frames in strips, whose geometry is transformed again for each.
TEST(InstructionBudgetCheck, ASlowerProgramFails) {
  const BudgetFile budgets = read_budgets(ZSTRIP_INSTRUCTION_BUDGETS);
  const auto row = std::ranges::find(budgets.rows, "m3_k5", &BudgetRow::name);
  ASSERT_NE(row, budgets.rows.end());
  if (!compiled_like(budgets, *row)) GTEST_SKIP() << "the budgets are those of other compilers";
  BudgetRow slower = *row;
  slower.strip_rows = "80";
  slower.frames = 2;
  const auto measured = measure(slower, kPrograms);
  ASSERT_TRUE(measured);
  EXPECT_NE(complaint(*row, *measured).find("% over its budget"), std::string::npos) << *measured;
}

TEST(InstructionBudgetCheck, AFileReadsAsItWasWritten) {
  const BudgetFile budgets = read_budgets(ZSTRIP_INSTRUCTION_BUDGETS);
  ASSERT_FALSE(budgets.rows.empty());
  const std::filesystem::path copy = std::filesystem::path(testing::TempDir()) / "zstrip_instruction_budgets.csv";
  write_budgets(copy, budgets);
  const auto text = [](const std::filesystem::path& file) {
    std::ifstream stream(file);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  EXPECT_EQ(text(copy), text(ZSTRIP_INSTRUCTION_BUDGETS));
  std::ofstream(copy, std::ios::app) << "row,K5,m3,320x240,streamed,auto,z16,sixty,1\n";
  EXPECT_THROW(read_budgets(copy), std::runtime_error);
  std::filesystem::remove(copy);
}

}  // namespace
}  // namespace zstrip::instruction_budget

int main(int count, char** words) {
  using namespace zstrip::instruction_budget;
  testing::InitGoogleTest(&count, words);
  try {
    static const BudgetFile budgets = read_budgets(ZSTRIP_INSTRUCTION_BUDGETS);
    for (const BudgetRow& row : budgets.rows) {
      testing::RegisterTest("InstructionBudget", row.name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                            [&row]() -> testing::Test* { return new KeepsItsBudget(budgets, row); });
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return RUN_ALL_TESTS();
}
