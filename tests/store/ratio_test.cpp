// The ratios that the stores reach: 16 bits a cell of the bounding rectangle to the bytes of the pool, index
// included, as an average of six frames. Bytes are the same everywhere, so the bounds are what was reached.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "measured_scenes.hpp"
#include "zstrip/store/colour_store.hpp"
#include "zstrip/store/depth_store.hpp"

namespace store_test {
namespace {

using namespace zstrip;

struct Case {
  const char* scene;
  Content content;
  double reached;
};

void PrintTo(const Case& c, std::ostream* stream) { *stream << c.scene; }

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
  std::printf("%s: %.3f, worst frame %.3f\n", GetParam().scene, mean, worst);
  EXPECT_GE(mean, GetParam().reached);
}

INSTANTIATE_TEST_SUITE_P(
    SmallFloat, StoreRatio,
    testing::Values(Case{"room", Content::small_float, 10.19}, Case{"teapot", Content::small_float, 4.09},
                    Case{"knot", Content::small_float, 3.52}, Case{"bunny", Content::small_float, 4.13},
                    Case{"random10k", Content::small_float, 3.35}, Case{"cube", Content::small_float, 14.95}),
    [](const auto& test) { return std::string(test.param.scene); });
INSTANTIATE_TEST_SUITE_P(Fitted, StoreRatio,
                         testing::Values(Case{"room", Content::fitted, 12.32}, Case{"teapot", Content::fitted, 2.83},
                                         Case{"knot", Content::fitted, 2.49}, Case{"bunny", Content::fitted, 3.02},
                                         Case{"random10k", Content::fitted, 2.86},
                                         Case{"cube", Content::fitted, 14.26}),
                         [](const auto& test) { return std::string(test.param.scene); });
INSTANTIATE_TEST_SUITE_P(Colour, StoreRatio,
                         testing::Values(Case{"room", Content::colour, 5.09}, Case{"teapot", Content::colour, 2.90},
                                         Case{"knot", Content::colour, 2.43}, Case{"random10k", Content::colour, 2.39},
                                         Case{"random50", Content::colour, 12.91}, Case{"cube", Content::colour, 3.16}),
                         [](const auto& test) { return std::string(test.param.scene); });

}  // namespace
}  // namespace store_test
