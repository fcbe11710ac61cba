// docs/accuracy.csv against a fresh run of some of its scenes, and the plots against docs/accuracy.csv.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "accuracy/campaign.hpp"
#include "accuracy/causes.hpp"
#include "accuracy/recorded.hpp"
#include "support.hpp"

namespace zstrip::sim {
namespace {

std::string words(const Settings& settings) {
  std::string text = to_text(settings);
  std::ranges::replace(text, ',', ' ');
  return text;
}

/// The columns' names, and rows by what their first columns say: scene and settings, or scene, cause and settings.
struct Table {
  std::vector<std::string> names;
  std::map<std::string, std::vector<std::string>> rows;
};

Table table(const char* file = ZSTRIP_ROOT "/docs/accuracy.csv", std::size_t keys = 2) {
  std::ifstream csv(file);
  Table read;
  std::string line;
  std::getline(csv, line);
  read.names = csv_fields(line);
  while (std::getline(csv, line)) {
    std::vector<std::string> row = csv_fields(line);
    row.resize(read.names.size());
    std::string key = row[0];
    for (std::size_t i = 1; i < keys; ++i) key += "," + row[i];
    read.rows[key] = row;
  }
  return read;
}

void expect_figures(const std::vector<std::string>& names, const std::vector<std::string>& row, const Errors& errors,
                    const std::string& of) {
  for (std::size_t column = 0; column < names.size(); ++column) {
    for (std::size_t i = 0; i < kFigures; ++i) {
      if (figures()[i].name != names[column]) continue;
      if (std::isnan(errors.value[i])) {
        EXPECT_EQ(row[column], "") << names[column];
      } else {
        // Six digits are written; the truth's last bits may differ among compilers.
        EXPECT_NEAR(std::stod(row[column]), errors.value[i], 1e-3 * std::abs(errors.value[i]) + 1e-6)
            << of << ' ' << names[column];
      }
    }
  }
}

TEST(Document, PlotsShowTheTablesPoints) {
  std::map<std::string, std::size_t> settings;
  for (const auto& [key, row] : table().rows) {
    ++settings[row[0]];
    EXPECT_NE(row[3], "") << key << " has no instructions of m3";
  }
  EXPECT_GE(settings.size(), 6U);
  for (const auto& [scene, count] : settings) {
    std::ifstream file(std::string(ZSTRIP_ROOT "/docs/images/accuracy-") + scene + ".svg");
    std::string line;
    std::size_t points = 0;
    while (std::getline(file, line)) points += line.starts_with("<circle data-point=") ? 1U : 0U;
    EXPECT_EQ(points, count) << scene << ": run host-sim/accuracy/document";
  }
}

using DocumentPlots = test::FolderTest;

TEST_F(DocumentPlots, AreDrawnIntoANewFolderFromTheTable) {
  const test::Outcome outcome = test::run(
      ZSTRIP_COMMAND, {"accuracy", "--replot", ZSTRIP_ROOT "/docs/accuracy.csv", "-o", "new/folder"}, path(""));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const char* scene : {"bunny", "cube", "knot", "room", "spheres", "teapot", "terrain", "wires"}) {
    const std::string drawn = test::read(path(std::string("new/folder/") + scene + "_m3.svg"));
    EXPECT_FALSE(drawn.empty()) << scene;
    EXPECT_EQ(drawn, test::read(std::string(ZSTRIP_ROOT "/docs/images/accuracy-") + scene + ".svg"))
        << scene << ": run host-sim/accuracy/document";
  }
}

TEST(Document, FiguresAreThoseOfAFreshRun) {
  const auto [names, rows] = table();
  for (const char* name : {"cube", "spheres", "teapot", "wires"}) {
    const auto scene = AccuracyScene::open({.scene = name, .view = {160, 120}, .frames = 2, .firmware = ""});
    ASSERT_TRUE(scene);
    const std::vector<Settings> wanted = one_at_a_time(**scene, *parse_knobs("all"));
    EXPECT_GT(wanted.size(), 10U);
    for (const Settings& settings : wanted) {
      const auto row = rows.find(std::string(name) + "," + words(settings));
      ASSERT_NE(row, rows.end()) << name << ' ' << to_text(settings) << ": run host-sim/accuracy/document";
      const Errors errors = *(*scene)->errors(settings);
      expect_figures(names, row->second, errors, std::string(name) + " " + to_text(settings));
      const Result<MemoryCost> memory = (*scene)->memory(settings);
      EXPECT_EQ(row->second[5], std::to_string(memory->ram_bytes)) << to_text(settings);
    }
  }
}

TEST(Document, CausesAreThoseOfAFreshRun) {
  const auto [names, rows] = table(ZSTRIP_ROOT "/docs/accuracy-causes.csv", 3);
  for (const char* name : {"cube", "spheres", "teapot", "wires"}) {
    const auto scene = AccuracyScene::open({.scene = name, .view = {160, 120}, .frames = 2, .firmware = ""});
    ASSERT_TRUE(scene);
    for (const CauseCase& wanted : cause_cases(**scene, *parse_knobs("all"))) {
      const std::string key =
          std::string(name) + "," + std::string(info(wanted.cause).name) + "," + words(wanted.settings);
      const auto row = rows.find(key);
      ASSERT_NE(row, rows.end()) << key << ": run host-sim/accuracy/document";
      expect_figures(names, row->second, *errors_of(**scene, wanted), key);
    }
  }
}

}  // namespace
}  // namespace zstrip::sim
