// Opens the files of devices, and explains refusals of Linux to the user.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "zstrip_hal_linux/file_descriptor.hpp"
#include "zstrip_hal_linux/outcome.hpp"

namespace zstrip::hal {

enum class DeviceKind : std::uint8_t { framebuffer, graphics_card, spi, i2c, gpio, console };

/// Returns the meaning of a system call's `error` (errno) for the device at `path`, and the remedy. `doing` completes
/// the sentence "cannot ...": "be opened", "set its speed to 40 MHz".
Fault device_fault(DeviceKind kind, const std::string& path, std::string_view doing, int error);

/// Opens a device for reading and writing; programs that are started do not inherit the file.
Outcome<FileDescriptor> open_device(DeviceKind kind, const std::string& path);

/// Calls ioctl, again if a signal interrupts it. Returns 0 or errno.
int device_control(int file, unsigned long request, void* argument);

}  // namespace zstrip::hal
