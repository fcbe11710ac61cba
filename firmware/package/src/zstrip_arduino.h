// The wires of a panel, made of what every Arduino core has: its SPI, its pins, its clock.
#pragma once

#include <Arduino.h>
#include <SPI.h>

#include "zstrip.h"

namespace zstrip::hal {

struct ArduinoClock {
  void wait(std::uint32_t microseconds) {
    if (microseconds < 1000) {
      delayMicroseconds(microseconds + 1);  // some boards count to one too few
    } else {
      delay((microseconds + 999) / 1000);
    }
  }
};

/// An output, by Arduino's number.
class ArduinoPin {
 public:
  explicit ArduinoPin(int number) : number_(number) { pinMode(number_, OUTPUT); }
  Error set(bool high) {
    digitalWrite(number_, high ? HIGH : LOW);
    return Error::none;
  }

 private:
  int number_;
};

struct ArduinoSpiPins {
  int data_command;                      ///< high for data
  int select = -1;                       ///< low selects; -1: the panel is always selected
  decltype(SPI_MODE0) mode = SPI_MODE0;  ///< SPI_MODE3 for most modules without a select pin
};

/// A panel on the controller of SPI: CommandDataBus of zstrip_hal/bus.hpp. Everything has been sent when a function
/// returns; no core reports errors of it. Cores name the class of SPI differently.
template <class Spi>
class ArduinoSpi {
 public:
  ArduinoSpi(Spi& spi, const ArduinoSpiPins& pins, std::uint32_t hertz)
      : spi_(spi), pins_(pins), settings_(hertz, MSBFIRST, pins.mode) {}

  /// To be called once, before anything else.
  void start() {
    pinMode(pins_.data_command, OUTPUT);
    if (pins_.select >= 0) {
      digitalWrite(pins_.select, HIGH);
      pinMode(pins_.select, OUTPUT);
    }
    spi_.begin();
  }

  Error write_command(std::span<const std::byte> bytes) { return write(bytes, false); }
  Error write_data(std::span<const std::byte> bytes) { return write(bytes, true); }
  Error wait() { return Error::none; }

 private:
  /// SPI.transfer() puts what it receives over what it sends, and this must not change: it goes by way of a copy.
  Error write(std::span<const std::byte> bytes, bool data) {
    spi_.beginTransaction(settings_);
    digitalWrite(pins_.data_command, data ? HIGH : LOW);
    if (pins_.select >= 0) digitalWrite(pins_.select, LOW);
    std::byte part[64];
    while (!bytes.empty()) {
      const std::size_t count = bytes.size() < sizeof part ? bytes.size() : sizeof part;
      for (std::size_t i = 0; i < count; ++i) part[i] = bytes[i];
      spi_.transfer(part, count);
      bytes = bytes.subspan(count);
    }
    if (pins_.select >= 0) digitalWrite(pins_.select, HIGH);
    spi_.endTransaction();
    return Error::none;
  }

  Spi& spi_;
  ArduinoSpiPins pins_;
  SPISettings settings_;
};

}  // namespace zstrip::hal
