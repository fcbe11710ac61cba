// Wiring of the STM32F4 Discovery (MB997). Source: user manual UM1472, table 5 (which pins are free).
#pragma once

#include "stm32/f4.hpp"
#include "stm32/pin.hpp"
#include "stm32/usart.hpp"

namespace zstrip::board {

inline constexpr std::uint32_t kCrystalMegahertz = 8;

// The console, for a serial adapter: PA2 sends, PA3 receives.
using Console = stm32::Usart<0x40004400>;  // USART2, AF7

// The panel: PB3 clock, PB5 data (SPI1, AF5; PA5 and PA7 lead to the board's motion sensor), and the lines below.
using PanelDataCommand = Pin<stm32::set_reset_f4('E'), 7>;
using PanelReset = Pin<stm32::set_reset_f4('E'), 8>;
using PanelSelect = Pin<stm32::set_reset_f4('E'), 9>;
using PanelLight = Pin<stm32::set_reset_f4('E'), 10>;

/// Enables the clocks and sets the pins of the panel's SPI and its DMA.
void start_panel_pins();

}  // namespace zstrip::board
