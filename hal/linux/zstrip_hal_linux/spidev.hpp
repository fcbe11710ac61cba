// A panel on SPI by the kernel's driver, /dev/spidevB.C, with D/C on a GPIO line.
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

/// Everything has been sent when a function returns: wait() has nothing to do. Chip select goes high between messages,
/// which panels take for a pause. Time-outs are those of the kernel's driver. Errors: bus, pin.
///
/// Reading is slower than writing, and D/C stays low: one message is the question and its answer, as the kernel's own
/// drivers of panels (mipi_dbi) do it. A controller that has no input refuses it: Error::bus.
class SpidevBus {
 public:
  static constexpr std::uint32_t kReadHertz = 2'000'000;  ///< at most, when the panel answers
  /// Mode 0, 8 bits, at most `hertz`: read back, for drivers that accept what they cannot do.
  static Outcome<SpidevBus> open(const std::string& path, std::uint32_t hertz, GpioPin data_command);

  /// @{
  /// As the concept CommandDataBus states.
  Error write_command(std::span<const std::byte> bytes) { return write(bytes, false); }
  Error write_data(std::span<const std::byte> bytes) { return write(bytes, true); }
  Error wait() { return Error::none; }
  /// @}
  /// As the concept ReadableBus states.
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
