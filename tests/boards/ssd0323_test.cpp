// The driver of the SSD0323 against a model of the panel that minds the set-up, which the emulator's does not.
#include "zstrip_hal/ssd0323.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "ssd0323_panel.hpp"

namespace zstrip::hal {
namespace {

using boards::GreyPicture;
using boards::Ssd0323Panel;

const GreyPicture kBlack{128, 64, std::vector<std::uint8_t>(128 * 64, 0)};

TEST(Ssd0323, DarkBeforeTheStart) {
  Ssd0323Panel panel;
  EXPECT_FALSE(panel.seen());
}

TEST(Ssd0323, BlackAfterTheStart) {
  Ssd0323Panel panel;
  Ssd0323 display(panel);
  EXPECT_EQ(display.start(), Error::none);
  EXPECT_EQ(panel.complaint(), "");
  EXPECT_EQ(panel.seen(), kBlack);
}

TEST(Ssd0323, KeepsItsPixelOrderWhateverTheConfiguration) {
  Ssd0323Panel panel;
  Ssd0323 display(panel, {.remap = 0x05, .dc_dc_converter = false});
  EXPECT_EQ(display.start(), Error::none);
  EXPECT_EQ(panel.complaint(), "");
  EXPECT_EQ(panel.seen(), kBlack);
}

TEST(Ssd0323, WritesWindowsExactly) {
  Ssd0323Panel panel;
  Ssd0323 display(panel);
  ASSERT_EQ(display.start(), Error::none);
  GreyPicture expected = kBlack;
  std::uint8_t level = 1;
  for (const Area& area : {Area{0, 0, 128, 64}, Area{0, 0, 2, 1}, Area{126, 63, 2, 1}, Area{40, 10, 30, 17},
                           Area{0, 63, 128, 1}, Area{64, 0, 2, 64}}) {
    std::vector<std::byte> pixels(area.width / 2U * area.height, static_cast<std::byte>(level << 4 | (level + 1)));
    pixels.push_back(std::byte{0xFF});  // more than the area needs: not to be sent
    ASSERT_EQ(display.write(area, pixels), Error::none);
    ASSERT_EQ(display.wait(), Error::none);
    for (int y = area.top; y < area.top + area.height; ++y) {
      for (int x = area.left; x < area.left + area.width; ++x) {
        expected.levels[static_cast<std::size_t>(y * 128 + x)] = static_cast<std::uint8_t>(level + x % 2);
      }
    }
    EXPECT_EQ(boards::difference(expected, panel.seen().value()), "");
    level = static_cast<std::uint8_t>(level + 2);
  }
  EXPECT_EQ(panel.complaint(), "");
}

TEST(Ssd0323, RefusesAreasThatDoNotFit) {
  Ssd0323Panel panel;
  Ssd0323 display(panel);
  ASSERT_EQ(display.start(), Error::none);
  std::vector<std::byte> pixels(128 * 64, std::byte{0xFF});
  for (const Area& area : {Area{0, 0, 130, 1}, Area{2, 0, 128, 1}, Area{0, 0, 128, 65}, Area{0, 64, 2, 1},
                           Area{0, 0, 0, 1}, Area{0, 0, 2, 0}, Area{65534, 0, 2, 1}, Area{0, 65535, 2, 65535}}) {
    EXPECT_EQ(display.write(area, pixels), Error::area);
  }
  EXPECT_EQ(display.write({1, 0, 2, 1}, pixels), Error::alignment);
  EXPECT_EQ(display.write({0, 0, 3, 1}, pixels), Error::alignment);
  EXPECT_EQ(display.write({0, 0, 128, 64}, std::span(pixels).first(128 * 32 - 1)), Error::pixels_too_small);
  EXPECT_EQ(panel.seen(), kBlack);
}

/// A bus on which the operation of this number, and every later one, times out.
struct FailingBus {
  int left;
  Error use() { return left-- > 0 ? Error::none : Error::timeout; }
  Error write_command(std::span<const std::byte>) { return use(); }
  Error write_data(std::span<const std::byte>) { return use(); }
  Error wait() { return use(); }
};

TEST(Ssd0323, ReportsABusThatFailsAtAnyStep) {
  constexpr int kMany = 1'000'000;
  FailingBus working{kMany};
  Ssd0323 working_display(working);
  ASSERT_EQ(working_display.start(), Error::none);
  const int steps = kMany - working.left;
  for (int step = 0; step < steps; ++step) {
    FailingBus bus{step};
    Ssd0323 display(bus);
    EXPECT_EQ(display.start(), Error::timeout) << "step " << step;
  }
}

}  // namespace
}  // namespace zstrip::hal
