// SysTick's three registers, and its pending bit in the system control block.
#include "cortex_m/systick.hpp"

#include "cortex_m/registers.hpp"

namespace zstrip::board {
namespace {

constexpr std::uint32_t kControl = 0xE000E010;
constexpr std::uint32_t kReload = 0xE000E014;
constexpr std::uint32_t kCurrent = 0xE000E018;  // any write clears it
constexpr std::uint32_t kEnable = 1U << 0, kInterrupt = 1U << 1, kProcessorClock = 1U << 2;
constexpr std::uint32_t kMaxCycles = 1U << 24;

constexpr std::uint32_t kInterruptControl = 0xE000ED04;
constexpr std::uint32_t kTickPending = 1U << 26, kClearTick = 1U << 25;

/// Starts to count `cycles`, and clears a pending tick.
void count_from_now(std::uint32_t cycles) {
  asm volatile("cpsid i" ::: "memory");
  register_at(kControl) = 0;
  register_at(kReload) = cycles > 1 ? cycles - 1 : 1;  // a reload value of 0 would never tick
  register_at(kCurrent) = 0;
  register_at(kInterruptControl) = kClearTick;
  register_at(kControl) = kEnable | kInterrupt | kProcessorClock;
}

}  // namespace

void start_systick(std::uint32_t hertz, std::uint32_t per_second) { count_from_now(hertz / per_second); }

void wait_for_systick() {
  while ((register_at(kInterruptControl) & kTickPending) == 0) asm volatile("wfi" ::: "memory");
  register_at(kInterruptControl) = kClearTick;
}

void SysTickClock::wait(std::uint32_t microseconds) {
  const std::uint32_t control = register_at(kControl), reload = register_at(kReload);
  const std::uint32_t most = kMaxCycles / megahertz_;  // the longest wait in microseconds
  while (microseconds != 0) {
    const std::uint32_t part = microseconds < most ? microseconds : most;
    count_from_now(part * megahertz_);
    wait_for_systick();
    microseconds -= part;
  }
  if ((control & kEnable) != 0) {
    count_from_now(reload + 1);
  } else {
    register_at(kControl) = 0;
  }
}

}  // namespace zstrip::board
