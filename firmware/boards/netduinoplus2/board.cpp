// Netduino Plus 2: clock, console and pins of its STM32F405. Source: reference manual RM0090, chapters 7 (RCC) and 8
// (GPIO).
#include "cortex_m/board.hpp"

#include "netduinoplus2/pins.hpp"
#include "portable/console_input.hpp"

namespace zstrip::board {
namespace {

constexpr std::uint32_t kPortsAToC = 7;

}  // namespace

void start() {
  stm32::start_clock_f4(kCrystalMegahertz);
  stm32::enable_clock(stm32::kAhb1Enable, kPortsAToC);
  stm32::enable_clock(stm32::kApb2Enable, stm32::kApb2Usart6);
  constexpr std::uint32_t kUsart6 = 8;
  stm32::make_alternate_f4('C', 6, kUsart6);
  stm32::make_alternate_f4('C', 7, kUsart6);
  Console::start(stm32::clocks().apb2, 115'200);
}

void start_panel_pins() {
  stm32::enable_clock(stm32::kApb1Enable, stm32::kApb1Spi2);
  constexpr std::uint32_t kSpi2 = 5;
  stm32::make_alternate_f4('B', 13, kSpi2);
  stm32::make_alternate_f4('B', 15, kSpi2);
  stm32::make_output_f4('B', 10);
  stm32::make_output_f4('A', 6);
  stm32::make_output_f4('A', 0);
}

void put_character(char character) { Console::put(character); }
bool take_character(char& character) { return Console::take(character); }

void halt(int) {
  for (;;) asm volatile("wfi");
}

}  // namespace zstrip::board
