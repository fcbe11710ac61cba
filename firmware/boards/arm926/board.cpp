// Arm Versatile/PB: the console is UART 0 (PL011); the program ends through Arm semihosting.
#include "cortex_m/board.hpp"

#include "cortex_m/pl011.hpp"
#include "portable/console_input.hpp"

namespace zstrip::board {
namespace {

using Uart = Pl011<0x101F1000>;

}  // namespace

// 115200 baud at 24 MHz: 24e6 / (16 * 115200) = 13 + 1/64.
void start() { Uart::start(13, 1); }

void put_character(char character) { Uart::put(character); }

bool take_character(char& character) { return Uart::take(character); }

void halt(int status) {
  constexpr std::uint32_t kExitExtended = 0x20;
  constexpr std::uint32_t kApplicationExit = 0x20026;
  std::uint32_t block[2] = {kApplicationExit, static_cast<std::uint32_t>(status)};
  register std::uint32_t operation asm("r0") = kExitExtended;
  register std::uint32_t* argument asm("r1") = block;
  asm volatile("svc 0x123456" : "+r"(operation) : "r"(argument) : "lr", "memory");
  for (;;) {
  }
}

}  // namespace zstrip::board
