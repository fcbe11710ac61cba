// Conversions between 16-bit formats, for every input: texels times light, codes of the small float, panel formats.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "zstrip/pixels/colour.hpp"
#include "zstrip/resolve/convert.hpp"
#include "zstrip/resolve/resolve.hpp"
#include "zstrip/scene/depth_format.hpp"

namespace {

using namespace zstrip;

std::vector<std::uint16_t> every_pixel() {
  std::vector<std::uint16_t> pixels(65536);
  std::iota(pixels.begin(), pixels.end(), std::uint16_t{0});
  return pixels;
}

TEST(Conversion, EveryTexelTimesEveryLightIsRoundedToNearest) {
  for (std::uint32_t light = 0; light < 256; ++light) {
    const double factor = (light + light / 128) / 256.0;  // 255 is one
    const auto times = [&](std::uint32_t channel) {
      return static_cast<std::uint32_t>(std::floor(channel * factor + 0.5));
    };
    for (const std::uint16_t texel : every_pixel()) {
      // The fraction of a light does not count.
      const std::uint32_t whole = light << 16, most = whole | 0xFFFF;
      const std::uint32_t expected = times(texel / 2048U) * 2048 + times(texel / 32U % 64) * 32 + times(texel % 32U);
      ASSERT_EQ(detail::modulated(texel, whole, most, whole), expected) << texel << " by " << light;
    }
  }
}

TEST(Conversion, EveryChannelLosesItsLowestBits) {
  for (std::uint32_t value = 0; value < 256; ++value) {
    const auto channel = static_cast<std::uint8_t>(value);
    const std::uint32_t r = value / 8 * 2048, g = value / 4 * 32, b = value / 8;
    EXPECT_EQ(detail::rgb565(Colour{channel, 0, 0, 255}), r);
    EXPECT_EQ(detail::rgb565(Colour{0, channel, 0, 255}), g);
    EXPECT_EQ(detail::rgb565(Colour{0, 0, channel, 255}), b);
    const auto start = static_cast<std::uint32_t>(detail::channel_start(channel));
    EXPECT_EQ(detail::rgb565(start, start, start), r + g + b);
  }
}

TEST(Conversion, EveryCodeOfTheSmallFloatBeginsWhereItIsDocumented) {
  for (std::uint32_t code = 1; code < 65536; ++code) {
    // docs/conventions.md: v >> 12 below 2^25, else E << 13 | ((v >> (11 + E)) & 0x1FFF), v in [2^(24+E), 2^(25+E)).
    const std::uint32_t exponent = code >> 13, mantissa = code & 0x1FFF;
    const std::uint32_t first =
        exponent == 0 ? mantissa << 12 : (1U << (24 + exponent)) + (mantissa << (11 + exponent));
    ASSERT_EQ(float16_code(first), code);
    ASSERT_EQ(float16_code(first - 1), code - 1);
    ASSERT_EQ(float16_octave(first), exponent == 0 ? 0 : exponent - 1) << code;
  }
}

TEST(Conversion, EveryPixelInThePanelFormats) {
  for (const std::uint16_t pixel : every_pixel()) {
    const std::uint32_t r5 = pixel / 2048U, g6 = pixel / 32U % 64, b5 = pixel % 32U;
    const std::uint32_t grey = (77 * (r5 * 8 + r5 / 4) + 150 * (g6 * 4 + g6 / 16) + 29 * (b5 * 8 + b5 / 4) + 128) / 256;
    const std::uint16_t row[2] = {pixel, pixel};
    std::byte gray4{}, mono{};
    detail::resolve_gray4(row, 2, &gray4);
    detail::resolve_mono(row, 2, &mono);
    ASSERT_EQ(std::to_integer<std::uint32_t>(gray4), grey / 16 * 17) << pixel;
    ASSERT_EQ(std::to_integer<std::uint32_t>(mono), grey >= 128 ? 0xC0U : 0U) << pixel;
    std::uint16_t swapped = pixel;
    detail::swap_bytes(&swapped, 1);
    ASSERT_EQ(swapped, pixel % 256 * 256 + pixel / 256);

    const std::uint32_t r8 = r5 * 8 + r5 / 4, g8 = g6 * 4 + g6 / 16, b8 = b5 * 8 + b5 / 4;
    std::uint16_t pair[2] = {pixel, static_cast<std::uint16_t>(~pixel)};
    std::array<std::byte, 8> out{};
    const auto sent = [&](PixelFormat format) {
      convert_pixels(format, 2, 1, pair, out.data());
      std::uint64_t value = 0;  // the first byte is the highest
      for (const std::byte byte : out) value = value * 256 + std::to_integer<std::uint64_t>(byte);
      return value;
    };
    const std::uint64_t left = r5 / 2 * 256 + g6 / 4 * 16 + b5 / 2;
    const std::uint64_t right = (31 - r5) / 2 * 256 + (63 - g6) / 4 * 16 + (31 - b5) / 2;
    ASSERT_EQ(sent(PixelFormat::rgb444) >> 40, left * 4096 + right) << pixel;
    ASSERT_EQ(sent(PixelFormat::rgb666) >> 40, r8 / 4 * 4 * 65536 + g8 / 4 * 4 * 256 + b8 / 4 * 4) << pixel;
    ASSERT_EQ(sent(PixelFormat::xrgb8888) >> 32, b8 * 16777216ULL + g8 * 65536 + r8 * 256) << pixel;
    ASSERT_EQ(sent(PixelFormat::xrgb8888) % 0x100000000, 0xFFFFFF00 - (b8 * 16777216ULL + g8 * 65536 + r8 * 256))
        << pixel;
  }
}

}  // namespace
