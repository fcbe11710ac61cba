// Paints the stack, to measure how much of it was ever used, and guards it, so that an overflow is a fault.
#pragma once

#include <cstdint>

#include "cortex_m/registers.hpp"

namespace zstrip::board {

extern "C" std::uint32_t stack_bottom[], stack_top[];  // set by the linker script

inline constexpr std::uint32_t kStackPaint = 0xDEADBEEF;

/// Paints all memory below the caller's frame. Always inlined: its own frame would lie in the painted part.
[[gnu::always_inline]] inline void paint_stack() {
  std::uint32_t* end;
#if defined(__riscv)
  asm volatile("mv %0, sp" : "=r"(end));
#else
  asm volatile("mov %0, sp" : "=r"(end));
#endif
  for (volatile std::uint32_t* word = stack_bottom; word != end; ++word) *word = kStackPaint;
}

/// Bytes of the guard, at the bottom of the stack.
inline constexpr std::uint32_t kStackGuardBytes = 256;

/// Makes the bottom of the stack read-only with the memory protection unit, if the processor has one: a write there
/// faults. (The RAM ends below it, but not every bus reports that.) On Armv8-M it sets the limit of the stack pointer
/// instead.
inline void guard_stack() {
#if __ARM_ARCH_7M__ || __ARM_ARCH_7EM__
  constexpr std::uint32_t kControl = 0xE000ED94, kNumber = 0xE000ED98, kBase = 0xE000ED9C, kAttributes = 0xE000EDA0;
  constexpr std::uint32_t kNeverExecute = 1U << 28, kReadOnly = 5U << 24, kSize = 7U << 1, kEnable = 1U << 0;
  static_assert(kStackGuardBytes == 1U << 8, "the size field is log2(size) - 1");
  register_at(kNumber) = 0;
  register_at(kBase) = reinterpret_cast<std::uintptr_t>(stack_bottom);
  register_at(kAttributes) = kNeverExecute | kReadOnly | kSize | kEnable;
  constexpr std::uint32_t kDefaultMapElsewhere = 1U << 2;
  register_at(kControl) = kDefaultMapElsewhere | kEnable;
  asm volatile("dsb\n\tisb" ::: "memory");
#elif __ARM_ARCH_8M_MAIN__ || __ARM_ARCH_8_1M_MAIN__
  asm volatile("msr msplim, %0" : : "r"(stack_bottom + kStackGuardBytes / 4));
#endif
}

/// Returns the bytes between the top of the stack and the deepest word that was ever written.
inline std::uint32_t stack_bytes_used() {
  const volatile std::uint32_t* word = stack_bottom;
  while (word != stack_top && *word == kStackPaint) ++word;
  return static_cast<std::uint32_t>((stack_top - const_cast<const std::uint32_t*>(word))) * 4U;
}

}  // namespace zstrip::board
