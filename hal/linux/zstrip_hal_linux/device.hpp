// Opening the files of devices, and what to say when Linux refuses.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "zstrip_hal_linux/file_descriptor.hpp"
#include "zstrip_hal_linux/outcome.hpp"

namespace zstrip::hal {

enum class DeviceKind : std::uint8_t { framebuffer, graphics_card, spi, i2c, gpio, console };

/// What a system call's `error` (errno) means for the device at `path`, and the remedy; `doing` completes
/// "cannot ...": "be opened", "set its speed to 40 MHz".
Fault device_fault(DeviceKind kind, const std::string& path, std::string_view doing, int error);

/// For reading and writing; not inherited by programs that are started.
Outcome<FileDescriptor> open_device(DeviceKind kind, const std::string& path);

/// ioctl, again after a signal. 0, or errno.
int device_control(int file, unsigned long request, void* argument);

}  // namespace zstrip::hal
