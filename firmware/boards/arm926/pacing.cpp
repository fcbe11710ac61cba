// Frame clock: timer 0 (SP804) through the vectored interrupt controller (PL190), with interrupts masked in the
// processor: a pending interrupt ends the wait for interrupt also while it is masked. QEMU's machine has no watchdog.
// Sources: Dual-Timer Module (SP804), PrimeCell VIC (PL190) and ARM926EJ-S technical reference manuals.
#include "portable/pacing.hpp"

#include "cortex_m/registers.hpp"

namespace zstrip::board {
namespace {

constexpr std::uint32_t kTimer = 0x101E2000;
constexpr std::uint32_t kLoad = 0x00, kControl = 0x08, kClear = 0x0C, kRawStatus = 0x10;
constexpr std::uint32_t kEnable = 1U << 7, kPeriodic = 1U << 6, kInterrupt = 1U << 5, k32Bits = 1U << 1;
constexpr std::uint32_t kVicEnable = 0x10140010, kTimerLine = 1U << 4;
constexpr std::uint32_t kTicksPerFrame = 1'000'000 / 60;  // the timer counts microseconds

}  // namespace

void start_pacing() {
  register_at(kTimer + kControl) = 0;
  register_at(kTimer + kLoad) = kTicksPerFrame;
  register_at(kTimer + kClear) = 1;
  register_at(kTimer + kControl) = kEnable | kPeriodic | kInterrupt | k32Bits;
  register_at(kVicEnable) = kTimerLine;
}

void wait_for_tick() {
  while ((register_at(kTimer + kRawStatus) & 1U) == 0) {
    asm volatile("mcr p15, 0, %0, c7, c0, 4" ::"r"(0) : "memory");
  }
  register_at(kTimer + kClear) = 1;
}

void feed_watchdog() {}

}  // namespace zstrip::board
