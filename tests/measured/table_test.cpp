// The comparison of figures itself: it complains in both directions, by how much, and what agrees changes no file.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "measured/table.hpp"
#include "measured/update.hpp"

namespace zstrip::measured {
namespace {

Table small_table() {
  return {.part = "memory",
          .columns = {{"program"}, {"scene"}, {"flash", kFlash}, {"ram", kExact}, {"strips", kExact}},
          .notes = {"compiled by a compiler"},
          .rows = {{"one", "room", "1000", "64", "4 of 8x8"},
                   {"one", "knot", "2000", "32", ""},
                   {"two", "room", "0", "8", "a"}}};
}

std::filesystem::path scratch_file() {
  return std::filesystem::path(testing::TempDir()) /
         (std::string("zstrip_measured_") + testing::UnitTest::GetInstance()->current_test_info()->name() + '_' +
          std::to_string(::getpid()));
}

TEST(Measured, AgreesUpToItsToleranceInBothDirections) {
  EXPECT_TRUE(agrees(1000, 1010, kFlash));
  EXPECT_TRUE(agrees(1000, 990, kFlash));
  EXPECT_FALSE(agrees(1000, 1011, kFlash));
  EXPECT_FALSE(agrees(1000, 989, kFlash));
  EXPECT_TRUE(agrees(-1000, -1010, kInstructions));
  EXPECT_FALSE(agrees(-1000, -1011, kInstructions));
  EXPECT_FALSE(agrees(0, 1, kInstructions));
  EXPECT_TRUE(agrees(64, 64, kExact));
  EXPECT_FALSE(agrees(64, 65, kExact));
  EXPECT_TRUE(agrees(100, 105, {.share = 0.01, .at_least = 5}));
  EXPECT_FALSE(agrees(100, 106, {.share = 0.01, .at_least = 5}));
}

TEST(Measured, ComplaintSaysWhatIsOffAndWhatAcceptsIt) {
  const std::string accept = "if it is worth it, tests/measure memory one accepts it; say why in the commit\n";
  const Table table = small_table();
  EXPECT_EQ(complaint(table, {"one", "room", "1010", "64", "4 of 8x8"}), "");
  EXPECT_EQ(complaint(table, {"one", "room", "1016", "64", "4 of 8x8"}),
            "one, room: flash is 1016, recorded 1000 (+16, +1.60 %; 1 % either way is allowed)\n" + accept);
  EXPECT_EQ(complaint(table, {"one", "room", "900", "60", "4 of 8x8"}),
            "one, room: flash is 900, recorded 1000 (-100, -10.00 %; 1 % either way is allowed)\n"
            "one, room: ram is 60, recorded 64 (-4, -6.25 %; it must be equal)\n" +
                accept);
  EXPECT_EQ(complaint(table, {"one", "room", "1000", "64", "5 of 8x8"}),
            "one, room: strips is 5 of 8x8, recorded 4 of 8x8\n" + accept);
  EXPECT_NE(complaint(table, {"one", "knot", "2000", "32", "7"}), "");
  EXPECT_NE(complaint(table, {"one", "knot", "2000", "32.0", ""}), "") << "checksums may look like numbers";
  EXPECT_NE(complaint(table, {"two", "room", "1", "8", "a"}).find("recorded 0 (+1; 1 %"), std::string::npos);
  EXPECT_EQ(complaint(table, {"two", "knot", "1", "8", "a"}),
            "two, knot: nothing is recorded\ntests/measure memory two records it\n");
}

TEST(Measured, WhatAgreesKeepsItsRecordedFigure) {
  Table measured = small_table();
  measured.rows[0] = {"one", "room", "1005", "64", "4 of 8x8"};
  measured.rows[1] = {"one", "knot", "2030", "32", ""};
  Table expected = small_table();
  expected.rows[1][2] = "2030";
  EXPECT_EQ(merged(small_table(), measured, false, true).rows, expected.rows);
  EXPECT_EQ(merged(small_table(), measured, true, true).rows, measured.rows);
}

TEST(Measured, RowsThatAreNotMeasuredStayUnlessAllAre) {
  Table measured = small_table();
  measured.rows = {{"one", "knot", "3000", "32", ""}, {"new", "room", "1", "2", "3"}};
  Table expected = small_table();
  expected.rows[1][2] = "3000";
  expected.rows.push_back(measured.rows[1]);
  EXPECT_EQ(merged(small_table(), measured, false, false).rows, expected.rows);
  EXPECT_EQ(merged(small_table(), measured, false, true).rows, measured.rows);
}

TEST(Measured, FiguresOfOtherCompilersAreNotMixed) {
  Table measured = small_table();
  measured.notes = {"compiled by another"};
  measured.rows[0][2] = "1005";
  EXPECT_EQ(merged(small_table(), measured, false, true).rows, measured.rows);
  measured.rows.pop_back();
  EXPECT_THROW(merged(small_table(), measured, false, false), std::runtime_error);
}

TEST(Measured, FilesAreReadAsTheyWereWritten) {
  Table format = small_table();
  format.notes.clear();
  format.rows.clear();
  write_table(scratch_file(), small_table());
  const Table read = read_table(scratch_file(), format);
  EXPECT_EQ(read.notes, small_table().notes);
  EXPECT_EQ(read.rows, small_table().rows);
  std::ifstream stream(scratch_file());
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}).substr(0, 66),
            "# compiled by a compiler\nprogram,scene,flash,ram,strips\none,room,1");
  std::filesystem::remove(scratch_file());
}

