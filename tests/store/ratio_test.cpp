// The ratios that the stores reach: 16 bits a cell of the bounding rectangle to the bytes of the pool, index included,
// the mean of six frames and the worst. Bytes are the same everywhere: the ratios are those of docs/measured.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "measured/table.hpp"
#include "measured_scenes.hpp"
#include "zstrip/store/colour_store.hpp"
#include "zstrip/store/depth_store.hpp"

namespace store_test {
namespace {

using namespace zstrip;

struct Case {
  const char* scene;
  Content content;
};

void PrintTo(const Case& c, std::ostream* stream) { *stream << c.scene; }

const char* name(Content content) {
  if (content == Content::small_float) return "depth in a small float";
  return content == Content::fitted ? "depth in fitted z16" : "colour";
}

/// docs/measured/performance-ratios.csv, which tests/measure makes of what is printed here.
const measured::Table& recorded() {
  constexpr measured::Tolerance kRounded{.share = 0.001, .at_least = 0.005};
  static const measured::Table table = measured::read_table(
      ZSTRIP_MEASURED "/performance-ratios.csv",
      {.part = "performance", .columns = {{"content"}, {"scene"}, {"mean", kRounded}, {"worst", kRounded}}});
  return table;
}

std::string decimal(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value);
  return text.data();
}

class StoreRatio : public testing::TestWithParam<Case> {};

template <typename Store>
double ratio_of(const Image& image) {
  std::vector<std::byte> pool(store_bytes_worst(image.width, image.height));
  Store store;
  EXPECT_TRUE(store.reset(pool, image.width, image.height));
  EXPECT_TRUE(store.write_rows({image.cells.data(), image.width, 0, image.height}));
  std::vector<std::uint16_t> cells(image.cells.size(), 0xA5A5);
  EXPECT_TRUE(store.read_rows({cells.data(), image.width, 0, image.height}));
  EXPECT_TRUE(cells == image.cells);
  return 2.0 * static_cast<double>(image.cells.size()) / store.bytes_used();
}

TEST_P(StoreRatio, IsReached) {
  const std::vector<Image> images = images_of(GetParam().scene, GetParam().content);
  if (images.empty()) GTEST_SKIP() << "no model file";
  double sum = 0, worst = 1e9;
  for (const Image& image : images) {
    const bool colour = GetParam().content == Content::colour;
    const double ratio = colour ? ratio_of<ColourStore>(image) : ratio_of<DepthStore>(image);
    sum += ratio;
    worst = std::min(worst, ratio);
  }
  const double mean = sum / static_cast<double>(images.size());
  const measured::Row row{name(GetParam().content), GetParam().scene, decimal(mean), decimal(worst)};
  std::printf("ratio,%s,%s,%s,%s\n", row[0].c_str(), row[1].c_str(), row[2].c_str(), row[3].c_str());
  EXPECT_EQ(differences(recorded(), row), "") << "if it is worth it, tests/measure performance ratios accepts it";
}

std::vector<Case> of(Content content, const std::vector<const char*>& scenes) {
  std::vector<Case> cases;
  for (const char* scene : scenes) cases.push_back({scene, content});
  return cases;
}
std::string scene_of(const testing::TestParamInfo<Case>& test) { return test.param.scene; }

INSTANTIATE_TEST_SUITE_P(SmallFloat, StoreRatio,
                         testing::ValuesIn(of(Content::small_float,
                                              {"room", "teapot", "knot", "bunny", "random10k", "cube"})),
                         scene_of);
INSTANTIATE_TEST_SUITE_P(Fitted, StoreRatio,
                         testing::ValuesIn(of(Content::fitted,
                                              {"room", "teapot", "knot", "bunny", "random10k", "cube"})),
                         scene_of);
INSTANTIATE_TEST_SUITE_P(Colour, StoreRatio,
                         testing::ValuesIn(of(Content::colour,
                                              {"room", "teapot", "knot", "random10k", "random50", "cube"})),
                         scene_of);

}  // namespace
}  // namespace store_test
