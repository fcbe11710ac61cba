// The part of I2C that panels need: writing to one device. Also a command/data bus over it, for panels that tell
// commands from data by a control byte (SSD1306 data sheet, I2C-bus write data).
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/bus.hpp"
#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

/// A controller of I2C. begin() sends the start condition and the address with the write bit, send() sends bytes of
/// the same transfer, end() sends the stop condition, also after an error. When a function returns, its bytes have
/// been sent and each was acknowledged. Error::bus: no device acknowledges, or a device holds the lines.
/// Error::timeout: the driver's own limit has passed.
template <class T>
concept I2cWriter = requires(T& i2c, std::uint8_t address, std::span<const std::byte> bytes) {
  { i2c.begin(address) } -> std::same_as<Error>;
  { i2c.send(bytes) } -> std::same_as<Error>;
  { i2c.end() } -> std::same_as<Error>;
};

/// Each write is a separate transfer; all bytes have been sent when it returns. `i2c` must outlive the bus.
template <I2cWriter Writer>
class I2cCommandDataBus {
 public:
  /// `address` has 7 bits: an SSD1306's is 0x3C or 0x3D, by the level of its pin D/C.
  constexpr I2cCommandDataBus(Writer& i2c, std::uint8_t address) : i2c_(i2c), address_(address) {}

  /// @{
  /// See the concept CommandDataBus; all bytes have been sent when the function returns.
  Error write_command(std::span<const std::byte> bytes) { return write(std::byte{0x00}, bytes); }
  Error write_data(std::span<const std::byte> bytes) { return write(std::byte{0x40}, bytes); }
  Error wait() { return Error::none; }
  /// @}

 private:
  /// The control byte: bit 6 is D/C; bit 7 low: no other control byte follows.
  Error write(std::byte control, std::span<const std::byte> bytes) {
    Error error = i2c_.begin(address_);
    if (error == Error::none) error = i2c_.send(std::span(&control, 1));
    if (error == Error::none) error = i2c_.send(bytes);
    const Error end = i2c_.end();
    return error != Error::none ? error : end;
  }

  Writer& i2c_;
  std::uint8_t address_;
};

}  // namespace zstrip::hal
