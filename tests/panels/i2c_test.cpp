// Panels over I2C, decoded from the levels of two lines as a device would: start and stop conditions, bits at the
// clock's rising edges, acknowledges, control bytes. And devices that refuse, stretch the clock or hold a line.
#include "zstrip_hal/i2c.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

#include "panel/ssd1306_model.hpp"
#include "picture.hpp"
#include "zstrip_hal/bit_banged_i2c.hpp"
#include "zstrip_hal/ssd1306.hpp"

namespace zstrip::hal {
namespace {

enum Line : std::size_t { kClock, kData };

/// Two lines with pull-up resistors, and the device at them.
class Wires {
 public:
  std::vector<std::vector<int>> transfers;  ///< each address and its bytes
  std::uint64_t microseconds = 0;
  int steps = 0, fails_at = -1;  ///< calls of pins
  int refuse_at = -1;            ///< byte of a transfer that is not acknowledged
  int stretch = 0;               ///< readings of the clock line that find it held low after each rise
  bool holds_data = false;       ///< the device does not let go
  std::string complaint;

  Error drive(Line line, bool low) {
    if (steps++ == fails_at) return Error::pin;
    const bool clock_was = level(kClock), data_was = level(kData);
    low_[line] = low;
    const bool clock = level(kClock), data = level(kData);
    if (clock && !clock_was && line == kClock) rising_edge();
    if (!clock && clock_was) falling_edge();
    if (clock && clock_was && data != data_was) data ? stop_condition() : start_condition();
    return Error::none;
  }
  Error read(Line line, bool& high) {
    if (steps++ == fails_at) return Error::pin;
    if (line == kClock && !low_[kClock] && held_ > 0) {
      --held_;
      high = false;
      return Error::none;
    }
    high = level(line);
    return Error::none;
  }
  bool idle() const { return level(kClock) && level(kData) && !in_transfer_; }

 private:
  bool level(Line line) const { return !low_[line] && !(line == kData && (acknowledging_ || holds_data)); }

  void start_condition() {
    in_transfer_ = true;
    bits_ = byte_ = 0;
    transfers.emplace_back();
  }
  void stop_condition() {
    if (in_transfer_ && bits_ > 1) complaint = "a stop condition amid a byte";
    in_transfer_ = false;
    bits_ = byte_ = 0;
  }
  void rising_edge() {
    held_ = stretch;
    if (!in_transfer_) return;
    if (bits_ < 8) byte_ = byte_ * 2 + (level(kData) ? 1 : 0);
    ++bits_;
  }
  void falling_edge() {
    if (bits_ == 8) {
      transfers.back().push_back(byte_);
      acknowledging_ = static_cast<int>(transfers.back().size()) - 1 != refuse_at;
    } else if (bits_ == 9) {
      acknowledging_ = false;
      bits_ = byte_ = 0;
    }
  }

