// STM32VLDISCOVERY: console and pins of its STM32F100RB, on the internal oscillator of 8 MHz. Source: reference manual
// RM0041, chapters 6 (RCC) and 7 (GPIO).
#include "cortex_m/board.hpp"

#include "cortex_m/registers.hpp"
#include "portable/console_input.hpp"
#include "stm32vldiscovery/pins.hpp"

namespace zstrip::board {
namespace {

constexpr std::uint32_t kClockEnableApb2 = 0x40021018;
constexpr std::uint32_t kGateGpioA = 1U << 2, kGateGpioB = 1U << 3, kGateSpi1 = 1U << 12, kGateUsart1 = 1U << 14;

// Four bits a pin; the lower eight pins come first.
constexpr std::uint32_t kGpioA = 0x40010800, kGpioB = 0x40010C00;
constexpr std::uint32_t kOutput = 0x3, kAlternateOutput = 0xB;  // push-pull, 50 MHz

void configure(std::uint32_t port, unsigned pin, std::uint32_t mode) {
  const std::uint32_t address = port + (pin < 8 ? 0 : 4), shift = pin % 8 * 4;
  register_at(address) = (register_at(address) & ~(0xFU << shift)) | mode << shift;
}

}  // namespace

void start() {
  register_at(kClockEnableApb2) = register_at(kClockEnableApb2) | kGateGpioA | kGateUsart1;
  configure(kGpioA, 9, kAlternateOutput);  // PA10 is an input after reset
  Console::start(kHertz, 115'200);
}

void start_panel_pins() {
  register_at(kClockEnableApb2) = register_at(kClockEnableApb2) | kGateGpioB | kGateSpi1;
  configure(kGpioA, 5, kAlternateOutput);
  configure(kGpioA, 7, kAlternateOutput);
  configure(kGpioA, 4, kOutput);
  configure(kGpioB, 0, kOutput);
  configure(kGpioB, 1, kOutput);
}

void put_character(char character) { Console::put(character); }
bool take_character(char& character) { return Console::take(character); }

void halt(int) {
  for (;;) asm volatile("wfi");
}

}  // namespace zstrip::board
