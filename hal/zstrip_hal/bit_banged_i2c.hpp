// I2C without a controller: a writer over two open-drain pins.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "zstrip_hal/clock.hpp"
#include "zstrip_hal/error.hpp"
#include "zstrip_hal/open_drain_pin.hpp"

namespace zstrip::hal {

/// Runs at standard speed, 100 kHz at most: each half of a bit takes 5 us of `clock`. A device may hold the clock line
/// low for up to `kPatience` half bits; after that the call returns Error::timeout. Supports one master only. `clock`
/// must outlive the writer.
template <OpenDrainPin ClockPin, OpenDrainPin DataPin, Clock Time>
class BitBangedI2c {
 public:
  /// Pins are copied or moved in.
  constexpr BitBangedI2c(ClockPin clock_pin, DataPin data_pin, Time& clock)
      : scl_(std::move(clock_pin)), sda_(std::move(data_pin)), clock_(clock) {}

  /// Call it once before the first transfer, and again after an error that persists. A device that was interrupted
  /// within a byte may hold the data line low: nine clock pulses and a stop condition free it. Returns Error::bus if
  /// the line stays low.
  Error start() {
    Error error = sda_.release();
    for (int bit = 0; error == Error::none && bit < 9; ++bit) error = pulse();
    if (error == Error::none) error = end();
    bool high = false;
    if (error == Error::none) error = sda_.read(high);
    return error == Error::none && !high ? Error::bus : error;
  }

  /// See I2cWriter. Returns Error::timeout if a device holds the clock line low for 1 ms.
  Error begin(std::uint8_t address) {
    Error error = sda_.release();
    if (error == Error::none) error = rise();
    bool high = false;
    if (error == Error::none) error = sda_.read(high);
    if (error == Error::none && !high) return Error::bus;  // a device holds the line
    if (error == Error::none) error = sda_.pull_low();     // the start condition: data falls while the clock is high
    half();
    if (error == Error::none) error = fall();
    return error == Error::none ? send_byte(static_cast<std::uint32_t>(address) << 1) : error;  // bit 0 low: to write
  }

  /// See I2cWriter.
  Error send(std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) {
      if (const Error error = send_byte(std::to_integer<std::uint32_t>(byte)); error != Error::none) return error;
    }
    return Error::none;
  }

  /// See I2cWriter.
  Error end() {
    Error error = fall();
    if (error == Error::none) error = sda_.pull_low();
    half();
    if (error == Error::none) error = rise();
    const Error released = sda_.release();  // the stop condition: data rises while the clock is high
    half();
    return error != Error::none ? error : released;
  }

 private:
  static constexpr std::uint32_t kHalf = 5;  // us
  static constexpr int kPatience = 200;      // halves: 1 ms

  void half() { clock_.wait(kHalf); }

  Error fall() {
    const Error error = scl_.pull_low();
    half();
    return error;
  }
  /// Releases the clock line and waits until it is high: a device may stretch the clock.
  Error rise() {
    if (const Error error = scl_.release(); error != Error::none) return error;
    for (int i = 0; i < kPatience; ++i) {
      half();
      bool high = false;
      if (const Error error = scl_.read(high); error != Error::none) return error;
      if (high) return Error::none;
    }
    return Error::timeout;
  }
  Error pulse() {
    if (const Error error = fall(); error != Error::none) return error;
    return rise();
  }

  /// Data changes while the clock is low. The device acknowledges by pulling the data line low in the ninth bit.
  Error send_byte(std::uint32_t byte) {
    Error error = Error::none;
    for (int bit = 7; error == Error::none && bit >= 0; --bit) {
      error = ((byte >> bit) & 1U) != 0 ? sda_.release() : sda_.pull_low();
      if (error == Error::none) error = rise();
      if (error == Error::none) error = fall();
    }
    if (error == Error::none) error = sda_.release();
    if (error == Error::none) error = rise();
    bool refused = true;
    if (error == Error::none) error = sda_.read(refused);
    const Error fallen = fall();
    if (error != Error::none) return error;
    return refused ? Error::bus : fallen;
  }

  [[no_unique_address]] ClockPin scl_;
  [[no_unique_address]] DataPin sda_;
  Time& clock_;
};

}  // namespace zstrip::hal
