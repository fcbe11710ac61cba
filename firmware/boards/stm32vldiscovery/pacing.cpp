// Frame clock and watchdog.
#include "portable/pacing.hpp"

#include "cortex_m/systick.hpp"
#include "stm32/watchdog.hpp"
#include "stm32vldiscovery/pins.hpp"

namespace zstrip::board {

void start_pacing() {
  start_systick(kHertz, 20);
  stm32::start_independent_watchdog();
}

void wait_for_tick() { wait_for_systick(); }

void feed_watchdog() { stm32::feed_independent_watchdog(); }

}  // namespace zstrip::board
