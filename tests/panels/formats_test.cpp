// The core's pixel formats and the HAL's are the same, though neither knows the other.
#include <gtest/gtest.h>

#include <cstdint>

#include "zstrip/view.hpp"
#include "zstrip_hal/display.hpp"

namespace {

struct Format {
  zstrip::PixelFormat core;
  zstrip::hal::DisplayFormat hal;
  std::uint32_t bits;  // of a pixel
};
constexpr Format kFormats[] = {
    {zstrip::PixelFormat::rgb565, zstrip::hal::DisplayFormat::rgb565, 16},
    {zstrip::PixelFormat::rgb565_swapped, zstrip::hal::DisplayFormat::rgb565_swapped, 16},
    {zstrip::PixelFormat::gray4, zstrip::hal::DisplayFormat::gray4, 4},
    {zstrip::PixelFormat::mono, zstrip::hal::DisplayFormat::mono, 1},
    {zstrip::PixelFormat::rgb666, zstrip::hal::DisplayFormat::rgb666, 24},
    {zstrip::PixelFormat::rgb444, zstrip::hal::DisplayFormat::rgb444, 12},
    {zstrip::PixelFormat::xrgb8888, zstrip::hal::DisplayFormat::xrgb8888, 32},
};
static_assert(std::size(kFormats) == static_cast<std::size_t>(zstrip::kLastPixelFormat) + 1,
              "a format is missing here");

TEST(PanelFormats, CoreAndHalAgree) {
  for (const Format& format : kFormats) {
    EXPECT_EQ(static_cast<int>(format.core), static_cast<int>(format.hal));
    for (std::uint32_t width = 1; width <= zstrip::kMaxViewSize; ++width) {
      const auto columns = static_cast<std::uint16_t>(width);
      ASSERT_EQ(zstrip::bytes_per_row(columns, format.core), (width * format.bits + 7) / 8);
      ASSERT_EQ(zstrip::hal::bytes_per_row(columns, format.hal), (width * format.bits + 7) / 8);
    }
  }
}

}  // namespace
