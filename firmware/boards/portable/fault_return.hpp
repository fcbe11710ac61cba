// From a fault of the processor back to the program that it broke off, which then shows it on its panel. Each
// processor's start-up code defines mark_fault_return().
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace zstrip::board {

/// False now. When a fault comes, and has been reported on the console, the same call returns true: everything that was
/// called since then is gone, and the caller must not have returned. That happens once: a second fault is reported,
/// too, and halts the board, whose watchdog then starts it again. Nothing may be waited for that needs an interrupt (no
/// clock), which leaves polled buses and those with DMA.
extern "C" [[gnu::returns_twice]] bool mark_fault_return();

/// A text about the processor's fault, for console and panel.
class FaultWords {
 public:
  /// Appends `words`, and the bits of `value` from `bits` - 4 down to 0 as hexadecimal digits. Cuts text that does not
  /// fit.
  [[gnu::noinline]] static void add(const char* words, std::uint32_t value, int bits) {
    for (; *words != '\0'; ++words) keep(*words);
    while (bits > 0) {
      bits -= 4;
      keep("0123456789abcdef"[(value >> bits) & 15U]);
    }
  }

  /// No words yet, of a new fault.
  static void clear() { size = 0; }

  /// In static storage.
  static const char* all() { return text.data(); }

 private:
  static void keep(char character) {
    if (size + 1U >= text.size()) return;
    text[size++] = character;
    text[size] = '\0';
  }

  static inline constinit std::array<char, 40> text{};  // ended by a zero
  static inline constinit std::uint32_t size = 0;
};

}  // namespace zstrip::board
