// The independent watchdog of STM32F1 and STM32F4, which has its own oscillator. Sources: RM0041, chapter 18; RM0090,
// chapter 21.
#pragma once

#include <cstdint>

#include "cortex_m/registers.hpp"

namespace zstrip::board::stm32 {

inline constexpr std::uint32_t kWatchdogKey = 0x40003000;

/// The board resets itself if feed_independent_watchdog() is not called for about eight seconds: the oscillator has 17
/// to 60 kHz, so that it may be 4.4 or 15.4 s. Cannot be stopped.
inline void start_independent_watchdog() {
  constexpr std::uint32_t kPrescaler = 0x40003004, kReload = 0x40003008, kStatus = 0x4000300C;
  constexpr std::uint32_t kUnlock = 0x5555, kStart = 0xCCCC, kBy64 = 4;
  register_at(kWatchdogKey) = kStart;  // also starts the oscillator
  register_at(kWatchdogKey) = kUnlock;
  register_at(kPrescaler) = kBy64;
  register_at(kReload) = 0xFFF;
  // Both values take some cycles of the oscillator to arrive; until then the watchdog counts with smaller ones.
  constexpr int kPolls = 100'000;
  for (int poll = 0; poll < kPolls && register_at(kStatus) != 0; ++poll) {
  }
  register_at(kWatchdogKey) = 0xAAAA;
}

inline void feed_independent_watchdog() { register_at(kWatchdogKey) = 0xAAAA; }

}  // namespace zstrip::board::stm32
