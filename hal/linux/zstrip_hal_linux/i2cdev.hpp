// A panel on I2C through the kernel's driver, /dev/i2c-N.
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

/// The control byte of zstrip_hal/i2c.hpp tells commands from data. Transfers (I2C_RDWR) have at most kMessageBytes.
/// All bytes have been sent when a function returns, so wait() has nothing to do. The kernel sets the bus speed, from
/// the device tree: 100 kHz by default. Errors: bus (no device acknowledges, another master, any other refusal by the
/// kernel), timeout (a transfer that does not end, for example because SCL is held low).
///
/// This class sets the kernel's time-out for a transfer to kTimeout. Most drivers obey it; those of bit-banged buses
/// and of i.MX have shorter ones of their own. The kernel keeps the setting for the whole controller, also after the
/// program has ended; it equals the kernel's default, unless the controller's driver sets another.
class I2cdevBus {
 public:
  static constexpr std::size_t kMessageBytes = 4096;  ///< i2c-dev takes 8192
  static constexpr unsigned kTimeout = 1000;          ///< ms; kMessageBytes take 370 at 100 kHz

  /// `address` has 7 bits. Sends a lone control byte to the address as a test. Errors: no such device, no permission,
  /// the controller does not support plain I2C, a kernel driver has claimed the address, no device answers there in
  /// time.
  static Outcome<I2cdevBus> open(const std::string& path, std::uint8_t address);

  /// @{
  /// See the concept CommandDataBus.
  Error write_command(std::span<const std::byte> bytes) { return write(std::byte{0x00}, bytes); }
  Error write_data(std::span<const std::byte> bytes) { return write(std::byte{0x40}, bytes); }
  Error wait() { return Error::none; }
  /// @}

 private:
  I2cdevBus(FileDescriptor file, std::uint8_t address) : file_(std::move(file)), address_(address) {}
  Error write(std::byte control, std::span<const std::byte> bytes);
  /// Returns 0 or errno.
  int transfer();

  FileDescriptor file_;
  std::uint8_t address_;
  std::vector<std::byte> message_;
};

static_assert(CommandDataBus<I2cdevBus>);

}  // namespace zstrip::hal
