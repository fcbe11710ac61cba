// Arm Versatile/PB: the console on UART 0 (PL011), the end of the program through Arm semihosting.
#include "cortex_m/board.hpp"

#include "cortex_m/registers.hpp"
#include "portable/console_input.hpp"

namespace zstrip::board {
namespace {

constexpr std::uint32_t kUart0 = 0x101F1000;  // offset 0 is the data register
constexpr std::uint32_t kUartFlags = 0x018;
constexpr std::uint32_t kUartReceiveEmpty = 1U << 4;
constexpr std::uint32_t kUartTransmitFull = 1U << 5;
constexpr std::uint32_t kUartBaudInteger = 0x024;
constexpr std::uint32_t kUartBaudFraction = 0x028;  // 64ths
constexpr std::uint32_t kUartLine = 0x02C;
constexpr std::uint32_t kUartControl = 0x030;

}  // namespace

// 115200 baud at 24 MHz: 24e6 / (16 * 115200) = 13 + 1/64.
void start() {
  register_at(kUart0 + kUartBaudInteger) = 13;
  register_at(kUart0 + kUartBaudFraction) = 1;
  register_at(kUart0 + kUartLine) = 0x60;      // 8 bits, no parity, 1 stop bit
  register_at(kUart0 + kUartControl) = 0x301;  // enabled, both directions
}

void put_character(char character) {
  while ((register_at(kUart0 + kUartFlags) & kUartTransmitFull) != 0) {
  }
  register_at(kUart0) = static_cast<unsigned char>(character);
}

bool take_character(char& character) {
  if ((register_at(kUart0 + kUartFlags) & kUartReceiveEmpty) != 0) return false;
  const std::uint32_t data = register_at(kUart0);
  character = static_cast<char>(data);
  return true;
}

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
