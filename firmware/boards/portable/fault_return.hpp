// Returns from a fault of the processor to the interrupted program, which then shows the fault on its panel. Each
// processor's start-up code defines mark_fault_return().
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace zstrip::board {

/// Returns false. After a fault, which is first reported on the console, the same call returns once more, with true:
/// all functions called since then are abandoned, and the caller must not have returned. A second fault is also
/// reported, and halts the board, whose watchdog then resets it. Afterwards interrupts do not work, and so no clock;
/// only polled buses and buses with DMA do.
extern "C" [[gnu::returns_twice]] bool mark_fault_return();

/// A text about the processor's fault, for console and panel.
class FaultWords {
 public:
  /// Appends `words`, and the bits of `value` from `bits` - 1 to 0 as hexadecimal digits. Cuts text that does not fit.
  [[gnu::noinline]] static void add(const char* words, std::uint32_t value, int bits) {
    for (; *words != '\0'; ++words) keep(*words);
    while (bits > 0) {
      bits -= 4;
      keep("0123456789abcdef"[(value >> bits) & 15U]);
    }
  }

  /// Removes all words, for a new fault.
  static void clear() { size = 0; }

  /// Returns the text, in static storage.
  static const char* all() { return text.data(); }

 private:
  static void keep(char character) {
    if (size + 1U >= text.size()) return;
    text[size++] = character;
    text[size] = '\0';
  }

  static inline constinit std::array<char, 40> text{};  // ends with a zero
  static inline constinit std::uint32_t size = 0;
};

}  // namespace zstrip::board
