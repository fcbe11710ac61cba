// A panel on SPI through the kernel's driver, /dev/spidevB.C, with D/C on a GPIO line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "zstrip_hal/bus.hpp"
#include "zstrip_hal_linux/device.hpp"
#include "zstrip_hal_linux/gpio.hpp"

namespace zstrip::hal {

/// All bytes have been sent when a function returns, so wait() has nothing to do. Chip select goes high between
/// messages, which panels accept as a pause. The kernel's driver sets the time-outs. Errors: bus, pin.
///
/// Reading uses a slower clock than writing, and D/C stays low: one message holds the command and the answer, as in
/// the kernel's own panel drivers (mipi_dbi). A controller without an input refuses it: Error::bus.
class SpidevBus {
 public:
  static constexpr std::uint32_t kReadHertz = 2'000'000;  ///< at most, when the panel answers
  /// Uses mode 0, 8 bits, at most `hertz`. Reads the settings back, because some drivers accept values that they
  /// cannot use.
  static Outcome<SpidevBus> open(const std::string& path, std::uint32_t hertz, GpioPin data_command);

  /// @{
  /// See the concept CommandDataBus.
  Error write_command(std::span<const std::byte> bytes) { return write(bytes, false); }
  Error write_data(std::span<const std::byte> bytes) { return write(bytes, true); }
  Error wait() { return Error::none; }
  /// @}
  /// See the concept ReadableBus.
  Error read(std::byte command, unsigned dummy_clocks, std::span<std::byte> answer);

 private:
  SpidevBus(FileDescriptor file, std::uint32_t hertz, GpioPin data_command);
  Error write(std::span<const std::byte> bytes, bool data);

  FileDescriptor file_;
  std::uint32_t hertz_;
  std::size_t message_bytes_;  ///< spidev refuses longer messages
  GpioPin data_command_;
};

static_assert(ReadableBus<SpidevBus>);

}  // namespace zstrip::hal
