// The machine `sim`: console and end of the program are calls of the simulator. The instruction simcall takes the
// number of the call in a2, its arguments in a3 to a5.
#include "cortex_m/board.hpp"

#include <cstdint>

namespace zstrip::board {
namespace {

enum class Call : std::uint32_t { exit = 1, write = 4 };

void call(Call number, std::uint32_t first, const void* second, std::uint32_t third) {
  register std::uint32_t a2 asm("a2") = static_cast<std::uint32_t>(number);
  register std::uint32_t a3 asm("a3") = first;
  register const void* a4 asm("a4") = second;
  register std::uint32_t a5 asm("a5") = third;
  asm volatile("simcall" : "+r"(a2), "+r"(a3) : "r"(a4), "r"(a5) : "memory");
}

}  // namespace

void start() {}

void put_character(char character) {
  constexpr std::uint32_t kStandardOutput = 1;
  call(Call::write, kStandardOutput, &character, 1);
}

void halt(int status) {
  call(Call::exit, static_cast<std::uint32_t>(status), nullptr, 0);
  for (;;) {
  }
}

}  // namespace zstrip::board
