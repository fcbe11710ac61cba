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

/// What the panel answers to any command: from the first falling edge after it on, a bit at each.
const std::vector<bool> kAnswer{false, true, false, true,  false, false, true,  false, true,
                                true,  true, true,  false, false, false, false, true};

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
    if (line == kClock && !high && was && selected && bits >= 8) {
      const auto next = static_cast<std::size_t>(bits - 8);
      answer = next < kAnswer.size() && kAnswer[next];
    }
    if (line == kClock && high && !was && selected) {
      byte = byte * 2 % 256 + (level[kData] ? 1 : 0);
      if (++bits % 8 == 0) bytes.emplace_back(level[kDataCommand], byte);
    }
    if (line == kData && high != was && level[kClock] && selected) complaint = "data changes while the clock is high";
    if (line == kDataCommand && high != was && selected && !(is_asked && bits == 8))
      complaint = "D/C changes amid a transfer";
    if (line == kSelect && !high && level[kClock] && started) complaint = "selected while the clock is high";
    return Error::none;
  }
  Error read(bool& high) {
    if (steps++ == fails_at) return Error::pin;
    if (level[kClock]) complaint = "an answer is read while the clock is high";
    high = answer;
    return Error::none;
  }
  bool started = false;
  bool is_asked = false;  ///< the transfer is a command and an answer
  bool answer = false;    ///< the level that the panel gives
};

struct Pin {
  Wires* wires;
  Line line;
  Error set(bool high) { return wires->set(line, high); }
};
static_assert(OutputPin<Pin>);

struct AnswerPin {
  Wires* wires;
  Error read(bool& high) { return wires->read(high); }
};
static_assert(InputPin<AnswerPin>);

auto bus_on(Wires& wires) {
  BitBangedSpi bus(Pin{&wires, kClock}, Pin{&wires, kData}, Pin{&wires, kDataCommand}, Pin{&wires, kSelect});
  static_assert(CommandDataBus<decltype(bus)> && !ReadableBus<decltype(bus)>);
  return bus;
}

auto readable_bus_on(Wires& wires) {
  BitBangedSpi bus(Pin{&wires, kClock}, Pin{&wires, kData}, Pin{&wires, kDataCommand}, Pin{&wires, kSelect},
                   AnswerPin{&wires});
  static_assert(ReadableBus<decltype(bus)>);
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

TEST(PanelBitBangedSpi, AnswersComeAfterTheCommandAndItsDummyClocks) {
  Wires wires;
  auto bus = readable_bus_on(wires);
  ASSERT_EQ(bus.start(), Error::none);
  wires.started = true;
  wires.is_asked = true;
  std::array<std::byte, 2> answer{};
  EXPECT_EQ(bus.read(std::byte{0x04}, 1, answer), Error::none);
  EXPECT_EQ(wires.bytes.at(0), std::pair(false, 0x04));
  EXPECT_EQ(answer, (std::array{std::byte{0xA5}, std::byte{0xE1}}));
  EXPECT_EQ(bus.read(std::byte{0xDA}, 0, answer), Error::none);
  EXPECT_EQ(answer, (std::array{std::byte{0x52}, std::byte{0xF0}}));
  EXPECT_TRUE(wires.level[kSelect]);
  EXPECT_FALSE(wires.level[kClock]);
  wires.is_asked = false;
  wires.bytes.clear();
  EXPECT_EQ(bus.write_command(kCommand), Error::none);
  EXPECT_EQ(bus.write_data(kPixels), Error::none);
  EXPECT_EQ(wires.bytes, kArrived);
  EXPECT_EQ(wires.complaint, "");
}

TEST(PanelBitBangedSpi, APinThatFailsAtAnyStepOfAnAnswerIsReportedAndTheNextOneIsWhole) {
  std::array<std::byte, 2> answer{};
  Wires counting;
  ASSERT_EQ(readable_bus_on(counting).read(std::byte{0x04}, 1, answer), Error::none);
  ASSERT_GT(counting.steps, 8 * 3 + 17 * 3);
  for (int at = 0; at < counting.steps; ++at) {
    Wires wires;
    wires.fails_at = at;
    auto bus = readable_bus_on(wires);
    EXPECT_EQ(bus.read(std::byte{0x04}, 1, answer), Error::pin) << "step " << at;
    if (at + 1 == counting.steps) {  // the line that selects was the one that failed
      ASSERT_EQ(bus.start(), Error::none);
    }
    EXPECT_EQ(bus.read(std::byte{0x04}, 1, answer), Error::none) << "step " << at;
    EXPECT_EQ(answer, (std::array{std::byte{0xA5}, std::byte{0xE1}})) << "step " << at;
    wires.bytes.clear();
    EXPECT_EQ(bus.write_command(kCommand), Error::none) << "step " << at;
    EXPECT_EQ(bus.write_data(kPixels), Error::none) << "step " << at;
    EXPECT_EQ(wires.bytes, kArrived) << "step " << at;
  }
}

}  // namespace
}  // namespace zstrip::hal
