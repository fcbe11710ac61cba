// GPIO lines by libgpiod 1 where a kernel misbehaves as no emulated one does: what the HAL makes of it.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/gpio.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "mocked_devices.hpp"
#include "zstrip_hal_linux/gpio.hpp"

namespace zstrip::linux_mock {
namespace {

using hal::Error;
using hal::GpioPin;

/// A chip of four lines as libgpiod 1.6 speaks to it. Line 1 is CLOCK, line 2 belongs to a driver.
struct MockedChip {
  int refused_request = 0;  ///< errno for a request
  int refused_level = 0;    ///< errno for a level
  unsigned requested = 0;
  std::vector<int> levels;

  int control(unsigned long request, void* argument) {
    if (request == GPIO_GET_CHIPINFO_IOCTL) {
      gpiochip_info info{};
      std::strcpy(info.name, "gpiochip0");
      info.lines = 4;
      std::memcpy(argument, &info, sizeof info);
      return 0;
    }
    if (request == GPIO_GET_LINEINFO_IOCTL) {
      auto& info = *static_cast<gpioline_info*>(argument);
      if (info.line_offset == 1) std::strcpy(info.name, "CLOCK");
      if (info.line_offset == 2) std::strcpy(info.consumer, "heartbeat");
      info.flags = info.line_offset == 2 ? GPIOLINE_FLAG_KERNEL : 0;
      return 0;
    }
    if (request == GPIO_GET_LINEHANDLE_IOCTL) {
      auto& asked = *static_cast<gpiohandle_request*>(argument);
      if (refused_request != 0) return refused_request;
      if (asked.lineoffsets[0] == 2) return EBUSY;
      requested = asked.lineoffsets[0];
      levels.push_back(asked.default_values[0]);
      asked.fd = open("/dev/gpiohandle", O_RDWR | O_CLOEXEC);
      return asked.fd >= 0 ? 0 : errno;
    }
    return ENOTTY;
  }
  int handle_control(unsigned long request, void* argument) {
    if (request != GPIOHANDLE_SET_LINE_VALUES_IOCTL) return ENOTTY;
    if (refused_level != 0) return refused_level;
    levels.push_back(static_cast<gpiohandle_data*>(argument)->values[0]);
    return 0;
  }
};

class LinuxMockedGpio : public testing::Test {
 protected:
  LinuxMockedGpio() {
    devices_.add("gpio", "gpiochip0", 254, 0,
                 [this](auto request, void* argument) { return chip_.control(request, argument); });
    devices_.add("gpio", "gpiohandle", 254, 1,
                 [this](auto request, void* argument) { return chip_.handle_control(request, argument); });
  }

  MockedChip chip_;
  MockedDevices devices_;
};

TEST_F(LinuxMockedGpio, OneCallForEveryChangeOfALevel) {
  const auto line = hal::find_gpio_line("CLOCK");
  ASSERT_TRUE(line) << line.fault().message;
  EXPECT_EQ(*line, (hal::GpioLine{"/dev/gpiochip0", 1}));
  auto pin = GpioPin::request(*line, true);
  ASSERT_TRUE(pin) << pin.fault().message;
  EXPECT_EQ(chip_.requested, 1U);
  std::vector<int> expected{1};
  for (int i = 0; i < 1000; ++i) {
    const bool level = i * i % 7 < 3;
    if (level != (expected.back() == 1)) expected.push_back(level ? 1 : 0);
    ASSERT_EQ(pin->set(level), Error::none);
  }
  EXPECT_EQ(chip_.levels, expected);

  chip_.refused_level = EIO;
  const bool other = expected.back() == 0;
  EXPECT_EQ(pin->set(other), Error::pin);
  EXPECT_EQ(pin->set(other), Error::pin) << "a level that was refused is not taken for set";
  chip_.refused_level = 0;
  EXPECT_EQ(pin->set(other), Error::none);
}

TEST_F(LinuxMockedGpio, RefusalsNameTheLineAndTheRemedy) {
  const auto words_of = [](const char* text) {
    const auto line = hal::find_gpio_line(text);
    if (!line) return line.fault().message;
    const auto pin = GpioPin::request(*line, false);
    return pin ? std::string("requested") : pin.fault().message;
  };
  EXPECT_EQ(words_of("gpiochip0:3"), "requested");
  EXPECT_EQ(words_of("0:2").substr(0, 50), "/dev/gpiochip0 line 2 is busy: 'heartbeat' has it;");
  EXPECT_EQ(words_of("0:4"), "/dev/gpiochip0 has no line 4, only 4 lines from 0 on");
  chip_.refused_request = EPERM;
  EXPECT_EQ(words_of("0:3"),
            "/dev/gpiochip0 cannot make line 3 an output: no permission; join the group 'gpio' (usermod -aG gpio USER, "
            "then log in again) or run as root");
  chip_.refused_request = EIO;
  EXPECT_EQ(words_of("0:3"), "/dev/gpiochip0 cannot make line 3 an output: Input/output error");
}

}  // namespace
}  // namespace zstrip::linux_mock
