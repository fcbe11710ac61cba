// The parallel bus, decoded from the levels of its lines as a panel would: bytes where the strobe rises while selected.
// And every pin that fails, at every step.
#include "zstrip_hal/parallel_bus.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "panel/dcs_model.hpp"
#include "picture.hpp"
#include "transfer.hpp"
#include "zstrip_hal/st7789.hpp"

namespace zstrip::hal {
namespace {

using panels::kArrived;
using panels::kCommand;
using panels::kPixels;

/// D0 to D7, then these.
enum Line : std::size_t { kStrobe = 8, kDataCommand, kSelect, kLines };

/// The lines, and the panel at their other end.
struct Wires {
  std::array<bool, kLines> level{};         // anything: the bus has to set what it needs
  std::vector<std::pair<bool, int>> bytes;  // D/C, byte
  int steps = 0, fails_at = -1;
  std::string complaint;
  bool started = false;

  Error set(std::size_t line, bool high) {
    if (steps++ == fails_at) return Error::pin;
    const bool was = std::exchange(level[line], high);
    if (high == was || !started) return Error::none;
    // What ends a write: the strobe rises while the panel is selected, or the panel is deselected while it is low.
    if (high && ((line == kStrobe && !level[kSelect]) || (line == kSelect && !level[kStrobe]))) {
      int byte = 0;
      for (int bit = 7; bit >= 0; --bit) byte = byte * 2 + (level[static_cast<std::size_t>(bit)] ? 1 : 0);
      bytes.emplace_back(level[kDataCommand], byte);
    }
    if (line == kSelect && !high && !level[kStrobe]) complaint = "selected while the strobe is low";
    if (line < kStrobe && !level[kSelect] && !level[kStrobe]) complaint = "data changes while the strobe is low";
    if (line == kDataCommand && !level[kSelect]) complaint = "D/C changes while selected";
    return Error::none;
  }
};

struct Pin {
  Wires* wires;
  std::size_t line;
  Error set(bool high) { return wires->set(line, high); }
};
static_assert(OutputPin<Pin>);
static_assert(DataLines<EightPins<Pin>>);

auto bus_on(Wires& wires) {
  EightPins<Pin> data(
      {Pin{&wires, 0}, {&wires, 1}, {&wires, 2}, {&wires, 3}, {&wires, 4}, {&wires, 5}, {&wires, 6}, {&wires, 7}});
  ParallelBus bus(std::move(data), Pin{&wires, kStrobe}, Pin{&wires, kDataCommand}, Pin{&wires, kSelect});
  static_assert(CommandDataBus<decltype(bus)>);
  return bus;
}

TEST(PanelParallelBus, EveryByteArrivesAtARisingEdge) {
  Wires wires;
  auto bus = bus_on(wires);
  ASSERT_EQ(bus.start(), Error::none);
  wires.started = true;
  EXPECT_EQ(bus.write_command(kCommand), Error::none);
  EXPECT_EQ(bus.write_data(kPixels), Error::none);
  EXPECT_EQ(bus.wait(), Error::none);
  EXPECT_EQ(wires.bytes, kArrived);
  EXPECT_EQ(wires.complaint, "");
  EXPECT_TRUE(wires.level[kSelect]);
  EXPECT_TRUE(wires.level[kStrobe]);
}

/// A data line that failed while the strobe was low left a byte half set, which deselecting the panel then made it
/// take.
TEST(PanelParallelBus, APinThatFailsAtAnyStepIsReportedAndNoByteIsHalfSentAndTheNextTransferIsWhole) {
  Wires counting;
  auto counted = bus_on(counting);
  ASSERT_EQ(counted.start(), Error::none);
  const int before = counting.steps;
  ASSERT_EQ(counted.write_data(kPixels), Error::none);
  const int steps = counting.steps - before;
  ASSERT_GE(steps, 5 * 10);
  for (int at = 0; at < steps; ++at) {
    Wires wires;
    auto bus = bus_on(wires);
    ASSERT_EQ(bus.start(), Error::none);
    wires.started = true;
    wires.fails_at = wires.steps + at;
    EXPECT_EQ(bus.write_data(kPixels), Error::pin) << "step " << at;
    ASSERT_LE(wires.bytes.size(), kPixels.size());
    for (std::size_t i = 0; i < wires.bytes.size(); ++i) EXPECT_EQ(wires.bytes[i], kArrived[i + 1]) << "step " << at;
    if (at + 1 == steps) {  // the line that selects was the one that failed
      ASSERT_EQ(bus.start(), Error::none);
    }
    wires.bytes.clear();
    EXPECT_EQ(bus.write_command(kCommand), Error::none) << "step " << at;
    EXPECT_EQ(bus.write_data(kPixels), Error::none) << "step " << at;
    EXPECT_EQ(wires.bytes, kArrived) << "step " << at;
  }
}

/// From the driver over eleven lines to the glass.
TEST(PanelParallelBus, AnSt7789ShowsAPicture) {
  struct NoTime {
    void wait(std::uint32_t) {}
  };
  Wires wires;
  auto bus = bus_on(wires);
  NoTime clock;
  constexpr std::uint16_t kWidth = 24, kHeight = 10;
  St7789 display(bus, clock, {.width = kWidth, .height = kHeight, .inverted = true});
  std::mt19937 random(1);
  const Area whole{0, 0, kWidth, kHeight};
  const panels::Picture picture = panels::noise(kWidth, kHeight, DisplayFormat::rgb565_swapped, random);
  ASSERT_EQ(bus.start(), Error::none);
  wires.started = true;
  ASSERT_EQ(display.start(), Error::none);
  ASSERT_EQ(display.write(whole, panels::bytes_of(picture, whole, DisplayFormat::rgb565_swapped)), Error::none);
  ASSERT_EQ(display.wait(), Error::none);

  sim::DcsModel panel(sim::kSt7789Part, {.width = kWidth, .height = kHeight, .inverted = true});
  panel.elapse(std::chrono::seconds(1));
  for (const auto& [data, value] : wires.bytes) {
    if (!data) panel.elapse(std::chrono::seconds(1));  // longer than any command takes
    const std::byte byte{static_cast<std::uint8_t>(value)};
    panel.receive(data ? sim::Wire::data : sim::Wire::command, {&byte, 1});
  }
  EXPECT_EQ(panel.complaints(), std::vector<std::string>{});
  EXPECT_EQ(panel.darkness(), "");
  EXPECT_EQ(panels::difference(panels::picture_of(panel.seen()), picture), "");
  EXPECT_EQ(wires.complaint, "");
}

}  // namespace
}  // namespace zstrip::hal
