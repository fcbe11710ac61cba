// The table of expected results, judged by more than the renderer that wrote it: the single triangle is projected here
// in floating point and rasterised by the oracle, and strips must not change anything.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "../oracle/triangle_oracle.hpp"
#include "zstrip_scenes/effect_scenes.hpp"
#include "zstrip_scenes/spheres.hpp"

namespace {

struct Row {
  std::string name;
  std::vector<std::string> values;  ///< crc32, depth_crc32, left, top, right, bottom, red, green, blue

  long number(std::size_t column) const { return std::stol(values.at(column)); }
};
constexpr std::size_t kLeft = 2, kTop = 3, kRight = 4, kBottom = 5, kRed = 6;

std::vector<Row> read_table() {
  std::ifstream file(ZSTRIP_TARGETS_TABLE);
  std::vector<Row> rows;
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "case,crc32,depth_crc32,left,top,right,bottom,red,green,blue");
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    Row row;
    std::getline(fields, row.name, ',');
    for (std::string value; std::getline(fields, value, ',');) row.values.push_back(value);
    rows.push_back(row);
  }
  return rows;
}

/// The name without the part that says how many rows a strip has.
std::string without_rows(const std::string& name) {
  const std::size_t begin = name.find("_rows");
  return name.substr(0, begin) + name.substr(name.find('_', begin + 1));
}

TEST(TargetsTable, StripsChangeNothing) {
  std::map<std::string, std::vector<Row>> pictures;
  for (const Row& row : read_table()) pictures[without_rows(row.name)].push_back(row);
  int compared = 0;
  for (const auto& [picture, rows] : pictures) {
    for (const Row& row : rows) EXPECT_EQ(row.values, rows.front().values) << row.name;
    compared += rows.size() > 1;
  }
  EXPECT_GE(compared, 20);
}

TEST(TargetsTable, PicturesDiffer) {
  std::map<std::string, std::string> picture_of;
  for (const Row& row : read_table()) {
    const std::string picture = without_rows(row.name);
    // With their depth: formats of depth that decide every pixel rightly give the same colours.
    const auto [known, is_new] = picture_of.emplace(row.values.at(0) + row.values.at(1), picture);
    EXPECT_TRUE(is_new || known->second == picture) << picture << " is the same picture as " << known->second;
  }
}

TEST(TargetsTable, EveryEffectHasAPicture) {
  const std::vector<Row> rows = read_table();
  const auto drawn = [&](const std::string& scene) {
    return std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return row.name.rfind(scene + "_", 0) == 0; });
  };
  for (const zstrip::scenes::BuiltIn& built_in : zstrip::scenes::effect_scenes()) {
    EXPECT_TRUE(drawn(built_in.name)) << built_in.name;
  }
  EXPECT_TRUE(drawn(zstrip::scenes::spheres.name));
}

struct Expected {
  long left = 4096, top = 4096, right = 0, bottom = 0;
  long pixels = 0;
  std::array<long, 3> sums{};
};

/// The scene `triangle` on the turntable: corners (-1, -1, 0), (1, -1, 0), (0, 1, 0), red, green and blue, turned about
/// y; the camera is 4 units away, 20 degrees above, focal length 2.55 or, in narrow pictures, what keeps the width.
Expected expected_triangle(int width, int height, int frame) {
  const double turn = 2 * std::numbers::pi * frame / 100, tilt = std::numbers::pi / 9;
  const double focal = std::min(2.55, 4.05 * width / height);
  const double corners[3][2] = {{-1, -1}, {1, -1}, {0, 1}};
  std::array<oracle::Point, 3> snapped{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = std::cos(turn) * corners[i][0], y = corners[i][1], z = -std::sin(turn) * corners[i][0];
    const double up = std::cos(tilt) * y - std::sin(tilt) * z;
    const double distance = 4 - (std::sin(tilt) * y + std::cos(tilt) * z);
    const double scale = focal * height / 2 / distance;
    const auto snap = [](double pixels) { return static_cast<std::int64_t>(std::floor(pixels * 16 + 0.5)); };
    snapped[i] = {snap(width / 2.0 + x * scale), snap(height / 2.0 - up * scale)};
  }
  const oracle::Triangle triangle(snapped);
  Expected expected;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!triangle.covers(x, y)) continue;
      expected.left = std::min<long>(expected.left, x);
      expected.top = std::min<long>(expected.top, y);
      expected.right = std::max<long>(expected.right, x + 1);
      expected.bottom = std::max<long>(expected.bottom, y + 1);
      ++expected.pixels;
      for (std::size_t channel = 0; channel < 3; ++channel) {
        std::array<std::int64_t, 3> values{};
        values[channel] = 255;
        // To the nearest of 256, then truncated to RGB565.
        const oracle::Wide area = triangle.area();
        const auto value = static_cast<long>((2 * triangle.value_times_area(x, y, values) + area) / (2 * area));
        expected.sums[channel] += channel == 1 ? value >> 2 : value >> 3;
      }
    }
  }
  return expected;
}

TEST(TargetsTable, TriangleIsTheOneOfTheOracle) {
  int judged = 0;
  for (const Row& row : read_table()) {
    int width = 0, height = 0, frame = 0;
    if (std::sscanf(row.name.c_str(), "triangle_%dx%d_rgb565_rows%*d_frame%d", &width, &height, &frame) != 3) continue;
    const Expected expected = expected_triangle(width, height, frame);
    EXPECT_EQ(row.number(kLeft), expected.left) << row.name;
    EXPECT_EQ(row.number(kTop), expected.top) << row.name;
    EXPECT_EQ(row.number(kRight), expected.right) << row.name;
    EXPECT_EQ(row.number(kBottom), expected.bottom) << row.name;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      // The renderer's colours are less than 1/8 of 255 steps off: few pixels fall on the other side of a step.
      const long difference = row.number(kRed + channel) - expected.sums[channel];
      EXPECT_LE(std::abs(difference), 1 + expected.pixels / 1000) << row.name << ", channel " << channel;
    }
    ++judged;
  }
  EXPECT_GE(judged, 5);
}

}  // namespace
