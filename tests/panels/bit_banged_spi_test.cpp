// The bit-banged SPI bus, decoded from the trace of its lines as a panel would: bits at the clock's rising edges while
// selected. And every pin that fails, at every step.
#include "zstrip_hal/bit_banged_spi.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "transfer.hpp"

namespace zstrip::hal {
namespace {

using panels::kArrived;
using panels::kCommand;
using panels::kPixels;

enum Line : std::size_t { kClock, kData, kDataCommand, kSelect, kLines };

/// Four lines and the panel at their other end.
struct Wires {
  std::array<bool, kLines> level{true, true, true, true};  // anything: the bus has to set what it needs
  std::vector<std::pair<bool, int>> bytes;                 // D/C, byte
  int steps = 0, fails_at = -1;
  int bits = 0, byte = 0;
  std::string complaint;

  Error set(Line line, bool high) {
    if (steps++ == fails_at) return Error::pin;
    const bool was = std::exchange(level[line], high);
    const bool selected = !level[kSelect];
    if (line == kSelect && high) bits = 0;
    if (line == kClock && high && !was && selected) {
      byte = byte * 2 % 256 + (level[kData] ? 1 : 0);
      if (++bits % 8 == 0) bytes.emplace_back(level[kDataCommand], byte);
    }
    if (line == kData && high != was && level[kClock] && selected) complaint = "data changes while the clock is high";
    if (line == kDataCommand && high != was && selected) complaint = "D/C changes amid a transfer";
    if (line == kSelect && !high && level[kClock] && started) complaint = "selected while the clock is high";
    return Error::none;
  }
  bool started = false;
};

struct Pin {
  Wires* wires;
  Line line;
  Error set(bool high) { return wires->set(line, high); }
};
static_assert(OutputPin<Pin>);

auto bus_on(Wires& wires) {
  BitBangedSpi bus(Pin{&wires, kClock}, Pin{&wires, kData}, Pin{&wires, kDataCommand}, Pin{&wires, kSelect});
  static_assert(CommandDataBus<decltype(bus)>);
  return bus;
}

TEST(PanelBitBangedSpi, EveryBitArrivesAtARisingEdge) {
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
  EXPECT_FALSE(wires.level[kClock]);
}

TEST(PanelBitBangedSpi, ThreeLinesAreEnough) {
  Wires wires;
  wires.level[kSelect] = false;  // wired to ground
  BitBangedSpi bus(Pin{&wires, kClock}, Pin{&wires, kData}, Pin{&wires, kDataCommand});
  ASSERT_EQ(bus.start(), Error::none);
  wires.bits = 0;
  EXPECT_EQ(bus.write_command(kCommand), Error::none);
  EXPECT_EQ(bus.write_data(kPixels), Error::none);
  EXPECT_EQ(wires.bytes, kArrived);
}

TEST(PanelBitBangedSpi, APinThatFailsAtAnyStepIsReportedAndTheNextTransferIsWhole) {
  Wires counting;
  auto counted = bus_on(counting);
  ASSERT_EQ(counted.write_data(kPixels), Error::none);
  ASSERT_GT(counting.steps, 5 * 8 * 3);
  for (int at = 0; at < counting.steps; ++at) {
    Wires wires;
    wires.fails_at = at;
    auto bus = bus_on(wires);
    EXPECT_EQ(bus.write_data(kPixels), Error::pin) << "step " << at;
    wires.bytes.clear();
    EXPECT_EQ(bus.write_command(kCommand), Error::none) << "step " << at;
    EXPECT_EQ(bus.write_data(kPixels), Error::none) << "step " << at;
    EXPECT_EQ(wires.bytes, kArrived) << "step " << at;
  }
}

}  // namespace
}  // namespace zstrip::hal
