// Arm's serial port PL011, which chips of several makers have.
#pragma once

#include <cstdint>

#include "cortex_m/registers.hpp"

namespace zstrip::board {

/// `base` is the address of its registers, the first of which is the data register.
template <std::uint32_t base>
struct Pl011 {
  /// Sets 8 bits, no parity, 1 stop bit, both directions. Clock / (16 * baud rate) is `divisor` + `fraction` / 64.
  static void start(std::uint32_t divisor, std::uint32_t fraction) {
    register_at(base + 0x024) = divisor;
    register_at(base + 0x028) = fraction;
    register_at(base + 0x02C) = 0x60;   // 8 bits
    register_at(base + 0x030) = 0x301;  // enabled, both directions
  }

  static void put(char character) {
    while ((register_at(base + kFlags) & kTransmitFull) != 0) {
    }
    register_at(base) = static_cast<unsigned char>(character);
  }

  /// Takes a received character. Returns false if there is none.
  static bool take(char& character) {
    if ((register_at(base + kFlags) & kReceiveEmpty) != 0) return false;
    const std::uint32_t data = register_at(base);
    character = static_cast<char>(data);
    return true;
  }

 private:
  static constexpr std::uint32_t kFlags = 0x018;
  static constexpr std::uint32_t kReceiveEmpty = 1U << 4;
  static constexpr std::uint32_t kTransmitFull = 1U << 5;
};

}  // namespace zstrip::board