  bool low_[2] = {false, false};
  bool acknowledging_ = false, in_transfer_ = false;
  int bits_ = 0, byte_ = 0, held_ = 0;
};

struct Pin {
  Wires* wires;
  Line line;
  Error pull_low() { return wires->drive(line, true); }
  Error release() { return wires->drive(line, false); }
  Error read(bool& high) { return wires->read(line, high); }
};
static_assert(OpenDrainPin<Pin>);

struct Microseconds {
  Wires* wires;
  void wait(std::uint32_t microseconds) { wires->microseconds += microseconds; }
};

using Writer = BitBangedI2c<Pin, Pin, Microseconds>;
static_assert(I2cWriter<Writer>);
static_assert(CommandDataBus<I2cCommandDataBus<Writer>>);

/// Wires with all that stands on them.
struct Bench {
  Wires wires;
  Microseconds clock{&wires};
  Writer writer{Pin{&wires, kClock}, Pin{&wires, kData}, clock};
  I2cCommandDataBus<Writer> bus{writer, 0x3C};
};

constexpr std::array kTwoBytes{std::byte{0xA5}, std::byte{0x01}};
using Transfers = std::vector<std::vector<int>>;

TEST(PanelI2c, BytesAreToldApartByAControlByte) {
  Bench bench;
  ASSERT_EQ(bench.writer.start(), Error::none);
  bench.wires.transfers.clear();
  EXPECT_EQ(bench.bus.write_command(kTwoBytes), Error::none);
  EXPECT_EQ(bench.bus.write_data(kTwoBytes), Error::none);
  EXPECT_EQ(bench.bus.wait(), Error::none);
  EXPECT_EQ(bench.wires.transfers, (Transfers{{0x78, 0x00, 0xA5, 0x01}, {0x78, 0x40, 0xA5, 0x01}}));
  EXPECT_TRUE(bench.wires.idle());
  EXPECT_EQ(bench.wires.complaint, "");
}

TEST(PanelI2c, NotFasterThan100Kilohertz) {
  Bench bench;
  EXPECT_EQ(bench.bus.write_data(kTwoBytes), Error::none);
  EXPECT_GE(bench.wires.microseconds, 4U * 9 * 10);
}

TEST(PanelI2c, ARefusedByteIsAFaultAndTheNextTransferIsWhole) {
  for (const int refused : {0, 1, 2, 3}) {
    Bench bench;
    bench.wires.refuse_at = refused;
    EXPECT_EQ(bench.bus.write_data(kTwoBytes), Error::bus) << refused;
    EXPECT_EQ(bench.wires.transfers.back().size(), static_cast<std::size_t>(refused) + 1) << "nothing is sent after it";
    EXPECT_TRUE(bench.wires.idle());
    bench.wires.refuse_at = -1;
    EXPECT_EQ(bench.bus.write_data(kTwoBytes), Error::none);
    EXPECT_EQ(bench.wires.transfers.back(), (std::vector<int>{0x78, 0x40, 0xA5, 0x01}));
    EXPECT_EQ(bench.wires.complaint, "");
  }
}

TEST(PanelI2c, ADeviceMayStretchTheClockButNotForEver) {
  Bench slow;
  slow.wires.stretch = 20;
  EXPECT_EQ(slow.bus.write_data(kTwoBytes), Error::none);
  EXPECT_EQ(slow.wires.transfers, (Transfers{{0x78, 0x40, 0xA5, 0x01}}));
  Bench stuck;
  stuck.wires.stretch = 1'000'000;
  EXPECT_EQ(stuck.bus.write_data(kTwoBytes), Error::timeout);
  EXPECT_LT(stuck.wires.microseconds, 10'000U);
}

TEST(PanelI2c, AHeldDataLineIsAFault) {
  Bench bench;
  bench.wires.holds_data = true;
  EXPECT_EQ(bench.writer.start(), Error::bus);
  EXPECT_EQ(bench.bus.write_data(kTwoBytes), Error::bus);
}

TEST(PanelI2c, APinThatFailsAtAnyStepIsReportedAndTheNextTransferIsWhole) {
  Bench counting;
  ASSERT_EQ(counting.bus.write_data(kTwoBytes), Error::none);
  const int steps = counting.wires.steps;
  ASSERT_GT(steps, 4 * 9 * 3);
  for (int at = 0; at < steps; ++at) {
    Bench bench;
    bench.wires.fails_at = at;
    EXPECT_EQ(bench.bus.write_data(kTwoBytes), Error::pin) << "step " << at;
    EXPECT_EQ(bench.writer.start(), Error::none) << "step " << at;
    EXPECT_EQ(bench.bus.write_data(kTwoBytes), Error::none) << "step " << at;
    EXPECT_EQ(bench.wires.transfers.back(), (std::vector<int>{0x78, 0x40, 0xA5, 0x01})) << "step " << at;
    EXPECT_TRUE(bench.wires.idle());
  }
}

/// From the driver over both lines to the glass.
TEST(PanelI2c, AnSsd1306ShowsAPicture) {
  Bench bench;
  Ssd1306 display(bench.bus);
  std::mt19937 random(1);
  const panels::Picture picture = panels::noise(128, 64, DisplayFormat::mono, random);
  ASSERT_EQ(bench.writer.start(), Error::none);
  ASSERT_EQ(display.start(), Error::none);
  ASSERT_EQ(display.write({0, 0, 128, 64}, panels::bytes_of(picture, {0, 0, 128, 64}, DisplayFormat::mono)),
            Error::none);
  ASSERT_EQ(display.wait(), Error::none);

  sim::Ssd1306Model panel;
  for (const std::vector<int>& transfer : bench.wires.transfers) {
    if (transfer.empty()) continue;  // a start condition alone: the lines were freed
    ASSERT_EQ(transfer.at(0), 0x78);
    ASSERT_TRUE(transfer.at(1) == 0x00 || transfer.at(1) == 0x40);
    for (std::size_t i = 2; i < transfer.size(); ++i) {
      const std::byte byte{static_cast<std::uint8_t>(transfer[i])};
      panel.receive(transfer[1] == 0x40 ? sim::Wire::data : sim::Wire::command, {&byte, 1});
    }
  }
  EXPECT_EQ(panel.complaints(), std::vector<std::string>{});
  EXPECT_EQ(panel.darkness(), "");
  EXPECT_EQ(panels::difference(panels::picture_of(panel.seen()), picture), "");
  EXPECT_EQ(bench.wires.complaint, "");
}

}  // namespace
}  // namespace zstrip::hal
