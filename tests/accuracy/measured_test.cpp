// docs/measured/accuracy*.csv against a fresh run of some of its scenes, and tables and plots against the CSV.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "accuracy/campaign.hpp"
#include "accuracy/causes.hpp"
#include "accuracy/recorded.hpp"
#include "support.hpp"

namespace zstrip::sim {
namespace {

constexpr const char* kFolder = ZSTRIP_ROOT "/docs/measured";

std::string words(const Settings& settings) {
  std::string text = to_text(settings);
  std::ranges::replace(text, ',', ' ');
  return text;
}

RecordedTable table(const std::string& name) {
  return *RecordedTable::read(std::string(kFolder) + "/" + name + ".csv", {"scene"});
}

std::string accepted_by(const std::string& scene) {
  return scene + ": tests/measure accuracy " + scene + " accepts it";
}

void expect_figures(const RecordedTable& table, const RecordedTable::Row& row, const Errors& errors) {
  for (std::size_t i = 0; i < kFigures; ++i) {
    const std::string recorded = table.field(row, figures()[i].name);
    if (std::isnan(errors.value[i])) {
      EXPECT_EQ(recorded, "") << figures()[i].name << " of " << accepted_by(row[0]);
    } else {
      // Six digits are written; the truth's last bits may differ among compilers.
      EXPECT_NEAR(std::stod(recorded), errors.value[i], 1e-3 * std::abs(errors.value[i]) + 1e-6)
          << figures()[i].name << " of " << row[1] << ", " << row[2] << ", in " << accepted_by(row[0]);
    }
  }
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
  return found;
}

/// Where a plot shows each setting.
std::map<std::string, std::array<double, 2>> points_of(const std::string& svg) {
  const std::regex circle("<circle data-point=[^>]* cx=\"([0-9.]+)\" cy=\"([0-9.]+)\"[^>]*><title>([^<]*)</title>");
  std::map<std::string, std::array<double, 2>> points;
  for (std::sregex_iterator at(svg.begin(), svg.end(), circle), end; at != end; ++at)
    points[(*at)[3]] = {std::stod((*at)[1]), std::stod((*at)[2])};
  return points;
}

/// Whether places are those of figures on a logarithmic axis: on a line through those of the least and the greatest.
void expect_on_axis(const std::map<double, double>& place_of, const std::string& what) {
  const auto [least, first] = *place_of.begin();
  const auto [greatest, last] = *place_of.rbegin();
  EXPECT_GT(std::abs(last - first), 100) << what;
  for (const auto& [figure, place] : place_of) {
    const double part = std::log(figure / least) / std::log(greatest / least);
    EXPECT_NEAR(place, first + part * (last - first), 0.2) << what << ' ' << figure;
  }
}

using MeasuredAccuracyTables = test::FolderTest;

TEST_F(MeasuredAccuracyTables, TablesAndPlotsAreDrawnFromTheRecordedFigures) {
  const test::Outcome outcome =
      test::run(ZSTRIP_COMMAND, {"accuracy", "--recorded", kFolder, "-o", "new/folder"}, path(""));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::map<std::string, std::size_t> settings;
  const RecordedTable recorded = table("accuracy");
  for (const RecordedTable::Row& row : recorded.rows()) {
    ++settings[row[0]];
    EXPECT_NE(recorded.field(row, "m3"), "") << row[1] << " has no instructions of m3, " << accepted_by(row[0]);
  }
  EXPECT_EQ(settings.size(), 8U);
  const std::string page = test::read(path("new/folder/accuracy.md"));
  for (const auto& [scene, points] : settings) {
    const auto shown = points_of(test::read(path("new/folder/accuracy-" + scene + ".svg")));
    EXPECT_EQ(shown.size(), points) << scene;
    std::map<double, double> times, errors;
    for (const RecordedTable::Row& row : recorded.rows()) {
      if (row[0] != scene) continue;
      std::string named = row[1];
      std::ranges::replace(named, ' ', ',');
      ASSERT_TRUE(shown.contains(named)) << scene << ' ' << named;
      times[std::stod(recorded.field(row, "m3"))] = shown.at(named)[0];
      errors[std::stod(recorded.field(row, "perceived"))] = shown.at(named)[1];
    }
    expect_on_axis(times, scene + ", m3");
    expect_on_axis(errors, scene + ", perceived");
    EXPECT_EQ(count(page, "(accuracy-" + scene + ".svg)"), 1U) << scene;
    const std::size_t begin = page.find("\n### " + scene + "\n");
    ASSERT_NE(begin, std::string::npos) << scene;
    const std::string section = page.substr(begin, page.find("\n### ", begin + 1) - begin);
    EXPECT_EQ(count(section, "\n| "), points + 1) << scene << ": a line a setting, and the headings";
    EXPECT_EQ(count(page, "\n| " + scene + " | `balanced` |"), 1U) << scene;
  }
}

/// Became empty tables, or an internal error with the name of a function.
TEST_F(MeasuredAccuracyTables, FilesThatAreNoTablesAreRefused) {
  const auto expect_refused = [&](const std::string& settings, const std::string& causes, const std::string& mention) {
    file("accuracy.csv", settings);
    file("accuracy-causes.csv", causes);
    const test::Outcome outcome = test::run(ZSTRIP_COMMAND, {"accuracy", "--recorded", "."}, path(""));
    EXPECT_EQ(outcome.status, 4) << outcome.err;
    EXPECT_NE(outcome.err.find(mention), std::string::npos) << outcome.err;
  };
  const std::string settings = "scene,settings,perceived\ncube,default,1\n";
  const std::string causes = "scene,cause,settings,perceived\ncube,depth,default,";
  expect_refused("# A title\n", causes + "1\n", "accuracy.csv' is not a table of accuracy figures");
  expect_refused("", causes + "1\n", "accuracy.csv' cannot be read");
  expect_refused(settings, "scene\ncube\n", "accuracy-causes.csv' is not a table of accuracy figures");
  expect_refused(settings, causes + "much\n", "has a field that is not a number");
}

TEST(MeasuredAccuracy, ErrorsAndMemoryAreThoseOfAFreshRun) {
  const RecordedTable recorded = table("accuracy");
  for (const char* name : {"cube", "spheres", "teapot", "wires"}) {
    const auto scene = AccuracyScene::open({.scene = name, .view = {160, 120}, .frames = 2, .firmware = ""});
    ASSERT_TRUE(scene);
    const std::vector<Settings> wanted = one_at_a_time(**scene, *parse_knobs("all"));
    EXPECT_GT(wanted.size(), 10U);
    for (const Settings& settings : wanted) {
      const RecordedTable::Row* row = recorded.find({name, words(settings)});
      ASSERT_NE(row, nullptr) << to_text(settings) << " of " << accepted_by(name);
      expect_figures(recorded, *row, *(*scene)->errors(settings));
      const Result<MemoryCost> memory = (*scene)->memory(settings);
      EXPECT_EQ(recorded.field(*row, "ram_bytes"), std::to_string(memory->ram_bytes)) << accepted_by(name);
      EXPECT_EQ(recorded.field(*row, "scene_bytes"), std::to_string(memory->scene_bytes)) << accepted_by(name);
    }
  }
}

TEST(MeasuredAccuracy, CausesAreThoseOfAFreshRun) {
  const RecordedTable recorded = table("accuracy-causes");
  for (const char* name : {"cube", "spheres", "teapot", "wires"}) {
    const auto scene = AccuracyScene::open({.scene = name, .view = {160, 120}, .frames = 2, .firmware = ""});
    ASSERT_TRUE(scene);
    const std::vector<CauseCase> cases = cause_cases(**scene, *parse_knobs("all"));
    EXPECT_GT(cases.size(), 10U);
    for (const CauseCase& wanted : cases) {
      const RecordedTable::Row* row =
          recorded.find({name, std::string(info(wanted.cause).name), words(wanted.settings)});
      ASSERT_NE(row, nullptr) << info(wanted.cause).name << ", " << to_text(wanted.settings) << " of "
                              << accepted_by(name);
      expect_figures(recorded, *row, *errors_of(**scene, wanted));
    }
  }
}

}  // namespace
}  // namespace zstrip::sim
