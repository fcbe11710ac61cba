// EK-LM3S6965: clocks, pins and UART0. 50 MHz from the PLL and the board's 8 MHz crystal.
#include "cortex_m/board.hpp"

#include "cortex_m/pl011.hpp"
#include "cortex_m/registers.hpp"
#include "lm3s6965evb/chip.hpp"
#include "portable/console_input.hpp"

namespace zstrip::board {
namespace {

using Uart = Pl011<chip::kUart0>;

// The order of the data sheet: leave the PLL, choose the crystal, power the PLL up, wait, use it.
void start_clock() {
  constexpr std::uint32_t kBypass = 1U << 11;
  constexpr std::uint32_t kCrystal8MHz = 0xEU << 6;
  constexpr std::uint32_t kDivideBy4 = 3U << 23 | 1U << 22;  // divides the PLL's 200 MHz
  // All other bits are zero: main oscillator on and chosen, PLL powered, its output enabled.
  register_at(chip::kClockConfig) = kBypass | kCrystal8MHz | kDivideBy4;
  constexpr int kPolls = 100'000;  // the lock takes 0.5 ms at most
  int poll = 0;
  while ((register_at(chip::kClockStatus) & chip::kPllLocked) == 0) {
    if (++poll == kPolls) halt(1);  // without its clock the board cannot report anything
  }
  register_at(chip::kClockConfig) = kCrystal8MHz | kDivideBy4;
}

void enable_peripherals() {
  register_at(chip::kClockGating1) = chip::kGateUart0 | chip::kGateSsi0;
  register_at(chip::kClockGating2) = chip::kGateGpioA | chip::kGateGpioC | chip::kGateGpioD;
  // A peripheral must not be accessed until its clock has run for three cycles, which a read takes.
  [[maybe_unused]] const std::uint32_t settled = register_at(chip::kClockGating2);
}

// 115200 baud at 50 MHz: 50e6 / (16 * 115200) = 27 + 8/64.
void start_uart() {
  constexpr std::uint32_t kPins = 0x03;  // PA0 receives, PA1 sends
  register_at(chip::kGpioA + chip::kGpioAlternate) = register_at(chip::kGpioA + chip::kGpioAlternate) | kPins;
  register_at(chip::kGpioA + chip::kGpioDigital) = register_at(chip::kGpioA + chip::kGpioDigital) | kPins;
  Uart::start(27, 8);
}

}  // namespace

void start() {
  start_clock();
  enable_peripherals();
  start_uart();
}

void put_character(char character) { Uart::put(character); }

bool take_character(char& character) { return Uart::take(character); }

void halt(int) {
  for (;;) asm volatile("wfi");
}

}  // namespace zstrip::board
