// Instructions and code of docs/measured/accuracy.csv against a fresh count: the default and two settings of one scene;
// with ZSTRIP_LONG all of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "measured/table.hpp"
#include "support.hpp"

namespace zstrip::sim {
namespace {

using measured::Row;
using measured::Table;

const std::string kBunny = "/usr/share/glmark2/models/bunny.obj";

/// The cells of a line, of which the last one may be empty.
Row cells_of(const std::string& line) {
  Row cells;
  std::istringstream rest(line);
  for (std::string cell; std::getline(rest, cell, ',');) cells.push_back(cell);
  return cells;
}

/// Of a table only the columns that are compared here.
Table with_programs(const std::filesystem::path& file) {
  Table table{.part = "accuracy",
              .columns = {{"scene"},
                          {"settings"},
                          {"m0", measured::kInstructions},
                          {"m3", measured::kInstructions},
                          {"m4f", measured::kInstructions},
                          {"program_bytes", measured::kFlash}}};
  std::istringstream lines(test::read(file));
  std::string line;
  std::getline(lines, line);
  const Row names = cells_of(line);
  while (std::getline(lines, line)) {
    const Row cells = cells_of(line);
    Row row;
    for (const measured::Column& column : table.columns) {
      row.push_back(cells.at(static_cast<std::size_t>(std::ranges::find(names, column.name) - names.begin())));
    }
    table.rows.push_back(row);
  }
  return table;
}

std::vector<std::string> arguments_for(const Table& recorded, const std::string& folder) {
  std::vector<std::string> arguments{"accuracy", "--target", "m0,m3", "--default-on", "m4f", "-o", folder, "--quiet"};
  if (std::getenv("ZSTRIP_LONG") == nullptr) {
    // One pipeline that differs from the default's, and one plan.
    arguments.insert(arguments.end(), {"teapot", "--only", "default", "--only", "dither=on", "--only", "strips=8"});
    return arguments;
  }
  std::vector<std::string> scenes;
  for (const Row& row : recorded.rows) {
    if (scenes.empty() || scenes.back() != row[0]) scenes.push_back(row[0]);
  }
  for (const std::string& scene : scenes) arguments.push_back(scene == "bunny" ? kBunny : scene);
  arguments.insert(arguments.end(), {"--singles", "--presets"});
  return arguments;
}

using AccuracyInstructions = test::FolderTest;

TEST_F(AccuracyInstructions, AreThoseOfAFreshCount) {
  const Table recorded = with_programs(ZSTRIP_ROOT "/docs/measured/accuracy.csv");
  ASSERT_GT(recorded.rows.size(), 100U);
  const test::Outcome outcome =
      test::run(ZSTRIP_ROOT "/host-sim/run", arguments_for(recorded, path("fresh")), path(""));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Table fresh = with_programs(path("fresh/accuracy.csv"));
  EXPECT_GE(fresh.rows.size(), 3U);
  for (const Row& row : fresh.rows) EXPECT_EQ(complaint(recorded, row), "");
}

}  // namespace
}  // namespace zstrip::sim
