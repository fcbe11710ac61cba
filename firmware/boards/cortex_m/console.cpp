// Writes text and numbers to the board's console, without printf.
#include "cortex_m/console.hpp"

#include "cortex_m/board.hpp"

namespace zstrip::board {

void print(const char* text) {
  while (*text != '\0') put_character(*text++);
}

void print_decimal(std::uint64_t value) {
  char digits[21];
  char* next = digits + sizeof digits - 1;
  *next = '\0';
  do {
    *--next = static_cast<char>('0' + value % 10);
    value /= 10;
  } while (value != 0);
  print(next);
}

void print_hex(std::uint32_t value) {
  for (int shift = 28; shift >= 0; shift -= 4) put_character("0123456789abcdef"[(value >> shift) & 15U]);
}

}  // namespace zstrip::board
