// Time on the micro:bit: TIMER0 counts microseconds.
#pragma once

#include <cstdint>

namespace zstrip::board {

/// Starts the timer. To be called once, before the others.
void start_timer();

/// Fulfils hal::Clock; sleeps while it waits.
class TimerClock {
 public:
  void wait(std::uint32_t microseconds);
};

}  // namespace zstrip::board
