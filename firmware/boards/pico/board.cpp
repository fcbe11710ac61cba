// Raspberry Pi Pico and Pico 2: clocks from the crystal of 12 MHz, console, frame clock and watchdog. Source: data
// sheets of the chips, chapters in rp2040.hpp and rp2350.hpp.
#include "cortex_m/board.hpp"

#include "cortex_m/pl011.hpp"
#include "cortex_m/systick.hpp"
#include "pico/pins.hpp"
#include "portable/console_input.hpp"
#include "portable/pacing.hpp"

namespace zstrip::board {
namespace {

using namespace chip;
using Uart = Pl011<kUart0>;

/// Waits for bits of a register. A board whose crystal or PLL does not start cannot even report it.
void wait_until(std::uint32_t address, std::uint32_t bits) {
  constexpr int kPolls = 1'000'000;
  for (int poll = 0; poll < kPolls; ++poll) {
    if ((register_at(address) & bits) == bits) return;
  }
  halt(1);
}

void leave_reset(std::uint32_t subsystems) {
  clear_bits(kReset, subsystems);
  wait_until(kResetDone, subsystems);
}

// 12 MHz * 125 = 1500 MHz, divided by 2 and by 6 or 5: 125 or 150 MHz. The order is that of the RP2040 data sheet,
// 2.18.2.
constexpr std::uint32_t kFeedback = 125, kSecondDivider = 2;
constexpr std::uint32_t kFirstDivider = 12'000'000 * kFeedback / kSecondDivider / kHertz;
static_assert(kHertz * kFirstDivider * kSecondDivider == 12'000'000 * kFeedback);
static_assert(kFirstDivider <= 7 && kFirstDivider >= kSecondDivider);

void start_pll() {
  set_bits(kReset, kResetPllSys);
  leave_reset(kResetPllSys);
  register_at(kPllControl) = 1;  // the reference clock is not divided
  register_at(kPllFeedback) = kFeedback;
  clear_bits(kPllPower, kPllPowerDown | kPllVcoDown);
  wait_until(kPllControl, kPllLocked);
  register_at(kPllPostDividers) = kFirstDivider << 16 | kSecondDivider << 12;
  clear_bits(kPllPower, kPllPostDividersDown);
}

// After a reset by the watchdog the system may still run from the PLL: first switches to the clock that always runs.
void start_clocks() {
  clear_bits(kSystemControl, kSystemFromAuxiliary);
  wait_until(kSystemSelected, 1U << 0);
  constexpr std::uint32_t kMillisecond = 47;  // in units of 256 cycles
  register_at(kCrystalStartup) = kMillisecond;
  register_at(kCrystalControl) = kCrystalEnable;
  wait_until(kCrystalStatus, kCrystalStable);
  register_at(kReferenceControl) = kReferenceFromCrystal;
  wait_until(kReferenceSelected, 1U << kReferenceFromCrystal);
  start_pll();
  register_at(kSystemControl) = 0;  // the auxiliary source becomes the PLL before it is selected
  set_bits(kSystemControl, kSystemFromAuxiliary);
  wait_until(kSystemSelected, 1U << kSystemFromAuxiliary);
  register_at(kPeripheralControl) = kPeripheralEnable;
}

// 115200 baud: kHertz / (16 * 115200), in 1/64.
constexpr std::uint32_t kBaudDivisor = kHertz / (16 * 115200 / 64);

void start_uart() {
  register_at(pin_control(0)) = kFunctionUart;
  register_at(pin_control(1)) = kFunctionUart;
  connect_output(0);
  connect_input(1);
  Uart::start(kBaudDivisor / 64, kBaudDivisor % 64);
}

constexpr std::uint32_t kWatchdogTime = 8 * watchdog_counts_per_second();
static_assert(kWatchdogTime < 1U << 24);

}  // namespace

void start() {
  leave_reset(kResetIoBank0 | kResetPadsBank0);
  start_clocks();
  leave_reset(kResetUart0);
  start_uart();
}

void put_character(char character) { Uart::put(character); }

bool take_character(char& character) { return Uart::take(character); }

void halt(int) {
  for (;;) asm volatile("wfi");
}

void start_pacing() {
  start_systick(kHertz, 30);
  start_ticks();
  register_at(kWatchdogControl) = 0;
  register_at(kWatchdogResets) = kAllButOscillators;
  register_at(kWatchdogLoad) = kWatchdogTime;
  register_at(kWatchdogControl) = kWatchdogEnable;
}

void wait_for_tick() { wait_for_systick(); }

void feed_watchdog() { register_at(kWatchdogLoad) = kWatchdogTime; }

}  // namespace zstrip::board
