// What boards with an STM32F405 or F407 share: clock and pins. Source: RM0090.
#pragma once

#include <cstdint>

#include "cortex_m/registers.hpp"

namespace zstrip::board::stm32 {

// RCC, chapter 7. Ports A.. are bits 0.. of AHB1.
inline constexpr std::uint32_t kAhb1Enable = 0x40023830;
inline constexpr std::uint32_t kAhb1Dma2 = 1U << 22;
inline constexpr std::uint32_t kApb1Enable = 0x40023840;
inline constexpr std::uint32_t kApb1Usart2 = 1U << 17, kApb1Power = 1U << 28;
inline constexpr std::uint32_t kApb2Enable = 0x40023844;
inline constexpr std::uint32_t kApb2Usart1 = 1U << 4, kApb2Spi1 = 1U << 12;

// GPIO, chapter 8.
constexpr std::uint32_t gpio_f4(char port) { return 0x40020000U + 0x400U * static_cast<std::uint32_t>(port - 'A'); }
constexpr std::uint32_t set_reset_f4(char port) { return gpio_f4(port) + 0x18; }

/// Clocks of the buses after start_clock_f4(), in hertz.
struct ClocksF4 {
  std::uint32_t processor, apb1, apb2;
};

/// 168 MHz from the crystal and the PLL; crystal_megahertz 4..26. Where the crystal does not start, or the PLL does not
/// lock, the board stays on its internal oscillator of 16 MHz: a slow board that speaks is better than a dead one.
void start_clock_f4(std::uint32_t crystal_megahertz);

/// What start_clock_f4() came to.
const ClocksF4& clocks();

/// Turns the clock of a bus's peripherals on, and waits until they may be touched (RM0090, 7.2.14: two cycles).
inline void enable_clock(std::uint32_t bus, std::uint32_t bits) {
  register_at(bus) = register_at(bus) | bits;
  [[maybe_unused]] const std::uint32_t settled = register_at(bus);
}

/// Fast push-pull pins without pull resistors; the port's clock must run.
void make_output_f4(char port, unsigned pin);
void make_alternate_f4(char port, unsigned pin, std::uint32_t function);

}  // namespace zstrip::board::stm32
