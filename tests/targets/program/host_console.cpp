// The console of a host: standard output.
#include <cstdio>

#include "cortex_m/board.hpp"

namespace zstrip::board {

void put_character(char character) { std::putchar(character); }

}  // namespace zstrip::board
