// Every driver against the model of its controller: orientations, formats, wirings, windows, sleep, strips in two
// buffers, and a bus that fails at every step.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "bench.hpp"
#include "picture_strips.hpp"
#include "zstrip_hal/output_pin.hpp"
#include "zstrip_hal/present.hpp"

namespace zstrip::panels {
namespace {

/// Some rectangles that the display may write: all of it, its corners, and others.
std::vector<Area> areas_of(std::uint16_t width, std::uint16_t height, const Step& step, std::mt19937& random) {
  const auto between = [&random](unsigned low, unsigned high) {
    return low + static_cast<unsigned>(random() % (high - low + 1));
  };
  const auto range = [&](unsigned size, unsigned unit) {
    const unsigned units = size / unit, first = between(0, units - 1), count = between(1, units - first);
    return std::pair(static_cast<std::uint16_t>(first * unit), static_cast<std::uint16_t>(count * unit));
  };
  const auto x = static_cast<std::uint16_t>(step.x), y = static_cast<std::uint16_t>(step.y);
  std::vector<Area> areas{{0, 0, width, height},
                          {0, 0, x, y},
                          {static_cast<std::uint16_t>(width - x), static_cast<std::uint16_t>(height - y), x, y}};
  for (int i = 0; i < 4; ++i) {
    const auto [left, columns] = range(width, step.x);
    const auto [top, rows] = range(height, step.y);
    areas.push_back({left, top, columns, rows});
  }
  return areas;
}

template <class C>
class PanelDriver : public testing::Test {};
using Controllers = testing::Types<St7789, Ili9341, St7735, St7735Gm11, St7735Rows132, Gc9a01, St7796, Ili9342, Ili9488,
                                   Co5300, Sh8601, St77916, Ssd1351, Ssd1306, Ssd0323>;
struct Names {
  template <class C>
  static std::string GetName(int /*index*/) {
    return C::name();
  }
};
TYPED_TEST_SUITE(PanelDriver, Controllers, Names);

TYPED_TEST(PanelDriver, EveryConfigurationShowsEveryWindow) {
  std::mt19937 random(1);
  const auto configs = TypeParam::configs();
  for (std::size_t index = 0; index < configs.size(); ++index) {
    SCOPED_TRACE(testing::Message() << "configuration " << index);
    Bench<TypeParam> bench(configs[index]);
    EXPECT_FALSE(bench.panel->darkness().empty()) << "lit before the start";
    ASSERT_EQ(bench.display.start(), Error::none);
    ASSERT_EQ(bench.fault(), "") << "after the start: black";
    const std::uint16_t width = bench.display.width(), height = bench.display.height();
    const Picture picture = noise(width, height, bench.display.format(), random);
    const Picture other = noise(width, height, bench.display.format(), random);
    bool first = true;
    for (const Area& area : areas_of(width, height, TypeParam::step(bench.config), random)) {
      ASSERT_EQ(bench.write(area, first ? picture : other), Error::none);
      ASSERT_EQ(bench.fault(), "") << area.left << ',' << area.top << ' ' << area.width << 'x' << area.height;
      first = false;
    }
  }
}

TYPED_TEST(PanelDriver, RefusesAreasThatDoNotFitAndSendsNothing) {
  for (const auto& config : {TypeParam::configs().front(), TypeParam::configs().back()}) {
    Bench<TypeParam> bench(config);
    ASSERT_EQ(bench.display.start(), Error::none);
    const std::uint64_t before = bench.bus.bytes();
    const std::uint16_t width = bench.display.width(), height = bench.display.height();
    std::vector<std::byte> pixels(bytes_per_row(width, bench.display.format()) * height);
    const auto plus = [](std::uint16_t value, int more) { return static_cast<std::uint16_t>(value + more); };
    for (const Area& area :
         {Area{0, 0, plus(width, 8), 8}, Area{0, 0, 8, plus(height, 8)}, Area{width, 0, 8, 8}, Area{0, height, 8, 8},
          Area{8, 0, width, 8}, Area{0, 0, 0, 8}, Area{0, 0, 8, 0}, Area{65528, 0, 8, 8}, Area{0, 65528, 8, 65528}}) {
      EXPECT_EQ(bench.display.write(area, pixels), Error::area);
    }
    const Step step = TypeParam::step(config);
    if (step.x > 1) {
      EXPECT_EQ(bench.display.write({1, 0, plus(8, 0), 8}, pixels), Error::alignment);
      EXPECT_EQ(bench.display.write({0, 0, 7, 8}, pixels), Error::alignment);
    }
    if (step.y > 1) {
      EXPECT_EQ(bench.display.write({0, 1, 8, 8}, pixels), Error::alignment);
      EXPECT_EQ(bench.display.write({0, 0, 8, 7}, pixels), Error::alignment);
    }
    pixels.pop_back();
    EXPECT_EQ(bench.display.write(bench.whole(), pixels), Error::pixels_too_small);
    EXPECT_EQ(bench.bus.bytes(), before);
    EXPECT_EQ(bench.fault(), "");
  }
}

TYPED_TEST(PanelDriver, SleepsAndShowsItsPictureAgain) {
  std::mt19937 random(2);
  Bench<TypeParam> bench(TypeParam::configs().front());
  ASSERT_EQ(bench.display.start(), Error::none);
  const Picture picture = noise(bench.display.width(), bench.display.height(), bench.display.format(), random);
  ASSERT_EQ(bench.write(bench.whole(), picture), Error::none);
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(bench.display.sleep(), Error::none);
    EXPECT_FALSE(bench.panel->darkness().empty());
    ASSERT_EQ(bench.display.wake(), Error::none);
    EXPECT_EQ(bench.fault(), "");
  }
}

TYPED_TEST(PanelDriver, TakesALevelOfBrightness) {
  Bench<TypeParam> bench(TypeParam::configs().front());
  ASSERT_EQ(bench.display.start(), Error::none);
  if constexpr (requires { bench.display.set_brightness(1); }) {
    for (const int level : {255, 128, 16}) {
      EXPECT_EQ(bench.display.set_brightness(static_cast<std::uint8_t>(level)), Error::none);
      EXPECT_EQ(bench.fault(), "");
      ASSERT_TRUE(bench.panel->brightness());
      EXPECT_NEAR(*bench.panel->brightness(), level, 15) << "coarser than sixteen steps";
    }
    EXPECT_EQ(bench.display.set_brightness(0), Error::none);
    EXPECT_EQ(bench.panel->brightness(), 0U);
  } else {
    EXPECT_FALSE(bench.panel->brightness()) << "the controller could";
  }
}

template <class C>
Error present_picture(Bench<C>& bench, const Picture& picture, bool two_buffers) {
  constexpr std::uint16_t kRows = 8;
  PictureStrips renderer{picture, bench.display.format(), kRows};
  const std::uint32_t bytes = kRows * bytes_per_row(bench.display.width(), bench.display.format());
  std::vector<std::byte> first(bytes), second(two_buffers ? bytes : 0);
  const auto count = static_cast<std::uint16_t>((bench.display.height() + kRows - 1) / kRows);
  const auto result = hal::present(renderer, bench.display, {count, kRows}, {first, second});
  if (result) bench.expected = picture;
  return result.display;
}

TYPED_TEST(PanelDriver, StripsInTurnFromOneBufferAndFromTwo) {
  std::mt19937 random(3);
  const auto configs = TypeParam::configs();
  for (std::size_t index = 0; index < configs.size();
       index += std::max<std::size_t>(1, configs.size() / 8)) {  // each orientation
    Bench<TypeParam> bench(configs[index]);
    ASSERT_EQ(bench.display.start(), Error::none);
    for (const bool two : {false, true}) {
      const Picture picture = noise(bench.display.width(), bench.display.height(), bench.display.format(), random);
      ASSERT_EQ(present_picture(bench, picture, two), Error::none);
      EXPECT_EQ(bench.fault(), "") << "configuration " << index;
    }
  }
}

TYPED_TEST(PanelDriver, AFrameThatBreaksOffAtAnyStepIsReportedAndTheNextIsRight) {
  std::mt19937 random(4);
  const auto config = TypeParam::configs().front();
  int transfers = 0;
  {
    Bench<TypeParam> bench(config);
    ASSERT_EQ(bench.display.start(), Error::none);
    const int before = bench.bus.transfers();
    ASSERT_EQ(present_picture(bench, bench.expected, true), Error::none);
    transfers = bench.bus.transfers() - before;
  }
  ASSERT_GT(transfers, 4);
  Bench<TypeParam> bench(config);
  ASSERT_EQ(bench.display.start(), Error::none);
  const Picture pictures[] = {noise(bench.display.width(), bench.display.height(), bench.display.format(), random),
                              noise(bench.display.width(), bench.display.height(), bench.display.format(), random)};
  for (int at = 0; at < transfers; ++at) {
    for (const unsigned arriving : {0U, 1U, 2U, 3U, 4U}) {
      SCOPED_TRACE(testing::Message() << "transfer " << at << ", " << arriving << " quarters arrive");
      const Picture& picture = pictures[arriving % 2];
      bench.bus.fail_at(bench.bus.transfers() + at, arriving);
      ASSERT_EQ(present_picture(bench, picture, at % 2 == 0), Error::bus);
      ASSERT_EQ(present_picture(bench, picture, at % 2 == 0), Error::none);
      ASSERT_EQ(bench.fault(), "");
    }
  }
}

TYPED_TEST(PanelDriver, AStartThatBreaksOffAtAnyStepIsReportedAndCanBeRepeated) {
  const auto config = TypeParam::configs().front();
  int transfers = 0;
  {
    Bench<TypeParam> bench(config);
    ASSERT_EQ(bench.display.start(), Error::none);
    transfers = bench.bus.transfers();
  }
  for (int at = 0; at < transfers; ++at) {
    Bench<TypeParam> bench(config);
    bench.bus.fail_at(at, 2);
    ASSERT_EQ(bench.display.start(), Error::bus) << "transfer " << at;
    ResetLine reset{bench.panel.get()};
    ASSERT_EQ(hal::reset_panel(reset, bench.bus), Error::none);
    ASSERT_EQ(bench.display.start(), Error::none) << "transfer " << at;
    ASSERT_EQ(bench.fault(), "") << "transfer " << at;
  }
}

}  // namespace
}  // namespace zstrip::panels
