// Text on the board's console.
#pragma once

#include <cstdint>

namespace zstrip::board {

void print(const char* text);
void print_decimal(std::uint64_t value);
void print_hex(std::uint32_t value);  ///< always eight digits, lower case, no prefix

}  // namespace zstrip::board
