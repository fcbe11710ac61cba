// Drivers of panels with MIPI's command set against the model: every orientation, format and offset, windows, sleep,
// and faults of the bus at every step.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <random>
#include <vector>

#include "panel/dcs_model.hpp"
#include "panel/model_bus.hpp"
#include "picture.hpp"
#include "zstrip_hal/st7789.hpp"

namespace zstrip::panels {
namespace {

using hal::Area;
using hal::DcsConfig;
using hal::Error;
using hal::Orientation;
using hal::PixelFormat;
using hal::Rotation;
using namespace std::chrono_literals;

constexpr sim::BusTiming kSlowEnough{.byte = 8 * 100ns, .transfer = 0ns, .cycle = 100ns};

/// The driver of a controller, and what it needs to be tried.
template <class Display, const sim::DcsPart& part, PixelFormat... formats>
struct Controller {
  using Driver = Display;
  static constexpr const sim::DcsPart& kPart = part;
  static constexpr PixelFormat kFormats[] = {formats...};
};

using St7789 = Controller<hal::St7789<sim::ModelBus, sim::ModelBus>, sim::kSt7789Part, PixelFormat::rgb565_swapped,
                          PixelFormat::rgb666, PixelFormat::rgb444>;

constexpr Orientation kOrientations[] = {{Rotation::none, false},   {Rotation::by_90, false}, {Rotation::by_180, false},
                                         {Rotation::by_270, false}, {Rotation::none, true},   {Rotation::by_90, true},
                                         {Rotation::by_180, true},  {Rotation::by_270, true}};

/// The glass that a configuration describes.
sim::Glass glass_of(const DcsConfig& config) {
  return {.width = config.width,
          .height = config.height,
          .column_offset = config.column_offset,
          .row_offset = config.row_offset,
          .columns_reversed = config.columns_reversed,
          .rows_reversed = config.rows_reversed,
          .bgr = config.bgr,
          .inverted = config.inverted};
}

/// A started panel, bus, driver, and the picture that it should show.
template <class C>
struct Bench {
  DcsConfig config;
  sim::DcsModel panel;
  sim::ModelBus bus;
  typename C::Driver display;
  Picture expected;

  explicit Bench(const DcsConfig& wanted)
      : config(wanted),
        panel(C::kPart, glass_of(wanted)),
        bus(panel, kSlowEnough),
        display(bus, bus, config),
        expected(black(display.width(), display.height())) {}

