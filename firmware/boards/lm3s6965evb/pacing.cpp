// Frame clock and watchdog. Source: LM3S6965 data sheet, chapter 12.
#include "portable/pacing.hpp"

#include "cortex_m/registers.hpp"
#include "cortex_m/systick.hpp"
#include "lm3s6965evb/chip.hpp"

namespace zstrip::board {
namespace {

constexpr std::uint32_t kHertz = 50'000'000;
constexpr std::uint32_t kSeconds = 2;  // for each of the watchdog's two rounds; the second one ends in a reset

}  // namespace

void start_pacing() {
  start_systick(kHertz, 60);
  register_at(chip::kClockGating0) = register_at(chip::kClockGating0) | chip::kGateWatchdog;
  [[maybe_unused]] const std::uint32_t settled = register_at(chip::kClockGating0);
  register_at(chip::kWatchdogLoad) = kSeconds * kHertz;
  register_at(chip::kWatchdogControl) = chip::kWatchdogReset;
  register_at(chip::kWatchdogControl) = chip::kWatchdogReset | chip::kWatchdogInterrupt;  // this starts the watchdog
}

void wait_for_tick() { wait_for_systick(); }

// A write to the clear register also loads the counter again.
void feed_watchdog() { register_at(chip::kWatchdogClear) = 1; }

}  // namespace zstrip::board
