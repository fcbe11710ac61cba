// Dithering to fewer bits: every value at every threshold, and rectangles in every format of panels.
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

#include "dither_oracle.hpp"
#include "zstrip/base/bayer.hpp"
#include "zstrip/effects/dithering/dither.hpp"
#include "zstrip/pixels/colour.hpp"
#include "zstrip/resolve/convert.hpp"

namespace {

using namespace zstrip;

TEST(Dither, TheMatrixIsBayers) {
  std::set<int> seen;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      EXPECT_EQ(detail::kBayer[y][x], dither_oracle::bayer(x, y, 8)) << x << ", " << y;
      seen.insert(detail::kBayer[y][x]);
    }
  }
  EXPECT_EQ(seen.size(), 64U);
}

template <int bits>
void check_every_value() {
  constexpr int kSteps = 1 << bits, kStep = 256 / kSteps;
  for (int value = 0; value < 256; ++value) {
    int sum = 0;
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 8; ++x) {
        const int level =
            static_cast<int>(detail::dithered<bits>(static_cast<std::uint32_t>(value), detail::kBayer[y][x]));
        ASSERT_EQ(level, dither_oracle::level(value, bits, x, y)) << bits << " bits, " << value;
        ASSERT_LT(level, kSteps);
        sum += level;
      }
    }
    // The mean is the value, in a scale on which both ends are levels.
    const int scaled = value - value / kSteps;
    EXPECT_EQ(sum, bits == 1 ? scaled / 2 : 64 * scaled / kStep) << bits << " bits, " << value;
    if (bits >= 2) {
      EXPECT_EQ(64 * scaled % kStep, 0);
    }
  }
  EXPECT_EQ(detail::dithered<bits>(0, 63), 0U);
  EXPECT_EQ(detail::dithered<bits>(255, 0), kSteps - 1U);
}

TEST(Dither, EveryValueHasItsMeanAndBothEndsAreFlat) {
  check_every_value<1>();
  check_every_value<4>();
  check_every_value<5>();
  check_every_value<6>();
}

TEST(Dither, EveryPixelThatRgb565HasStaysAsItIs) {
  for (std::uint32_t pixel = 0; pixel < 65536; ++pixel) {
    const std::uint32_t r = pixel >> 11, g = pixel >> 5 & 63, b = pixel & 31;
    for (const std::uint32_t threshold : {0U, 31U, 63U}) {
      ASSERT_EQ(detail::dithered_rgb565(r << 3 | r >> 2, g << 2 | g >> 4, b << 3 | b >> 2, threshold), pixel);
    }
  }
}

/// Pixel (x, y) of a picture of all kinds of colours.
std::uint16_t colour_at(int x, int y) { return static_cast<std::uint16_t>((x * 2749 + y * 40503) ^ (x * y)); }

/// What is sent of a pixel: 1, 4 or 12 bits.
std::uint32_t expected_at(PixelFormat format, int x, int y) {
  const int pixel = colour_at(x, y), r5 = pixel / 2048, g6 = pixel / 32 % 64, b5 = pixel % 32;
  const int r = r5 * 8 + r5 / 4, g = g6 * 4 + g6 / 16, b = b5 * 8 + b5 / 4;
  const int grey = (77 * r + 150 * g + 29 * b + 128) / 256;
  const auto level = [&](int value, int bits) {
    return static_cast<std::uint32_t>(dither_oracle::level(value, bits, x, y));
  };
  if (format == PixelFormat::mono) return level(grey, 1);
  if (format == PixelFormat::gray4) return level(grey, 4);
  return level(r, 4) * 256 + level(g, 4) * 16 + level(b, 4);
}

std::vector<std::byte> sent(PixelFormat format, const Rect& area) {
  std::vector<std::uint16_t> pixels;
  for (int y = area.top; y < area.bottom; ++y) {
    for (int x = area.left; x < area.right; ++x) pixels.push_back(colour_at(x, y));
  }
  std::vector<std::byte> out(static_cast<std::size_t>(area.height()) *
                             bytes_per_row(static_cast<std::uint16_t>(area.width()), format));
  dither_pixels(format, area, pixels.data());
  convert_pixels(format, static_cast<std::uint16_t>(area.width()), static_cast<std::uint16_t>(area.height()),
                 pixels.data(), out.data());
  return out;
}

/// `bits` bits from bit `at` of a row of bytes on, the highest first.
std::uint32_t bits_of(const std::byte* row, std::uint32_t at, std::uint32_t bits) {
  std::uint32_t value = 0;
  for (std::uint32_t i = at; i < at + bits; ++i) {
    value = value * 2 + (std::to_integer<std::uint32_t>(row[i / 8]) >> (7 - i % 8) & 1U);
  }
  return value;
}

TEST(Dither, RectanglesAnywhereAreDitheredAsTheirPlaceInThePictureSays) {
  for (const PixelFormat format : {PixelFormat::mono, PixelFormat::gray4, PixelFormat::rgb444}) {
    const std::uint32_t bits = format == PixelFormat::mono ? 1 : format == PixelFormat::gray4 ? 4 : 12;
    for (const Rect& area : {Rect{0, 0, 40, 20}, Rect{8, 3, 24, 4}, Rect{5, 6, 18, 15}, Rect{17, 7, 18, 9}}) {
      const std::vector<std::byte> out = sent(format, area);
      const std::size_t row_bytes = bytes_per_row(static_cast<std::uint16_t>(area.width()), format);
      for (int y = area.top; y < area.bottom; ++y) {
        const std::byte* const row = out.data() + static_cast<std::size_t>(y - area.top) * row_bytes;
        for (int x = area.left; x < area.right; ++x) {
          ASSERT_EQ(bits_of(row, static_cast<std::uint32_t>(x - area.left) * bits, bits), expected_at(format, x, y))
              << x << ", " << y << ", " << bits << " bits";
        }
        const std::uint32_t end = static_cast<std::uint32_t>(area.width()) * bits;
        EXPECT_EQ(bits_of(row, end, static_cast<std::uint32_t>(row_bytes) * 8 - end), 0U) << "behind the row";
      }
    }
  }
}

TEST(Dither, WhatHasNoFewerBitsIsConvertedAsWithout) {
  for (const PixelFormat format : {PixelFormat::rgb666, PixelFormat::xrgb8888}) {
    const Rect area{3, 5, 12, 9};
    std::vector<std::uint16_t> pixels;
    for (int y = area.top; y < area.bottom; ++y) {
      for (int x = area.left; x < area.right; ++x) pixels.push_back(colour_at(x, y));
    }
    std::vector<std::byte> plain(static_cast<std::size_t>(area.height()) * bytes_per_row(9, format));
    convert_pixels(format, 9, 4, pixels.data(), plain.data());
    EXPECT_EQ(sent(format, area), plain);
  }
}

}  // namespace