  Error start() {
    bus.wait(120'000);  // since power-on
    return display.start();
  }
  Error write(const Area& area, const Picture& picture) {
    std::vector<std::byte> bytes = bytes_of(picture, area, config.format);
    bytes.push_back(std::byte{0xFF});  // more than the area needs: not to be sent
    if (const Error error = display.write(area, bytes); error != Error::none) return error;
    const Error error = display.wait();
    if (error == Error::none) copy(picture, area, expected);
    return error;
  }
  std::string fault() const {
    if (!panel.complaints().empty()) return panel.complaints().front();
    if (!panel.darkness().empty()) return panel.darkness();
    return difference(picture_of(panel.seen()), on_glass(expected, config.orientation));
  }
};

template <class C>
class PanelDcs : public testing::Test {};
using Controllers = testing::Types<St7789>;
struct Names {
  template <class C>
  static std::string GetName(int /*index*/) {
    return C::kPart.name;
  }
};
TYPED_TEST_SUITE(PanelDcs, Controllers, Names);

TYPED_TEST(PanelDcs, EveryOrientationFormatAndWiring) {
  std::mt19937 random(1);
  for (const Orientation& orientation : kOrientations) {
    for (const PixelFormat format : TypeParam::kFormats) {
      for (unsigned wiring = 0; wiring < 16; ++wiring) {
        SCOPED_TRACE(testing::Message() << "rotation " << static_cast<int>(orientation.rotation) << " mirrored "
                                        << orientation.mirrored << " format " << static_cast<int>(format) << " wiring "
                                        << wiring);
        Bench<TypeParam> bench({.width = 34,
                                .height = 22,
                                .column_offset = 7,
                                .row_offset = 11,
                                .orientation = orientation,
                                .format = format,
                                .columns_reversed = (wiring & 1) != 0,
                                .rows_reversed = (wiring & 2) != 0,
                                .bgr = (wiring & 4) != 0,
                                .inverted = (wiring & 8) != 0});
        ASSERT_EQ(bench.start(), Error::none);
        ASSERT_EQ(bench.fault(), "") << "after the start";
        const std::uint16_t width = bench.display.width(), height = bench.display.height();
        const Picture picture = noise(width, height, format, random);
        for (const Area& area :
             {Area{0, 0, width, height}, Area{0, 0, 2, 1}, Area{2, 1, 12, 9},
              Area{static_cast<std::uint16_t>(width - 2), static_cast<std::uint16_t>(height - 1), 2, 1}}) {
          ASSERT_EQ(bench.write(area, noise(width, height, format, random)), Error::none);
          ASSERT_EQ(bench.fault(), "");
        }
        ASSERT_EQ(bench.write({0, 0, width, height}, picture), Error::none);
        ASSERT_EQ(bench.fault(), "");
      }
    }
  }
}

TYPED_TEST(PanelDcs, TheWholeMemoryAsGlass) {
  std::mt19937 random(2);
  for (const Orientation& orientation : kOrientations) {
    Bench<TypeParam> bench(
        {.width = TypeParam::kPart.columns, .height = TypeParam::kPart.rows, .orientation = orientation});
    ASSERT_EQ(bench.start(), Error::none);
    const Area all{0, 0, bench.display.width(), bench.display.height()};
    ASSERT_EQ(bench.write(all, noise(all.width, all.height, bench.config.format, random)), Error::none);
    ASSERT_EQ(bench.fault(), "");
  }
}

TYPED_TEST(PanelDcs, RefusesWhatCannotBe) {
  const std::uint16_t columns = TypeParam::kPart.columns, rows = TypeParam::kPart.rows;
  constexpr std::byte kCutOff[] = {std::byte{0xB1}, std::byte{3}, std::byte{1}, std::byte{2}};
  constexpr std::byte kNoCount[] = {std::byte{0xB1}};
  DcsConfig configs[] = {{.width = 0, .height = 10},
                         {.width = 10, .height = 0},
                         {.width = static_cast<std::uint16_t>(columns + 1), .height = 10},
                         {.width = columns, .height = 10, .column_offset = 1},
                         {.width = 10, .height = static_cast<std::uint16_t>(rows + 1)},
                         {.width = 10, .height = rows, .row_offset = 1},
                         {.width = 10, .height = 10, .column_offset = 65535},
                         {.width = 10, .height = 10, .format = PixelFormat::rgb565},
                         {.width = 10, .height = 10, .format = PixelFormat::mono},
                         {.width = 11, .height = 10, .format = PixelFormat::rgb444},
                         {.width = 10, .height = 10, .module_commands = kCutOff},
                         {.width = 10, .height = 10, .module_commands = kNoCount}};
  for (const DcsConfig& config : configs) {
    sim::DcsModel panel(TypeParam::kPart, {.width = 1, .height = 1});
    sim::ModelBus bus(panel, kSlowEnough);
    typename TypeParam::Driver display(bus, bus, config);
    EXPECT_EQ(display.start(), Error::configuration) << &config - configs;
    EXPECT_EQ(bus.bytes(), 0U) << &config - configs;
  }
}

TYPED_TEST(PanelDcs, RefusesAreasThatDoNotFit) {
  Bench<TypeParam> bench({.width = 20, .height = 10});
  ASSERT_EQ(bench.start(), Error::none);
  const std::uint64_t before = bench.bus.bytes();
  std::vector<std::byte> pixels(2 * 20 * 10);
  for (const Area& area : {Area{0, 0, 21, 1}, Area{0, 0, 1, 11}, Area{20, 0, 1, 1}, Area{0, 10, 1, 1}, Area{0, 0, 0, 1},
                           Area{0, 0, 1, 0}, Area{65535, 0, 1, 1}, Area{0, 65535, 1, 65535}}) {
    EXPECT_EQ(bench.display.write(area, pixels), Error::area);
  }
  pixels.pop_back();
  EXPECT_EQ(bench.display.write({0, 0, 20, 10}, pixels), Error::pixels_too_small);
  EXPECT_EQ(bench.bus.bytes(), before);
}

}  // namespace
}  // namespace zstrip::panels