TEST(Measured, FilesThatAreNoneAreRefused) {
  Table format = small_table();
  format.rows.clear();
  const std::string headings = "program,scene,flash,ram,strips\n";
  for (const std::string& text : {std::string(), std::string("program,scene\n"), headings + "a,b,1,2\n",
                                  headings + "a,b,1,2,3,4\n", headings + "a,b,1,2,3\na,b,1,2,3\n"}) {
    std::ofstream(scratch_file()) << text;
    EXPECT_THROW(read_table(scratch_file(), format), std::runtime_error) << text;
  }
  std::filesystem::remove(scratch_file());
  EXPECT_THROW(read_table(scratch_file(), format), std::runtime_error);
  EXPECT_TRUE(recorded_or_empty(scratch_file(), format).rows.empty());
}

TEST(Measured, ProgramsTakeRowsAndSayWhatIsWrong) {
  const auto run = [](std::vector<std::string> words, const auto& body) {
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    return run_update(static_cast<int>(pointers.size()), pointers.data(), "update FOLDER", 1, body);
  };
  const auto expect = [](const Choice& choice, bool exact, const std::vector<std::string>& rows) {
    EXPECT_EQ(choice.exact, exact);
    EXPECT_EQ(choice.rows, rows);
  };
  EXPECT_EQ(run({"update"}, [](const auto&, const Choice&) { FAIL(); }), 2);
  EXPECT_EQ(run({"update", "f"},
                [&](const auto& before, const Choice& choice) {
                  EXPECT_EQ(before, std::vector<std::string>{"f"});
                  expect(choice, false, {});
                  EXPECT_TRUE(choice.has("any"));
                }),
            0);
  EXPECT_EQ(run({"update", "f", "--exact", "a", "b"},
                [&](const auto&, const Choice& choice) {
                  expect(choice, true, {"a", "b"});
                  EXPECT_FALSE(choice.has("c"));
                  check(choice, {"b", "a", "c"});
                }),
            0);
  EXPECT_EQ(run({"update", "f", "a"}, [](const auto&, const Choice& choice) { check(choice, {"b"}); }), 2);
  EXPECT_EQ(run({"update", "f"}, [](const auto&, const Choice&) { throw std::runtime_error("no"); }), 1);
}

}  // namespace
}  // namespace zstrip::measured
