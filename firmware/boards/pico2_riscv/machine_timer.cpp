// The functions of cortex_m/systick.hpp with the RISC-V platform timer, which counts microseconds. Interrupts stay
// masked: one that is enabled and pending ends WFI also while it is masked. Source: The RISC-V Instruction Set Manual,
// volume II, 3.2.1 (timer) and 3.3.3 (WFI).
#include "cortex_m/systick.hpp"
#include "pico/chip.hpp"

namespace zstrip::board {
namespace {

using namespace chip;

constexpr std::uint32_t kMicroseconds = 1'000'000;
std::uint32_t period = 0;  // microseconds of a tick; 0: the frame clock does not run
std::uint64_t next_tick = 0;

std::uint64_t now() {
  for (;;) {
    const std::uint32_t upper = register_at(kTimeUpper), lower = register_at(kTime);
    if (register_at(kTimeUpper) == upper) return std::uint64_t{upper} << 32 | lower;
  }
}

void enable_timer() {
  constexpr std::uint32_t kTimerInterrupt = 1U << 7;
  start_time_tick();
  asm volatile("csrs mie, %0" ::"r"(kTimerInterrupt));
}

void sleep_until(std::uint64_t time) {
  // While the two halves do not match, the upper half is at its maximum, so that no interrupt can occur.
  register_at(kCompareUpper) = 0xFFFFFFFF;
  register_at(kCompare) = static_cast<std::uint32_t>(time);
  register_at(kCompareUpper) = static_cast<std::uint32_t>(time >> 32);
  while (now() < time) asm volatile("wfi" ::: "memory");
}

}  // namespace

void start_systick(std::uint32_t, std::uint32_t per_second) {
  enable_timer();
  period = kMicroseconds / per_second;
  next_tick = now() + period;
}

void wait_for_systick() {
  sleep_until(next_tick);
  // Several missed ticks count as one.
  const std::uint64_t time = now();
  next_tick += (time - next_tick) / period * period + period;
}

void SysTickClock::wait(std::uint32_t microseconds) {
  enable_timer();
  sleep_until(now() + microseconds + 1);  // + 1: the current microsecond has begun
  if (period != 0) next_tick = now() + period;
}

}  // namespace zstrip::board
