// The checksum of a picture from its rectangles, against zlib's of the whole picture; and the panel that sums it.
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include "portable/checksum_panel.hpp"

namespace zstrip::boards {
namespace {

using board::ChecksumPanel;
using board::PictureCrc32;

std::vector<std::byte> random_bytes(std::mt19937& random, std::size_t count) {
  std::vector<std::byte> bytes(count);
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
  return bytes;
}

std::uint32_t zlib_crc32(const std::vector<std::byte>& bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(crc32_z(0, nullptr, 0), reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

TEST(PictureCrc32, PartsInAnyOrderAreTheWhole) {
  std::mt19937 random(1);
  for (const std::size_t size : {1U, 2U, 3U, 255U, 256U, 257U, 4096U, 115'200U}) {
    const std::vector<std::byte> picture = random_bytes(random, size);
    std::vector<std::size_t> cuts{0, size};
    for (int cut = 0; cut < 9; ++cut) cuts.push_back(random() % (size + 1));
    std::sort(cuts.begin(), cuts.end());
    std::vector<std::size_t> order(cuts.size() - 1);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    PictureCrc32 crc(static_cast<std::uint32_t>(size));
    for (const std::size_t part : order) {
      crc.add(static_cast<std::uint32_t>(cuts[part]),
              std::span(picture).subspan(cuts[part], cuts[part + 1] - cuts[part]));
    }
    EXPECT_TRUE(crc.complete());
    EXPECT_EQ(crc.value(), zlib_crc32(picture)) << size;
  }
}

TEST(ChecksumPanel, TilesAreTheWholePicture) {
  constexpr std::uint16_t kWidth = 30, kHeight = 20;
  std::mt19937 random(2);
  const std::vector<std::byte> picture = random_bytes(random, kWidth * kHeight * 2);
  ChecksumPanel<kWidth, kHeight> panel;
  for (const hal::Area tile : {hal::Area{0, 0, 30, 20}, hal::Area{0, 0, 7, 3}, hal::Area{0, 0, 30, 6}}) {
    ASSERT_EQ(panel.begin_frame(), hal::Error::none);
    for (int top = (kHeight - 1) / tile.height * tile.height; top >= 0; top -= tile.height) {  // from below
      for (int left = 0; left < kWidth; left += tile.width) {
        const hal::Area area{static_cast<std::uint16_t>(left), static_cast<std::uint16_t>(top),
                             static_cast<std::uint16_t>(std::min<int>(tile.width, kWidth - left)),
                             static_cast<std::uint16_t>(std::min<int>(tile.height, kHeight - top))};
        std::vector<std::byte> pixels;
        for (int row = top; row < top + area.height; ++row) {
          const auto begin = picture.begin() + (row * kWidth + left) * 2;
          pixels.insert(pixels.end(), begin, begin + area.width * 2);
        }
        ASSERT_EQ(panel.write(area, pixels), hal::Error::none);
      }
    }
    EXPECT_EQ(panel.end_frame(), hal::Error::none);
    EXPECT_EQ(panel.crc32(), zlib_crc32(picture));
  }
}

TEST(ChecksumPanel, RefusesWhatAPanelCannotShow) {
  ChecksumPanel<8, 4> panel;
  const std::vector<std::byte> pixels(8 * 4 * 2);
  ASSERT_EQ(panel.begin_frame(), hal::Error::none);
  EXPECT_EQ(panel.write({0, 0, 9, 1}, pixels), hal::Error::area);
  EXPECT_EQ(panel.write({0, 3, 8, 2}, pixels), hal::Error::area);
  EXPECT_EQ(panel.write({0, 0, 0, 1}, pixels), hal::Error::area);
  EXPECT_EQ(panel.write({0, 0, 8, 4}, std::span(pixels).first(63)), hal::Error::pixels_too_small);
  EXPECT_EQ(panel.end_frame(), hal::Error::strip_layout);
  EXPECT_EQ(panel.write({0, 0, 8, 4}, pixels), hal::Error::none);
  EXPECT_EQ(panel.end_frame(), hal::Error::none);
}

}  // namespace
}  // namespace zstrip::boards
