// docs/accuracy.csv against a fresh run of some of its scenes.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "accuracy/campaign.hpp"

namespace zstrip::sim {
namespace {

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> found;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) found.push_back(field);
  return found;
}

std::string values(const Settings& settings) {
  std::string text;
  for (const KnobInfo& knob : knobs()) {
    if (!text.empty()) text += ' ';
    text += settings.name_of(knob.knob);
  }
  return text;
}

TEST(Document, FiguresAreThoseOfAFreshRun) {
  std::ifstream csv(ZSTRIP_ROOT "/docs/accuracy.csv");
  std::string line;
  ASSERT_TRUE(std::getline(csv, line));
  const std::vector<std::string> names = fields(line);
  std::map<std::string, std::vector<std::string>> rows;
  while (std::getline(csv, line)) {
    std::vector<std::string> row = fields(line);
    row.resize(names.size());
    rows[row[0] + "," + row[1]] = row;
  }
  for (const char* name : {"cube", "teapot"}) {
    const auto scene = AccuracyScene::open({.scene = name, .view = {160, 120}, .frames = 2, .firmware = ""});
    ASSERT_TRUE(scene);
    const std::vector<Settings> wanted = one_at_a_time(**scene, *parse_knobs("all"));
    EXPECT_GT(wanted.size(), 10U);
    for (const Settings& settings : wanted) {
      const auto row = rows.find(std::string(name) + "," + values(settings));
      ASSERT_NE(row, rows.end()) << name << ' ' << to_text(settings) << ": run host-sim/accuracy/document";
      const Errors errors = *(*scene)->errors(settings);
      for (std::size_t column = 0; column < names.size(); ++column) {
        for (std::size_t i = 0; i < kFigures; ++i) {
          if (figures()[i].name != names[column]) continue;
          const std::string& written = row->second[column];
          if (std::isnan(errors.value[i])) {
            EXPECT_EQ(written, "") << names[column];
          } else {
            // Six digits are written; the truth's last bits may differ among compilers.
            EXPECT_NEAR(std::stod(written), errors.value[i], 1e-3 * std::abs(errors.value[i]) + 1e-6)
                << name << ' ' << to_text(settings) << ' ' << names[column];
          }
        }
      }
      const Result<MemoryCost> memory = (*scene)->memory(settings);
      EXPECT_EQ(row->second[5], std::to_string(memory->ram_bytes)) << to_text(settings);
    }
  }
}

}  // namespace
}  // namespace zstrip::sim
