// Waiting by sleeping.
#pragma once

#include <chrono>
#include <cstdint>
#include <thread>

#include "zstrip_hal/clock.hpp"

namespace zstrip::hal {

struct SleepingClock {
  void wait(std::uint32_t microseconds) { std::this_thread::sleep_for(std::chrono::microseconds(microseconds)); }
};

static_assert(Clock<SleepingClock>);

}  // namespace zstrip::hal
