// A panel on I2C by i2c-dev, up to the glass of a model; and what the HAL makes of a bus on which things go wrong.
#include <gtest/gtest.h>
#include <linux/i2c-dev.h>
#include <linux/i2c.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "mocked_devices.hpp"
#include "panel/ssd1306_model.hpp"
#include "picture.hpp"
#include "zstrip_hal/ssd1306.hpp"
#include "zstrip_hal_linux/i2cdev.hpp"

namespace zstrip::linux_mock {
namespace {

using hal::DisplayFormat;
using hal::Error;
using hal::I2cdevBus;

constexpr unsigned kAddress = 0x3D;

/// A controller of I2C with one device at it, and what arrived there.
struct MockedI2c {
  unsigned long functions = I2C_FUNC_I2C | I2C_FUNC_SMBUS_EMUL;
  bool is_taken = false;  ///< a driver of the kernel has the address
  int error = EREMOTEIO;
  int transfers_until_failure = -1;
  std::chrono::milliseconds timeout = std::chrono::minutes(1);  ///< until it is set: longer than a test may take
  int timeout_error = 0;
  bool hangs = false;  ///< a device holds SCL low
  std::vector<std::vector<std::uint8_t>> transfers;

  int control(unsigned long request, void* argument) {
    if (request == I2C_FUNCS) {
      *static_cast<unsigned long*>(argument) = functions;
      return 0;
    }
    if (request == I2C_SLAVE) return is_taken ? EBUSY : 0;
    if (request == I2C_TIMEOUT) {
      timeout = std::chrono::milliseconds(10) * reinterpret_cast<std::uintptr_t>(argument);
      return timeout_error;
    }
    if (request != I2C_RDWR) return ENOTTY;
    const auto& data = *static_cast<i2c_rdwr_ioctl_data*>(argument);
    if (data.nmsgs != 1 || data.msgs[0].flags != 0 || data.msgs[0].len > 8192) return EINVAL;
    if (data.msgs[0].addr != kAddress) return ENXIO;
    if (hangs) {
      std::this_thread::sleep_for(timeout);
      return ETIMEDOUT;
    }
    if (transfers_until_failure-- == 0) return error;
    transfers.emplace_back(data.msgs[0].buf, data.msgs[0].buf + data.msgs[0].len);
    return 0;
  }
  /// What the panel makes of all that has arrived.
  void show(sim::Ssd1306Model& panel) const {
    for (const std::vector<std::uint8_t>& transfer : transfers) {
      ASSERT_FALSE(transfer.empty());
      ASSERT_TRUE(transfer[0] == 0x00 || transfer[0] == 0x40);
      panel.receive(transfer[0] == 0x40 ? sim::Wire::data : sim::Wire::command,
                    std::as_bytes(std::span(transfer).subspan(1)));
    }
  }
};

class LinuxMockedI2c : public testing::Test {
 protected:
  LinuxMockedI2c() {
    devices_.add("i2c-dev", "i2c-1", 89, 1,
                 [this](auto request, void* argument) { return i2c_.control(request, argument); });
  }
  static hal::Outcome<I2cdevBus> open(std::uint8_t address = kAddress) {
    return I2cdevBus::open("/dev/i2c-1", address);
  }

  static constexpr hal::Area kWhole{0, 0, 128, 64};
  static Error show(hal::Ssd1306<I2cdevBus>& display, const panels::Picture& picture) {
    if (const Error error = display.begin_frame(); error != Error::none) return error;
    const Error written = display.write(kWhole, panels::bytes_of(picture, kWhole, DisplayFormat::mono));
    const Error sent = display.wait();
    const Error end = display.end_frame();
    return written != Error::none ? written : sent != Error::none ? sent : end;
  }
  void expect_shown(const panels::Picture& picture) {
    sim::Ssd1306Model panel;
    i2c_.show(panel);
    EXPECT_EQ(panel.complaints(), std::vector<std::string>{});
    EXPECT_EQ(panel.darkness(), "");
    EXPECT_EQ(panels::difference(panels::picture_of(panel.seen()), picture), "");
  }

