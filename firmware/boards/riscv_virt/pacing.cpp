// Frame clock: the machine timer, with interrupts masked: a pending interrupt ends WFI also while it is masked. The
// machine has no watchdog. Source: The RISC-V Instruction Set Manual, volume II, 3.2.1 (timer) and 3.3.3 (WFI).
#include "portable/pacing.hpp"

#include <cstdint>

#include "cortex_m/registers.hpp"

namespace zstrip::board {
namespace {

constexpr std::uint32_t kCompare = 0x02004000, kTime = 0x0200BFF8;  // for hart 0; the upper halves follow
constexpr std::uint32_t kTicksPerFrame = 10'000'000 / 60;
std::uint64_t next_tick = 0;

std::uint64_t now() {
  for (;;) {
    const std::uint32_t high = register_at(kTime + 4), low = register_at(kTime);
    if (register_at(kTime + 4) == high) return std::uint64_t{high} << 32 | low;
  }
}

}  // namespace

void start_pacing() {
  constexpr std::uint32_t kTimerInterrupt = 1U << 7;
  asm volatile("csrs mie, %0" ::"r"(kTimerInterrupt));
  next_tick = now() + kTicksPerFrame;
}

void wait_for_tick() {
  // The upper half is at its maximum while the halves do not belong together, so that no tick can occur.
  register_at(kCompare + 4) = 0xFFFFFFFF;
  register_at(kCompare) = static_cast<std::uint32_t>(next_tick);
  register_at(kCompare + 4) = static_cast<std::uint32_t>(next_tick >> 32);
  const bool late = now() >= next_tick;
  while (now() < next_tick) asm volatile("wfi" ::: "memory");
  next_tick = (late ? now() : next_tick) + kTicksPerFrame;
}

void feed_watchdog() {}

}  // namespace zstrip::board
