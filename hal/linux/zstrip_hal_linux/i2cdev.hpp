// A panel on I2C by the kernel's driver, /dev/i2c-N.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "zstrip_hal/bus.hpp"
#include "zstrip_hal_linux/device.hpp"

namespace zstrip::hal {

/// Commands and data are told apart by the control byte of zstrip_hal/i2c.hpp, in transfers (I2C_RDWR) of at most
/// kMessageBytes. Everything has been sent when a function returns: wait() has nothing to do. How fast the bus is, is
/// the kernel's: as in the device tree, 100 kHz by default. Errors: bus (no device acknowledges, another master,
/// anything else that the kernel refuses), timeout (a transfer that does not end, as where SCL is held low).
///
/// The kernel's driver gives a transfer kTimeout. Most drivers keep to it; those of bit-banged buses and of i.MX have
/// shorter ones of their own. The kernel keeps the setting for the whole controller, also after the program's end: it
/// is what it starts with where its driver says nothing else.
class I2cdevBus {
 public:
  static constexpr std::size_t kMessageBytes = 4096;  ///< i2c-dev takes 8192
  static constexpr unsigned kTimeout = 1000;          ///< ms; kMessageBytes take 370 at 100 kHz

  /// `address` has 7 bits. Errors: no such device, no permission, a controller that has no plain I2C, an address that a
  /// driver of the kernel has, or at which no device answers in time: a control byte without anything behind it is sent
  /// to it.
  static Outcome<I2cdevBus> open(const std::string& path, std::uint8_t address);

  /// @{
  /// As the concept CommandDataBus states.
  Error write_command(std::span<const std::byte> bytes) { return write(std::byte{0x00}, bytes); }
  Error write_data(std::span<const std::byte> bytes) { return write(std::byte{0x40}, bytes); }
  Error wait() { return Error::none; }
  /// @}

 private:
  I2cdevBus(FileDescriptor file, std::uint8_t address) : file_(std::move(file)), address_(address) {}
  Error write(std::byte control, std::span<const std::byte> bytes);
  /// 0 or errno.
  int transfer();

  FileDescriptor file_;
  std::uint8_t address_;
  std::vector<std::byte> message_;
};

static_assert(CommandDataBus<I2cdevBus>);

}  // namespace zstrip::hal
