// TIMER0 of the nRF51822, with interrupts masked: a pending interrupt ends WFI also while it is masked. Source: nRF51
// series reference manual, chapter 18. RTC0 would use less current, but counts at 32768 Hz, and no emulator has it.
#include "microbit/timer.hpp"

#include "cortex_m/registers.hpp"
#include "portable/pacing.hpp"

namespace zstrip::board {
namespace {

constexpr std::uint32_t kTimer = 0x40008000;
constexpr std::uint32_t kStart = 0x000, kCapture1 = 0x044, kCompared0 = 0x140;
constexpr std::uint32_t kInterruptSet = 0x304, kInterruptCompare0 = 1U << 16;
constexpr std::uint32_t kBitMode = 0x508, k32Bits = 3, kPrescaler = 0x510, kMicroseconds = 4;  // 16 MHz / 2^4
constexpr std::uint32_t kCompare0 = 0x540, kCompare1 = 0x544;

constexpr std::uint32_t kInterruptEnable = 0xE000E100, kInterruptClear = 0xE000E280, kTimerInterrupt = 1U << 8;

constexpr std::uint32_t kFrameTime = 50'000;  // us; sending to the bit-banged panel takes longer
std::uint32_t next_tick = 0;

std::uint32_t now() {
  register_at(kTimer + kCapture1) = 1;
  return register_at(kTimer + kCompare1);
}

void sleep_until(std::uint32_t time) {
  register_at(kTimer + kCompared0) = 0;
  register_at(kInterruptClear) = kTimerInterrupt;
  register_at(kTimer + kCompare0) = time;
  // The comparison is set before the time is read: an event after that read is pending, so that WFI returns.
  while (static_cast<std::int32_t>(time - now()) > 0) asm volatile("wfi" ::: "memory");
}

}  // namespace

void start_timer() {
  asm volatile("cpsid i" ::: "memory");
  register_at(kTimer + kBitMode) = k32Bits;
  register_at(kTimer + kPrescaler) = kMicroseconds;
  register_at(kTimer + kInterruptSet) = kInterruptCompare0;
  register_at(kInterruptEnable) = kTimerInterrupt;
  register_at(kTimer + kStart) = 1;
}

void TimerClock::wait(std::uint32_t microseconds) { sleep_until(now() + microseconds + 1); }

// The watchdog, chapter 24: counts at 32768 Hz, also while the processor sleeps.
void start_pacing() {
  constexpr std::uint32_t kWatchdog = 0x40010000, kWatchdogStart = 0x000;
  constexpr std::uint32_t kReloadValue = 0x504, kReloadEnable = 0x508, kConfig = 0x50C, kRunsInSleep = 1;
  register_at(kWatchdog + kConfig) = kRunsInSleep;
  register_at(kWatchdog + kReloadValue) = 8 * 32768;  // 8 s: several frames
  register_at(kWatchdog + kReloadEnable) = 1;
  register_at(kWatchdog + kWatchdogStart) = 1;
  next_tick = now() + kFrameTime;
}

void wait_for_tick() {
  if (static_cast<std::int32_t>(next_tick - now()) > 0) {
    sleep_until(next_tick);
    next_tick += kFrameTime;
  } else {
    next_tick = now() + kFrameTime;
  }
}

void feed_watchdog() {
  constexpr std::uint32_t kReloadRequest = 0x40010600, kReload = 0x6E524635;
  register_at(kReloadRequest) = kReload;
}

}  // namespace zstrip::board
