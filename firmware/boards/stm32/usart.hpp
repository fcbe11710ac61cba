// A USART of STM32F1 and STM32F4 as the console: 8 bits, no parity, 1 stop bit, polled. Sources: RM0041, chapter 23;
// RM0090, chapter 30.
#pragma once

#include <cstdint>

#include "cortex_m/registers.hpp"

namespace zstrip::board::stm32 {

/// The USART at `address`; its clock must run and its pins must be configured.
template <std::uint32_t address>
struct Usart {
  static constexpr std::uint32_t kStatus = address, kData = address + 0x04, kBaudRate = address + 0x08;
  static constexpr std::uint32_t kControl1 = address + 0x0C;

  /// `hertz` is the peripheral's clock.
  static void start(std::uint32_t hertz, std::uint32_t baud) {
    constexpr std::uint32_t kReceiveEnable = 1U << 2, kTransmitEnable = 1U << 3, kEnable = 1U << 13;
    register_at(kBaudRate) = (hertz + baud / 2) / baud;
    register_at(kControl1) = kEnable | kTransmitEnable | kReceiveEnable;
  }

  static void put(char character) {
    constexpr std::uint32_t kTransmitEmpty = 1U << 7;
    while ((register_at(kStatus) & kTransmitEmpty) == 0) {
    }
    register_at(kData) = static_cast<unsigned char>(character);
  }

  static bool take(char& character) {
    constexpr std::uint32_t kReceived = 1U << 5;
    if ((register_at(kStatus) & kReceived) == 0) return false;
    const std::uint32_t data = register_at(kData);
    character = static_cast<char>(data);
    return true;
  }
};

}  // namespace zstrip::board::stm32