  MockedI2c i2c_;
  MockedDevices devices_;
  std::mt19937 random_{7};
};

TEST_F(LinuxMockedI2c, AnSsd1306ShowsAPicture) {
  auto bus = open();
  ASSERT_TRUE(bus) << bus.fault().message;
  hal::Ssd1306 display(*bus);
  ASSERT_EQ(display.start(), Error::none);
  const panels::Picture picture = panels::noise(128, 64, DisplayFormat::mono, random_);
  EXPECT_EQ(show(display, picture), Error::none);
  expect_shown(picture);
}

// The frame that fails says so, the one after it is right, whichever of its transfers is refused.
TEST_F(LinuxMockedI2c, EveryTransferOfAFrameMayFail) {
  const panels::Picture lost = panels::noise(128, 64, DisplayFormat::mono, random_);
  const panels::Picture picture = panels::noise(128, 64, DisplayFormat::mono, random_);
  std::size_t of_a_frame = 0;
  {
    auto bus = open();
    ASSERT_TRUE(bus);
    hal::Ssd1306 display(*bus);
    ASSERT_EQ(display.start(), Error::none);
    of_a_frame = i2c_.transfers.size();
    ASSERT_EQ(show(display, lost), Error::none);
    of_a_frame = i2c_.transfers.size() - of_a_frame;
  }
  ASSERT_GT(of_a_frame, 30U);
  for (std::size_t failing = 0; failing < of_a_frame; ++failing) {
    i2c_ = {};
    auto bus = open();
    ASSERT_TRUE(bus);
    hal::Ssd1306 display(*bus);
    ASSERT_EQ(display.start(), Error::none);
    i2c_.transfers_until_failure = static_cast<int>(failing);
    ASSERT_EQ(show(display, lost), Error::bus) << "transfer " << failing;
    ASSERT_EQ(show(display, picture), Error::none) << "transfer " << failing;
    expect_shown(picture);
  }
}

TEST_F(LinuxMockedI2c, LongWritesAreSplitAndEachHasItsControlByte) {
  auto bus = open();
  ASSERT_TRUE(bus);
  i2c_.transfers.clear();
  std::vector<std::uint8_t> bytes(10'000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 7 + i / 256);
  EXPECT_EQ(bus->write_data(std::as_bytes(std::span(bytes))), Error::none);
  ASSERT_EQ(i2c_.transfers.size(), 3U);
  std::vector<std::uint8_t> arrived;
  for (const auto& transfer : i2c_.transfers) {
    EXPECT_EQ(transfer[0], 0x40);
    arrived.insert(arrived.end(), transfer.begin() + 1, transfer.end());
  }
  EXPECT_EQ(arrived, bytes);
  const std::array command{std::byte{0xAE}};
  EXPECT_EQ(bus->write_command(command), Error::none);
  EXPECT_EQ(i2c_.transfers.back(), (std::vector<std::uint8_t>{0x00, 0xAE}));
  EXPECT_EQ(bus->write_data({}), Error::none);
  EXPECT_EQ(i2c_.transfers.size(), 4U) << "nothing is sent for nothing";
  i2c_.transfers_until_failure = 0;
  i2c_.error = ETIMEDOUT;
  EXPECT_EQ(bus->write_command(command), Error::timeout);
}

// A user who pulls the wires waits for a second at each frame, not for ever, and the picture comes back.
TEST_F(LinuxMockedI2c, ABusThatHangsTakesATimeOutAndTheNextFrameIsRight) {
  const panels::Picture picture = panels::noise(128, 64, DisplayFormat::mono, random_);
  auto bus = open();
  ASSERT_TRUE(bus);
  hal::Ssd1306 display(*bus);
  ASSERT_EQ(display.start(), Error::none);
  ASSERT_EQ(show(display, picture), Error::none);
  EXPECT_EQ(i2c_.timeout.count(), I2cdevBus::kTimeout);
  i2c_.timeout = std::min(i2c_.timeout, std::chrono::milliseconds(1500));
  i2c_.hangs = true;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(show(display, panels::noise(128, 64, DisplayFormat::mono, random_)), Error::timeout);
  const std::chrono::duration<double, std::milli> waited = std::chrono::steady_clock::now() - start;
  EXPECT_GE(waited.count(), I2cdevBus::kTimeout);
  EXPECT_LT(waited.count(), 2 * I2cdevBus::kTimeout) << "the frame is given up at its first transfer";
  i2c_.hangs = false;
  EXPECT_EQ(show(display, picture), Error::none);
  expect_shown(picture);

  i2c_.hangs = true;
  EXPECT_NE(open().fault().message.find("no device answers at the address 0x3d"), std::string::npos);
  i2c_ = {};
  i2c_.timeout_error = EINVAL;
  EXPECT_EQ(open().fault().message, "/dev/i2c-1 cannot be given a time-out: Invalid argument");
}

TEST_F(LinuxMockedI2c, RefusalsNameTheAddressAndTheRemedy) {
  EXPECT_EQ(open(0x3C).fault().message,
            "/dev/i2c-1: no device answers at the address 0x3c; check wires, supply and address (i2cdetect -y lists "
            "what answers), and that nothing holds SCL or SDA low");
  i2c_.is_taken = true;
  EXPECT_EQ(
      open().fault().message,
      "/dev/i2c-1: the address 0x3d is busy; a driver of the kernel has the panel: take its node out of the device "
      "tree");
  i2c_.is_taken = false;
  i2c_.functions = I2C_FUNC_SMBUS_EMUL;
  EXPECT_EQ(open().fault().message,
            "/dev/i2c-1 is a controller for SMBus, which cannot send pictures; use another bus");
  i2c_ = {};
  for (const int error : {ENXIO, EREMOTEIO, EIO, ETIMEDOUT}) {
    i2c_.transfers_until_failure = 0;
    i2c_.error = error;
    EXPECT_NE(open().fault().message.find("no device answers at the address 0x3d"), std::string::npos) << error;
  }
  i2c_.transfers_until_failure = 0;
  i2c_.error = EAGAIN;
  EXPECT_EQ(open().fault().message, "/dev/i2c-1 cannot talk to the address 0x3d: Resource temporarily unavailable");
  const auto missing = I2cdevBus::open("/dev/i2c-9", kAddress);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.fault().message,
            "/dev/i2c-9 cannot be opened: there is no such device; enable I2C in the device tree and load the module "
            "i2c-dev");
  EXPECT_EQ(I2cdevBus::open("/dev/null", kAddress).fault().message, "/dev/null is not an I2C bus");
}

}  // namespace
}  // namespace zstrip::linux_mock
