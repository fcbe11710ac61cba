// The output formats, pixel by pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "zstrip/resolve/resolve.hpp"

namespace {

using namespace zstrip;

TEST(Resolve, LumaOfEveryPixelIsTheWeightedSum) {
  for (std::uint32_t pixel = 0; pixel < 65536; ++pixel) {
    const std::uint32_t r5 = pixel / 2048, g6 = pixel / 32 % 64, b5 = pixel % 32;
    const std::uint32_t r = r5 * 8 + r5 / 4, g = g6 * 4 + g6 / 16, b = b5 * 8 + b5 / 4;
    ASSERT_EQ(detail::luma(static_cast<std::uint16_t>(pixel)), (77 * r + 150 * g + 29 * b + 128) / 256);
  }
}

TEST(Resolve, Gray4PacksLeftPixelHighAndEndsRowsAtBytes) {
  const std::uint16_t row[3] = {0xFFFF, 0x0000, 0xFFFF};
  std::byte out[2] = {std::byte{0x55}, std::byte{0x55}};
  detail::resolve_gray4(row, 3, out);
  EXPECT_EQ(out[0], std::byte{0xF0});
  EXPECT_EQ(out[1], std::byte{0xF0});
}

TEST(Resolve, MonoPacksLeftPixelInTheHighestBit) {
  std::vector<std::uint16_t> row(10, 0);
  row[0] = row[9] = 0xFFFF;
  std::byte out[2];
  detail::resolve_mono(row.data(), 10, out);
  EXPECT_EQ(out[0], std::byte{0x80});
  EXPECT_EQ(out[1], std::byte{0x40});
}

TEST(Resolve, Rgb444EndsOddRowsWithADarkNibbleAndWritesNoMore) {
  const std::uint16_t row[3] = {0xFFFF, 0x0000, 0xFFFF};
  std::byte out[6];
  std::fill_n(out, 6, std::byte{0x55});
  detail::resolve_rgb444(row, 3, out);
  for (const auto& [index, value] : {std::pair{0, 0xFF}, {1, 0xF0}, {2, 0x00}, {3, 0xFF}, {4, 0xF0}, {5, 0x55}}) {
    EXPECT_EQ(std::to_integer<int>(out[index]), value) << index;
  }
}

TEST(Resolve, SwapsBytesOfOddCountsAtOddPixels) {
  for (std::uint32_t first = 0; first < 2; ++first) {
    for (std::uint32_t count = 0; count < 6; ++count) {
      std::vector<std::uint16_t> pixels(first + count + 1, 0x1234);
      detail::swap_bytes(pixels.data() + first, count);
      for (std::uint32_t i = 0; i < pixels.size(); ++i) {
        EXPECT_EQ(pixels[i], i >= first && i < first + count ? 0x3412 : 0x1234) << first << ' ' << count << ' ' << i;
      }
    }
  }
}

}  // namespace
