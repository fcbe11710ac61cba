// Frame clock and watchdog of the boards with an STM32F4.
#include "cortex_m/systick.hpp"
#include "portable/pacing.hpp"
#include "stm32/f4.hpp"
#include "stm32/watchdog.hpp"

namespace zstrip::board {

void start_pacing() {
  start_systick(stm32::clocks().processor, 30);
  stm32::start_independent_watchdog();
}

void wait_for_tick() { wait_for_systick(); }

void feed_watchdog() { stm32::feed_independent_watchdog(); }

}  // namespace zstrip::board
