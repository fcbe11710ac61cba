// A GPIO chip that is not there, for libgpiod 1.6.
#pragma once

#include <fcntl.h>
#include <linux/gpio.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <vector>

#include "mocked_devices.hpp"

namespace zstrip::linux_mock {

/// It has four lines. Line 1 is CLOCK, line 2 belongs to a driver.
struct MockedChip {
  int refused_request = 0;  ///< errno for a request
  int refused_level = 0;    ///< errno for a level
  unsigned requested = 0;
  std::vector<int> levels;
  bool is_input = false;
  int level = 0;  ///< of an input

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
      is_input = (asked.flags & GPIOHANDLE_REQUEST_INPUT) != 0;
      requested = asked.lineoffsets[0];
      levels.push_back(asked.default_values[0]);
      asked.fd = open("/dev/gpiohandle", O_RDWR | O_CLOEXEC);
      return asked.fd >= 0 ? 0 : errno;
    }
    return ENOTTY;
  }
  int handle_control(unsigned long request, void* argument) {
    if (refused_level != 0) return refused_level;
    if (request == GPIOHANDLE_GET_LINE_VALUES_IOCTL) {
      static_cast<gpiohandle_data*>(argument)->values[0] = static_cast<std::uint8_t>(level);
      return 0;
    }
    if (request != GPIOHANDLE_SET_LINE_VALUES_IOCTL) return ENOTTY;
    levels.push_back(static_cast<gpiohandle_data*>(argument)->values[0]);
    return 0;
  }
};

/// As /dev/gpiochip0.
inline void add(MockedDevices& devices, MockedChip& chip) {
  devices.add("gpio", "gpiochip0", 254, 0,
              [&chip](auto request, void* argument) { return chip.control(request, argument); });
  devices.add("gpio", "gpiohandle", 254, 1,
              [&chip](auto request, void* argument) { return chip.handle_control(request, argument); });
}

}  // namespace zstrip::linux_mock
