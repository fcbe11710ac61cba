// The rows of the table of memory: every kind of memory is compared, flash within its tolerance and RAM exactly.
#include "memory_table.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace zstrip::budget {
namespace {

const Target kTarget{"a board", "microbit_room", "a machine", "room", "", {8, 8}, Report::turntable, 0};

Usage small_usage() {
  Usage usage{.target = &kTarget};
  usage.code = 1000;
  usage.constants = 500;
  usage.initial_data = 100;
  usage.arena = 96;
  usage.pixels = 128;
  usage.statics = 60;
  usage.stack_bound = 700;
  usage.stack_reserved = 800;
  usage.stack_measured = 600;
  return usage;
}

measured::Table table_of(const Usage& usage) {
  measured::Table table = memory_format();
  table.rows = {row_of(usage)};
  return table;
}

TEST(Budget, IsKeptByWhatItWasMadeFrom) { EXPECT_EQ(complaint(table_of(small_usage()), row_of(small_usage())), ""); }

TEST(Budget, OfFlashHasATolerance) {
  const measured::Table table = table_of(small_usage());
  for (const auto& [member, name] : {std::pair{&Usage::code, "code"}, std::pair{&Usage::constants, "constants"},
                                     std::pair{&Usage::initial_data, "initial_data"}}) {
    for (const std::uint32_t percent : {98U, 99U, 101U, 102U}) {
      Usage changed = small_usage();
      changed.*member = changed.*member * percent / 100;
      const std::string lines = complaint(table, row_of(changed));
      EXPECT_EQ(lines.find(std::string("microbit_room, room: ") + name + " is ") == 0, percent == 98 || percent == 102)
          << lines;
    }
  }
}

TEST(Budget, OfRamIsExact) {
  const measured::Table table = table_of(small_usage());
  for (std::uint32_t Usage::*const member : {&Usage::arena, &Usage::pixels, &Usage::statics, &Usage::stack_bound,
                                             &Usage::stack_reserved, &Usage::stack_measured}) {
    for (const int difference : {-1, 1}) {
      Usage changed = small_usage();
      changed.*member += static_cast<std::uint32_t>(difference);
      EXPECT_NE(complaint(table, row_of(changed)), "");
    }
  }
  for (std::uint32_t Plan::*const member : {&Plan::instance_bytes, &Plan::extent_bytes, &Plan::vertex_bytes,
                                            &Plan::depth_bytes, &Plan::colour_bytes, &Plan::bin_bytes}) {
    Usage changed = small_usage();
    changed.plan.*member += 8;
    EXPECT_NE(complaint(table, row_of(changed)), "");
  }
}

TEST(Budget, PageAddsUpFlashAndRam) {
  const std::string page = memory_page(table_of(small_usage()));
  EXPECT_NE(page.find("| micro:bit | room | 1,000 | 500 | 100 | 1,600 |\n"), std::string::npos) << page;
  EXPECT_NE(page.find("| 128 | 60 | 800 | 700 | 600 | 1,084 |\n"), std::string::npos) << page;
}

}  // namespace
}  // namespace zstrip::budget
