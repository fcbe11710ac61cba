// GPIO lines by libgpiod 1 where a kernel misbehaves as no emulated one does: what the HAL makes of it.
#include <gtest/gtest.h>

#include <cerrno>
#include <string>
#include <vector>

#include "mocked_devices.hpp"
#include "mocked_gpio_chip.hpp"
#include "zstrip_hal_linux/gpio.hpp"

namespace zstrip::linux_mock {
namespace {

using hal::Error;
using hal::GpioPin;

class LinuxMockedGpio : public testing::Test {
 protected:
  LinuxMockedGpio() { add(devices_, chip_); }

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

TEST_F(LinuxMockedGpio, AnInputIsReadEachTime) {
  auto pin = hal::GpioInput::request({"/dev/gpiochip0", 3});
  ASSERT_TRUE(pin) << pin.fault().message;
  EXPECT_TRUE(chip_.is_input);
  for (const int level : {1, 0, 0, 1}) {
    chip_.level = level;
    bool high = level == 0;
    EXPECT_EQ(pin->read(high), Error::none);
    EXPECT_EQ(high, level == 1);
  }
  chip_.refused_level = EIO;
  bool high = false;
  EXPECT_EQ(pin->read(high), Error::pin);
  EXPECT_EQ(hal::GpioInput().read(high), Error::pin) << "no line";

  EXPECT_EQ(hal::GpioInput::request({"/dev/gpiochip0", 2}).fault().message.substr(0, 39),
            "/dev/gpiochip0 line 2 is busy: 'heartbe");
  EXPECT_EQ(hal::GpioInput::request({"/dev/gpiochip0", 4}).fault().message,
            "/dev/gpiochip0 has no line 4, only 4 lines from 0 on");
  chip_.refused_request = EIO;
  EXPECT_EQ(hal::GpioInput::request({"/dev/gpiochip0", 3}).fault().message,
            "/dev/gpiochip0 cannot make line 3 an input: Input/output error");
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
