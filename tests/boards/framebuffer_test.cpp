// A picture in memory: every rectangle lands where it belongs and nowhere else, and what does not fit is refused.
#include "zstrip_hal/framebuffer.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace zstrip::hal {
namespace {

constexpr std::byte kUntouched{0xEE};

std::vector<std::byte> numbered(std::size_t count) {
  std::vector<std::byte> bytes;
  for (std::size_t i = 0; i < count; ++i) bytes.push_back(static_cast<std::byte>(i + 1));
  return bytes;
}

// Every rectangle of a 6x5 picture whose rows are 16 bytes apart.
TEST(Framebuffer, CopiesEveryRectangle) {
  constexpr std::uint16_t kWidth = 6, kHeight = 5;
  constexpr std::size_t kStride = 16;
  for (std::uint16_t top = 0; top < kHeight; ++top) {
    for (std::uint16_t left = 0; left < kWidth; ++left) {
      for (std::uint16_t height = 1; top + height <= kHeight; ++height) {
        for (std::uint16_t width = 1; left + width <= kWidth; ++width) {
          std::vector<std::byte> memory(kStride * (kHeight - 1) + 2 * kWidth,
                                        kUntouched);  // no gap behind the last row
          std::vector<std::byte> expected = memory;
          const std::vector<std::byte> pixels = numbered(2U * width * height);
          for (std::size_t i = 0; i < pixels.size(); ++i) {
            const std::size_t row = top + i / (2U * width), column = 2U * left + i % (2U * width);
            expected[row * kStride + column] = pixels[i];
          }
          Framebuffer display(memory, {kWidth, kHeight, DisplayFormat::rgb565, kStride});
          ASSERT_EQ(display.begin_frame(), Error::none);
          ASSERT_EQ(display.write({left, top, width, height}, pixels), Error::none);
          ASSERT_EQ(display.wait(), Error::none);
          ASSERT_EQ(display.end_frame(), Error::none);
          ASSERT_EQ(memory, expected) << left << ' ' << top << ' ' << width << ' ' << height;
        }
      }
    }
  }
}

TEST(Framebuffer, RefusesMemoryThatIsTooSmall) {
  for (std::size_t bytes = 0; bytes < 3 * 20 + 12; ++bytes) {
    std::vector<std::byte> memory(bytes, kUntouched);
    Framebuffer display(memory, {6, 4, DisplayFormat::rgb565, 20});
    EXPECT_EQ(display.begin_frame(), Error::framebuffer) << bytes;
    EXPECT_EQ(display.write({0, 0, 6, 4}, numbered(48)), Error::framebuffer) << bytes;
    EXPECT_EQ(memory, std::vector<std::byte>(bytes, kUntouched));
  }
  std::vector<std::byte> memory(3 * 20 + 12);
  EXPECT_EQ(Framebuffer(memory, {6, 4, DisplayFormat::rgb565, 20}).begin_frame(), Error::none);
}

TEST(Framebuffer, RefusesRowsThatOverlapAndEmptyPictures) {
  std::vector<std::byte> memory(1000);
  EXPECT_EQ(Framebuffer(memory, {6, 4, DisplayFormat::rgb565, 11}).begin_frame(), Error::framebuffer);
  EXPECT_EQ(Framebuffer(memory, {0, 4, DisplayFormat::rgb565}).begin_frame(), Error::framebuffer);
  EXPECT_EQ(Framebuffer(memory, {6, 0, DisplayFormat::rgb565}).begin_frame(), Error::framebuffer);
  EXPECT_EQ(Framebuffer(memory, {6, 4, DisplayFormat::rgb565, 0xFFFFFFFF}).begin_frame(), Error::framebuffer);
  EXPECT_EQ(Framebuffer(memory, {6, 4, DisplayFormat::rgb565, 12}).begin_frame(), Error::none);
}

TEST(Framebuffer, RefusesWrongRectangles) {
  std::vector<std::byte> memory(48, kUntouched);
  Framebuffer display(memory, {6, 4, DisplayFormat::rgb565});
  const std::vector<std::byte> pixels = numbered(100);
  EXPECT_EQ(display.write({1, 0, 6, 1}, pixels), Error::area);
  EXPECT_EQ(display.write({0, 4, 1, 1}, pixels), Error::area);
  EXPECT_EQ(display.write({0, 0, 0, 1}, pixels), Error::area);
  EXPECT_EQ(display.write({0, 0, 6, 4}, std::span(pixels).first(47)), Error::pixels_too_small);
  EXPECT_EQ(memory, std::vector<std::byte>(48, kUntouched));
}

TEST(Framebuffer, PixelsThatShareAByte) {
  std::vector<std::byte> memory(8, kUntouched);
  Framebuffer display(memory, {7, 2, DisplayFormat::gray4});
  const std::vector<std::byte> pixels = numbered(8);
  EXPECT_EQ(display.write({1, 0, 2, 1}, pixels), Error::alignment);
  EXPECT_EQ(display.write({0, 0, 3, 1}, pixels), Error::alignment);
  EXPECT_EQ(display.write({4, 1, 3, 1}, pixels), Error::none) << "to the right edge";
  EXPECT_EQ(memory[6], std::byte{1});
  EXPECT_EQ(memory[7], std::byte{2});
  EXPECT_EQ(memory[5], kUntouched);
}

}  // namespace
}  // namespace zstrip::hal
