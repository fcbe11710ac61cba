// SysTick as frame clock and for waiting, asleep. No interrupt handler: interrupts stay masked, and a masked one that
// is pending still ends WFI. Source: Armv7-M architecture reference manual, B3.3 and B1.5.17; Armv6-M has the same.
#pragma once

#include <cstdint>

namespace zstrip::board {

/// Ticks of the processor's clock, `hertz`, at least 1 MHz: `per_second` of them, at least hertz / 2^24. To be called
/// once.
void start_systick(std::uint32_t hertz, std::uint32_t per_second);

/// Sleeps until a tick; at once if there was one since the last call.
void wait_for_systick();

/// Fulfils hal::Clock, before or after start_systick(): takes SysTick for itself meanwhile, so that the frame clock
/// begins a new tick afterwards.
class SysTickClock {
 public:
  explicit constexpr SysTickClock(std::uint32_t hertz) : megahertz_((hertz + 999'999) / 1'000'000) {}
  void wait(std::uint32_t microseconds);

 private:
  std::uint32_t megahertz_;  ///< rounded up: rather too late than too early
};

}  // namespace zstrip::board
