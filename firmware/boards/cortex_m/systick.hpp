// SysTick as frame clock, and for waiting asleep. There is no interrupt handler: interrupts stay masked, and a pending
// one ends WFI also while it is masked. Source: Armv7-M architecture reference manual, B3.3 and B1.5.17; Armv6-M is the
// same here.
#pragma once

#include <cstdint>

namespace zstrip::board {

/// Starts `per_second` ticks a second; `hertz` is the processor's clock, at least 1 MHz; `per_second` is at least hertz
/// / 2^24. Call it once.
void start_systick(std::uint32_t hertz, std::uint32_t per_second);

/// Sleeps until a tick; returns at once if there was one since the last call.
void wait_for_systick();

/// Fulfils hal::Clock, before or after start_systick(). It uses SysTick while it waits, so that the frame clock begins
/// a new tick afterwards.
class SysTickClock {
 public:
  explicit constexpr SysTickClock(std::uint32_t hertz) : megahertz_((hertz + 999'999) / 1'000'000) {}
  void wait(std::uint32_t microseconds);

 private:
  [[maybe_unused]] std::uint32_t megahertz_;  ///< rounded up, so that a wait is never too short
};

}  // namespace zstrip::board
