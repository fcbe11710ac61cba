// Clock and pins that boards with an STM32F405 or F407 share. Source: RM0090.
#pragma once

#include <cstdint>

#include "cortex_m/registers.hpp"
#include "stm32/f4_registers.hpp"

namespace zstrip::board::stm32 {

constexpr std::uint32_t set_reset_f4(char port) { return gpio_f4(port) + kGpioSetReset; }

/// The clocks of the buses after start_clock_f4(), in hertz.
struct ClocksF4 {
  std::uint32_t processor, apb1, apb2;
};

/// Sets 160 MHz from the crystal and the PLL; crystal_megahertz 4..26. If the crystal does not start, or the PLL does
/// not lock, the board stays on its internal oscillator of 16 MHz: a slow board that reports is better than a dead one.
void start_clock_f4(std::uint32_t crystal_megahertz);

/// Returns the clocks that start_clock_f4() has set.
const ClocksF4& clocks();

/// Enables the clock of a bus's peripherals, and waits until they may be accessed (RM0090, 7.2.14: two cycles).
inline void enable_clock(std::uint32_t bus, std::uint32_t bits) {
  register_at(bus) = register_at(bus) | bits;
  [[maybe_unused]] const std::uint32_t settled = register_at(bus);
}

/// These make fast push-pull pins without pull resistors; the port's clock must run.
void make_output_f4(char port, unsigned pin);
void make_alternate_f4(char port, unsigned pin, std::uint32_t function);

}  // namespace zstrip::board::stm32
