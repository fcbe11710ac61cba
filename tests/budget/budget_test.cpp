// Every program for a board, with every scene that it draws, against docs/measured/memory.csv.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "memory_table.hpp"
#include "usage.hpp"

namespace zstrip::budget {
namespace {

const std::filesystem::path kBinaries = ZSTRIP_FIRMWARE_BINARIES;

measured::Table recorded() { return measured::read_table(ZSTRIP_MEASURED "/memory.csv", memory_format()); }

class ProgramBudget : public testing::Test {
 public:
  explicit ProgramBudget(const Target& target) : target_(target) {}
  void TestBody() override {
    const Usage usage = measure(target_, kBinaries);
    const measured::Table table = recorded();
    if (table.notes == std::vector{compiler_note()}) {
      const std::string lines = complaint(table, row_of(usage));
      EXPECT_EQ(lines, "") << "the largest of it:\n" << largest_symbols(file_of(target_, kBinaries));
    }
    if (target_.report != Report::none) {
      EXPECT_GT(usage.stack_measured, 0U);
    }
    EXPECT_LE(usage.stack_measured, usage.stack_bound) << "the bound of the stack is wrong";
    EXPECT_LE(usage.stack_bound + target_.stack_guard, usage.stack_reserved) << "the linker script gives it too little";
    if (table.notes != std::vector{compiler_note()}) GTEST_SKIP() << "the figures are those of another compiler";
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
    // The page's board; boards with megabytes; what plans on the board; the Pico 2's program for its other processors;
    // programs of tests and measurements.
    if (name.starts_with("zstrip_my_board_") || name.starts_with("zstrip_versatilepb_") ||
        name.starts_with("zstrip_riscv_virt_") || name == "zstrip_bench_rv32.elf" ||
        name == "zstrip_pico2_riscv_show.elf" || name.starts_with("zstrip_pico_player") ||
        name.starts_with("zstrip_pico2_player"))
      continue;
    if (name.starts_with("zstrip_self_test_") || name.starts_with("zstrip_bench_bins_") ||
        name.starts_with("zstrip_bench_depth_") || name.starts_with("zstrip_bench_scene_") ||
        name.starts_with("zstrip_bench_visibility_") || name.starts_with("zstrip_store_bench_") ||
        name.starts_with("zstrip_pipeline_") || name.starts_with("zstrip_played_") ||
        name.starts_with("zstrip_scene_") || name == "zstrip_lm3s6965evb_display_test.elf" ||
        name == "zstrip_lm3s6965evb_stuck_bus.elf")
      continue;
    EXPECT_TRUE(known.contains(name)) << name << " is not in tests/budget/targets.cpp";
  }
  EXPECT_GE(found, known.size());
}

TEST(Budget, NoneIsWithoutItsProgram) {
  std::set<std::pair<std::string, std::string>> known;
  for (const Target& target : targets()) known.insert({target.program, target.scene});
  for (const measured::Row& row : recorded().rows) {
    EXPECT_TRUE(known.contains({row[0], row[1]})) << row[0] << ", " << row[1];
  }
}

TEST(Budget, NamesTheLargestSymbols) {
  const std::string lines = largest_symbols(file_of(targets().front(), kBinaries));
  EXPECT_NE(lines.find("  flash, "), std::string::npos) << lines;
  EXPECT_NE(lines.find("draw_narrow_spans"), std::string::npos) << lines;
  EXPECT_NE(lines.find("  RAM, "), std::string::npos) << lines;
}

}  // namespace
}  // namespace zstrip::budget
