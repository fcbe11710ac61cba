// STM32F4 Discovery: clock, console and pins of its STM32F407. Source: reference manual RM0090, chapters 7 (RCC) and 8
// (GPIO).
#include "cortex_m/board.hpp"

#include "portable/console_input.hpp"
#include "stm32f4discovery/pins.hpp"

namespace zstrip::board {

void start() {
  stm32::start_clock_f4(kCrystalMegahertz);
  constexpr std::uint32_t kPortA = 1U << 0, kUsart2 = 7;
  stm32::enable_clock(stm32::kAhb1Enable, kPortA);
  stm32::enable_clock(stm32::kApb1Enable, stm32::kApb1Usart2);
  stm32::make_alternate_f4('A', 2, kUsart2);
  stm32::make_alternate_f4('A', 3, kUsart2);
  Console::start(stm32::clocks().apb1, 115'200);
}

void start_panel_pins() {
  constexpr std::uint32_t kPortB = 1U << 1, kPortE = 1U << 4, kSpi1 = 5;
  stm32::enable_clock(stm32::kAhb1Enable, kPortB | kPortE | stm32::kAhb1Dma2);
  stm32::enable_clock(stm32::kApb2Enable, stm32::kApb2Spi1);
  stm32::make_alternate_f4('B', 3, kSpi1);
  stm32::make_alternate_f4('B', 5, kSpi1);
  for (unsigned pin = 7; pin <= 10; ++pin) stm32::make_output_f4('E', pin);
}

void put_character(char character) { Console::put(character); }
bool take_character(char& character) { return Console::take(character); }

void halt(int) {
  for (;;) asm volatile("wfi");
}

}  // namespace zstrip::board
