// A panel's bus, pins and clock, made from the functions that every Arduino core has.
#pragma once

#include <Arduino.h>
#include <SPI.h>

#include "zstrip.h"

namespace zstrip::hal {

struct ArduinoClock {
  void wait(std::uint32_t microseconds) {
    if (microseconds < 1000) {
      delayMicroseconds(microseconds + 1);  // some boards wait one microsecond less
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

/// A panel on an SPI controller: CommandDataBus of zstrip_hal/bus.hpp. Where the core has transferAsync() (Raspberry Pi
/// Pico), write_data() sends by DMA, so two strip buffers save time; elsewhere all bytes have been sent when a function
/// returns. Arduino cores report no SPI errors: Error::timeout is a DMA that does not end in a second. `Spi` is a
/// parameter because cores name their class of SPI differently.
template <class Spi>
class ArduinoSpi {
 public:
  ArduinoSpi(Spi& spi, const ArduinoSpiPins& pins, std::uint32_t hertz)
      : spi_(spi), pins_(pins), settings_(hertz, MSBFIRST, pins.mode) {}

  /// Call it once, before any other function.
  void start() {
    pinMode(pins_.data_command, OUTPUT);
    if (pins_.select >= 0) {
      digitalWrite(pins_.select, HIGH);
      pinMode(pins_.select, OUTPUT);
    }
    spi_.begin();
  }

  Error write_command(std::span<const std::byte> bytes) {
    select(false);
    send(bytes);
    deselect();
    return Error::none;
  }
  Error write_data(std::span<const std::byte> bytes) {
    select(true);
    if constexpr (kHasDma) {
      // False: all channels are in use.
      if (!bytes.empty() && spi_.transferAsync(bytes.data(), nullptr, bytes.size())) {
        is_sending_ = true;
        return Error::none;
      }
    }
    send(bytes);
    deselect();
    return Error::none;
  }
  Error wait() {
    Error error = Error::none;
    if constexpr (kHasDma) {
      constexpr unsigned long kTimeout = 1000;  // ms
      if (!is_sending_) return Error::none;
      for (const unsigned long start = millis(); !spi_.finishedAsync() && error == Error::none;) {
        if (millis() - start > kTimeout) error = Error::timeout;
      }
      if (error != Error::none) spi_.abortAsync();
      is_sending_ = false;
      deselect();
    }
    return error;
  }

 private:
  static constexpr bool kHasDma = requires(Spi & spi, const void* bytes) {
    spi.transferAsync(bytes, nullptr, std::size_t{1});
    spi.finishedAsync();
    spi.abortAsync();
  };

  void select(bool data) {
    spi_.beginTransaction(settings_);
    digitalWrite(pins_.data_command, data ? HIGH : LOW);
    if (pins_.select >= 0) digitalWrite(pins_.select, LOW);
  }
  void deselect() {
    if (pins_.select >= 0) digitalWrite(pins_.select, HIGH);
    spi_.endTransaction();
  }

#ifdef ARDUINO_ARCH_RP2040
  /// SoftwareSPI, a bus by PIO, has no transferAsync(), and writes received bytes even if it gets no buffer for them.
  static constexpr bool kDiscards = requires(Spi & spi) { spi.finishedAsync(); };
#else
  static constexpr bool kDiscards = true;
#endif

  /// Does not change `bytes`. transfer(bytes, count), which every core has, overwrites them with the received bytes, so
  /// it gets a copy. On a Raspberry Pi Pico it also sends byte by byte, so the other functions are tried first.
  void send(std::span<const std::byte> bytes) {
    constexpr std::size_t kBlock = 256;  // some cores count in 16 bits
    while (!bytes.empty()) {
      const std::size_t count = bytes.size() < kBlock ? bytes.size() : kBlock;
      const void* const block = bytes.data();
      if constexpr (kDiscards && requires { spi_.transfer(block, static_cast<void*>(nullptr), count); }) {
        spi_.transfer(block, static_cast<void*>(nullptr), count);  // Raspberry Pi Pico, STM32, Teensy
      } else {
        alignas(4) std::byte copy[kBlock];
        for (std::size_t i = 0; i < count; ++i) copy[i] = bytes[i];
        if constexpr (requires(const std::uint8_t* sent) { spi_.writeBytes(sent, count); }) {
          spi_.writeBytes(reinterpret_cast<const std::uint8_t*>(copy), count);  // ESP32; ESP8266, which reads words
        } else {
          spi_.transfer(copy, count);
        }
      }
      bytes = bytes.subspan(count);
    }
  }

  Spi& spi_;
  ArduinoSpiPins pins_;
  SPISettings settings_;
  bool is_sending_ = false;  ///< by DMA; the panel is selected until wait()
};

}  // namespace zstrip::hal
