// The machine `virt`: the console is its 16550 UART; the program ends through its test device.
#include "cortex_m/board.hpp"

#include <cstdint>

#include "cortex_m/registers.hpp"
#include "portable/console_input.hpp"

namespace zstrip::board {
namespace {

constexpr std::uintptr_t kUart = 0x10000000;  // registers of one byte; 0 is the data register
constexpr std::uintptr_t kUartLineStatus = 5;
constexpr std::uint8_t kReceived = 1U << 0;
constexpr std::uint8_t kTransmitEmpty = 1U << 5;

constexpr std::uint32_t kTestDevice = 0x00100000;  // "sifive,test": a write ends the machine
constexpr std::uint32_t kPass = 0x5555;
constexpr std::uint32_t kFail = 0x3333;  // exit status in the upper 16 bits

volatile std::uint8_t& byte_at(std::uintptr_t address) { return *reinterpret_cast<volatile std::uint8_t*>(address); }

}  // namespace

void start() {}  // the emulated UART needs no baud rate

void put_character(char character) {
  while ((byte_at(kUart + kUartLineStatus) & kTransmitEmpty) == 0) {
  }
  byte_at(kUart) = static_cast<unsigned char>(character);
}

bool take_character(char& character) {
  if ((byte_at(kUart + kUartLineStatus) & kReceived) == 0) return false;
  const std::uint8_t data = byte_at(kUart);
  character = static_cast<char>(data);
  return true;
}

void halt(int status) {
  register_at(kTestDevice) = status == 0 ? kPass : static_cast<std::uint32_t>(status) << 16 | kFail;
  for (;;) {
  }
}

}  // namespace zstrip::board
