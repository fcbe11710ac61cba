// Time on the micro:bit: TIMER0 counts microseconds.
#pragma once

#include <cstdint>

namespace zstrip::board {

/// Starts the timer. Call it once, before any other function.
void start_timer();

/// Fulfils hal::Clock; sleeps while it waits.
class TimerClock {
 public:
  void wait(std::uint32_t microseconds);
};

}  // namespace zstrip::board
