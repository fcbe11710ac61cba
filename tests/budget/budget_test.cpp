// Every program for a board, with every scene that it draws, against its budget; and the page that says what they take.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "budget_file.hpp"
#include "memory_page.hpp"
#include "usage.hpp"

namespace zstrip::budget {
namespace {

const std::filesystem::path kBinaries = ZSTRIP_FIRMWARE_BINARIES;
const std::filesystem::path kRoot = ZSTRIP_ROOT;
const std::filesystem::path kFolder = kRoot / "tests/budget";
constexpr const char* kAdvice = "if it is worth it: tests/budget/update writes what it takes now";

class ProgramBudget : public testing::Test {
 public:
  explicit ProgramBudget(const Target& target) : target_(target) {}
  void TestBody() override {
    const Usage usage = measure(target_, kBinaries);
    const std::string over = over_budget(usage, read_budgets(kFolder / "budgets.csv"));
    if (!over.empty()) {
      const SymbolTable before = read_symbols(kFolder / "symbols.csv");
      const auto known = before.find(target_.program);
      ADD_FAILURE() << over
                    << grown_symbols(symbol_sizes(file_of(target_, kBinaries)),
                                     known == before.end() ? std::vector<SymbolSize>{} : known->second)
                    << kAdvice;
    }
    if (target_.report != Report::none) {
      EXPECT_GT(usage.stack_measured, 0U);
    }
    EXPECT_LE(usage.stack_measured, usage.stack_bound) << "the bound of the stack is wrong";
    EXPECT_LE(usage.stack_bound + target_.stack_guard, usage.stack_reserved) << "the linker script gives it too little";
  }

 private:
  const Target& target_;
};

[[maybe_unused]] const bool kRegistered = [] {
  for (const Target& target : targets()) {
    const std::string name =
        std::string(target.program) + (target.report == Report::bench ? std::string("_") + target.scene : "");
    testing::RegisterTest("Budget", name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                          [&target]() -> testing::Test* { return new ProgramBudget(target); });
  }
  return true;
}();

TEST(Budget, EveryProgramHasOne) {
  std::set<std::string> known;
  for (const Target& target : targets()) known.insert(file_of(target, kBinaries).filename());
  std::size_t found = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kBinaries)) {
    const std::string name = entry.path().filename();
    if (entry.path().extension() != ".elf") continue;
    ++found;
    // The page's board; boards with megabytes; programs of tests and measurements.
    if (name.starts_with("zstrip_my_board_") || name.starts_with("zstrip_versatilepb_") ||
        name.starts_with("zstrip_riscv_virt_"))
      continue;
    if (name.starts_with("zstrip_self_test_") || name.starts_with("zstrip_bench_bins_") ||
        name.starts_with("zstrip_bench_depth_") || name.starts_with("zstrip_bench_visibility_") ||
        name.starts_with("zstrip_store_bench_") || name.starts_with("zstrip_pipeline_") ||
        name == "zstrip_lm3s6965evb_display_test.elf" || name == "zstrip_lm3s6965evb_stuck_bus.elf")
      continue;
    EXPECT_TRUE(known.contains(name)) << name << " is not in tests/budget/targets.cpp";
  }
  EXPECT_GE(found, known.size());
}

TEST(Budget, NoneIsWithoutItsProgram) {
  std::set<std::pair<std::string, std::string>> known;
  for (const Target& target : targets()) known.insert({target.program, target.scene});
  for (const auto& [key, bytes] : read_budgets(kFolder / "budgets.csv")) {
    EXPECT_TRUE(known.contains(key)) << key.first << ", " << key.second;
  }
}

TEST(Budget, PageHasTheseFigures) {
  std::ifstream stream(kRoot / "docs/memory.md");
  const std::string page(std::istreambuf_iterator<char>(stream), {});
  const std::string compiler = compiler_version();
  if (page.find("compiled by " + compiler + " ") == std::string::npos) {
    GTEST_SKIP() << "docs/memory.md has the figures of another compiler than " << compiler;
  }
  std::vector<Usage> usages;
  for (const Target& target : targets()) usages.push_back(measure(target, kBinaries));
  EXPECT_EQ(page, page_with_tables(page, memory_tables(usages, compiler))) << "tests/budget/update writes them";
}

}  // namespace
}  // namespace zstrip::budget
