// A clock that sleeps.
#pragma once

#include <chrono>
#include <cstdint>
#include <thread>

#include "zstrip_hal/clock.hpp"

namespace zstrip::hal {

/// The clock for panel drivers in a process.
struct SleepingClock {
  /// Sleeps for at least this time.
  void wait(std::uint32_t microseconds) { std::this_thread::sleep_for(std::chrono::microseconds(microseconds)); }
};

static_assert(Clock<SleepingClock>);

}  // namespace zstrip::hal
