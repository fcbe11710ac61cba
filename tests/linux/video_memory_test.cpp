// RGB565 into video memory of other layouts, against the widening of the tests' own pictures; and memory that ends
// early.
#include "zstrip_hal_linux/video_memory.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "colour_picture.hpp"

namespace zstrip::hal {
namespace {

constexpr std::uint16_t kWidth = 256, kHeight = 256;  // every colour once

std::vector<std::uint16_t> all_colours() {
  std::vector<std::uint16_t> colours;
  for (unsigned colour = 0; colour < 65536; ++colour) colours.push_back(static_cast<std::uint16_t>(colour));
  return colours;
}

/// Rows of pixels with some bytes between them, written as a whole.
std::vector<std::byte> written(const PixelLayout& layout, std::uint32_t stride) {
  const std::vector<std::uint16_t> colours = all_colours();
  std::vector<std::byte> memory(std::size_t{stride} * kHeight, std::byte{0x5A});
  const auto writer = PixelWriter::create(layout);
  EXPECT_TRUE(writer);
  EXPECT_EQ(
      writer->write({memory, kWidth, kHeight, stride}, {0, 0, kWidth, kHeight}, std::as_bytes(std::span(colours))),
      Error::none);
  return memory;
}

TEST(LinuxVideoMemory, EightBitsRepeatTheUpperOnes) {
  const auto expected = boards::widened(all_colours(), kWidth, kHeight, boards::LowBits::repeated);
  struct Order {
    PixelLayout layout;
    int red, green, blue;  // bytes of a pixel
  };
  for (const Order& order :
       {Order{kXrgb8888Layout, 2, 1, 0}, Order{{4, {0, 8}, {8, 8}, {16, 8}}, 0, 1, 2},
        Order{{3, {16, 8}, {8, 8}, {0, 8}}, 2, 1, 0}, Order{{3, {0, 8}, {8, 8}, {16, 8}}, 0, 1, 2}}) {
    const std::uint32_t bytes = order.layout.bytes;
    const std::uint32_t stride = kWidth * bytes + 5;
    const std::vector<std::byte> memory = written(order.layout, stride);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const std::byte* pixel = &memory[static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x) * bytes];
        const auto& colour = expected.at(x, y);
        ASSERT_EQ(std::to_integer<int>(pixel[order.red]), colour[0]) << x << " " << y;
        ASSERT_EQ(std::to_integer<int>(pixel[order.green]), colour[1]) << x << " " << y;
        ASSERT_EQ(std::to_integer<int>(pixel[order.blue]), colour[2]) << x << " " << y;
      }
      ASSERT_EQ(memory[static_cast<std::size_t>(y) * stride + kWidth * bytes], std::byte{0x5A}) << "beyond the row";
    }
  }
}

TEST(LinuxVideoMemory, SixteenBits) {
  const std::vector<std::uint16_t> colours = all_colours();
  std::vector<std::byte> same(colours.size() * 2);
  std::memcpy(same.data(), colours.data(), same.size());
  EXPECT_EQ(written(kRgb565Layout, kWidth * 2), same);

  // 15 bits: the lowest bit of green is dropped, the bit of no colour is set.
  const std::vector<std::byte> memory = written({2, {10, 5}, {5, 5}, {0, 5}}, kWidth * 2);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    std::uint16_t pixel = 0;
    std::memcpy(&pixel, &memory[2 * i], sizeof pixel);
    const unsigned red = colours[i] / 2048U, green = colours[i] / 64U % 32U, blue = colours[i] % 32U;
    ASSERT_EQ(pixel, 32768U + red * 1024U + green * 32U + blue) << i;
  }
}

TEST(LinuxVideoMemory, LayoutsThatAreNone) {
  for (const PixelLayout& layout : {PixelLayout{1, {5, 3}, {2, 3}, {0, 2}}, PixelLayout{5, {16, 8}, {8, 8}, {0, 8}},
                                    PixelLayout{4, {16, 8}, {8, 8}, {0, 0}}, PixelLayout{4, {16, 8}, {8, 9}, {0, 8}},
                                    PixelLayout{3, {17, 8}, {8, 8}, {0, 8}}, PixelLayout{2, {11, 5}, {5, 6}, {4, 5}}}) {
    EXPECT_FALSE(PixelWriter::create(layout));
  }
}

TEST(LinuxVideoMemory, OnlyTheAreaAndNothingBeyondTheMemory) {
  const auto writer = PixelWriter::create(kXrgb8888Layout);
  ASSERT_TRUE(writer);
  const std::vector<std::byte> white(2 * 3 * 2, std::byte{0xFF});
  std::vector<std::byte> bytes(8 * 4 * 5 - 4);  // the last pixel is not there
  const VideoMemory memory{bytes, 8, 5, 8 * 4};
  EXPECT_EQ(writer->write(memory, {4, 1, 3, 2}, white), Error::none);
  int lit = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::size_t x = i / 4 % 8, y = i / 32;
    EXPECT_EQ(bytes[i] != std::byte{0}, x >= 4 && x < 7 && y >= 1 && y < 3) << i;
    lit += bytes[i] != std::byte{0} ? 1 : 0;
  }
  EXPECT_EQ(lit, 24);
  EXPECT_EQ(writer->write(memory, {6, 1, 3, 2}, white), Error::area);
  EXPECT_EQ(writer->write(memory, {0, 4, 3, 2}, white), Error::area);
  EXPECT_EQ(writer->write(memory, {0, 0, 0, 2}, white), Error::area);
  EXPECT_EQ(writer->write(memory, {0, 0, 3, 2}, std::span(white).first(11)), Error::pixels_too_small);
  EXPECT_EQ(writer->write(memory, {5, 3, 3, 2}, white), Error::area) << "the memory is smaller than it says";
}

}  // namespace
}  // namespace zstrip::hal
