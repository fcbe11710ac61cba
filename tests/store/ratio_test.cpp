// The ratios that the depth store reaches: 16 bits a cell of the bounding rectangle to the bytes of the pool, index
// included, as an average of six frames. Bytes are the same everywhere, so the bounds are what was reached.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "measured_scenes.hpp"
#include "zstrip/store/depth_store.hpp"

namespace store_test {
namespace {

using namespace zstrip;

struct Case {
  const char* scene;
  DepthFormat format;
  double reached;
};

void PrintTo(const Case& c, std::ostream* stream) { *stream << c.scene; }

class DepthRatio : public testing::TestWithParam<Case> {};

double ratio_of(const DepthImage& image) {
  std::vector<std::byte> pool(store_bytes_worst(image.width, image.height));
  DepthStore store;
  EXPECT_TRUE(store.reset(pool, image.width, image.height));
  EXPECT_TRUE(store.write_rows({image.cells.data(), image.width, 0, image.height}));
  std::vector<std::uint16_t> cells(image.cells.size(), 0xA5A5);
  EXPECT_TRUE(store.read_rows({cells.data(), image.width, 0, image.height}));
  EXPECT_TRUE(cells == image.cells);
  return 2.0 * static_cast<double>(image.cells.size()) / store.bytes_used();
}

TEST_P(DepthRatio, IsReached) {
  const std::vector<DepthImage> images = depth_images(GetParam().scene, GetParam().format);
  if (images.empty()) GTEST_SKIP() << "no model file";
  double sum = 0, worst = 1e9;
  for (const DepthImage& image : images) {
    const double ratio = ratio_of(image);
    sum += ratio;
    worst = std::min(worst, ratio);
  }
  const double mean = sum / static_cast<double>(images.size());
  std::printf("%s: %.3f, worst frame %.3f\n", GetParam().scene, mean, worst);
  EXPECT_GE(mean, GetParam().reached);
}

INSTANTIATE_TEST_SUITE_P(
    SmallFloat, DepthRatio,
    testing::Values(Case{"room", DepthFormat::small_float, 9.41}, Case{"teapot", DepthFormat::small_float, 4.20},
                    Case{"knot", DepthFormat::small_float, 3.57}, Case{"bunny", DepthFormat::small_float, 4.17},
                    Case{"random10k", DepthFormat::small_float, 3.35}, Case{"cube", DepthFormat::small_float, 14.80}),
    [](const auto& test) { return std::string(test.param.scene); });
INSTANTIATE_TEST_SUITE_P(
    Fitted, DepthRatio,
    testing::Values(Case{"room", DepthFormat::fitted, 11.02}, Case{"teapot", DepthFormat::fitted, 3.22},
                    Case{"knot", DepthFormat::fitted, 2.56}, Case{"bunny", DepthFormat::fitted, 3.07},
                    Case{"random10k", DepthFormat::fitted, 2.89}, Case{"cube", DepthFormat::fitted, 14.74}),
    [](const auto& test) { return std::string(test.param.scene); });

}  // namespace
}  // namespace store_test
