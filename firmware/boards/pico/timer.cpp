// The timer counts as soon as its reset is released and it gets ticks.
#include "pico/timer.hpp"

#include "pico/chip.hpp"

namespace zstrip::board {

using namespace chip;

void start_timer() {
  clear_bits(kReset, kResetTimer);
  constexpr int kPolls = 20'000;
  for (int poll = 0; poll < kPolls && (register_at(kResetDone) & kResetTimer) == 0; ++poll) {
  }
  start_timer_tick();
}

std::uint32_t milliseconds() {
  const std::uint32_t lower = register_at(kTimerLower);
  return static_cast<std::uint32_t>((std::uint64_t{register_at(kTimerUpper)} << 32 | lower) / 1000);
}

}  // namespace zstrip::board
