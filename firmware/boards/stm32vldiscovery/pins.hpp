// Wiring of the STM32VLDISCOVERY. Source: user manual UM0919, table 5 (which pins are free).
#pragma once

#include "stm32/pin.hpp"
#include "stm32/usart.hpp"

namespace zstrip::board {

inline constexpr std::uint32_t kHertz = 8'000'000;  // the internal oscillator, for the processor and all buses

using Console = stm32::Usart<0x40013800>;  // USART1: PA9 sends, PA10 receives

// The panel: PA5 clock, PA7 data (SPI1), and the lines below.
inline constexpr std::uint32_t kPanelSpi = 0x40013000;
inline constexpr std::uint32_t kSetResetA = 0x40010810, kSetResetB = 0x40010C10;
using PanelSelect = Pin<kSetResetA, 4>;
using PanelDataCommand = Pin<kSetResetB, 0>;
using PanelReset = Pin<kSetResetB, 1>;

/// Enables the clocks and sets the pins of the panel's SPI.
void start_panel_pins();

}  // namespace zstrip::board
