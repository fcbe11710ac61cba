// Wiring of the Netduino Plus 2, by the names on its headers. Source: the board's schematic.
#pragma once

#include "stm32/f4.hpp"
#include "stm32/pin.hpp"
#include "stm32/usart.hpp"

namespace zstrip::board {

inline constexpr std::uint32_t kCrystalMegahertz = 25;

// The console: D0 receives, D1 sends.
using Console = stm32::Usart<0x40011400>;  // USART6, PC6 and PC7, AF8

// The panel: D13 clock, D11 data (SPI2: PB13 and PB15, AF5), and three more lines.
inline constexpr std::uint32_t kPanelSpi = 0x40003800;
using PanelSelect = Pin<stm32::set_reset_f4('B'), 10>;      // D10
using PanelDataCommand = Pin<stm32::set_reset_f4('A'), 6>;  // D9
using PanelReset = Pin<stm32::set_reset_f4('A'), 0>;        // D8

/// Enables the clocks and sets the pins of the panel's SPI.
void start_panel_pins();

}  // namespace zstrip::board
