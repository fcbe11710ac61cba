// BBC micro:bit: clock and UART of its nRF51822. Source: nRF51 series reference manual.
#include "cortex_m/board.hpp"

#include "cortex_m/registers.hpp"
#include "portable/console_input.hpp"

namespace zstrip::board {
namespace {

constexpr std::uint32_t kStartCrystal = 0x40000000;
constexpr std::uint32_t kCrystalStarted = 0x40000100;

constexpr std::uint32_t kSetDirectionOut = 0x50000518;
constexpr std::uint32_t kSetLevelHigh = 0x50000508;

constexpr std::uint32_t kUart = 0x40002000;
constexpr std::uint32_t kUartStartReceiver = 0x000;
constexpr std::uint32_t kUartStartTransmitter = 0x008;
constexpr std::uint32_t kUartReceived = 0x108;
constexpr std::uint32_t kUartTransmitted = 0x11C;
constexpr std::uint32_t kUartEnable = 0x500;
constexpr std::uint32_t kUartTransmitPin = 0x50C;
constexpr std::uint32_t kUartReceivePin = 0x514;
constexpr std::uint32_t kUartReceiveData = 0x518;
constexpr std::uint32_t kUartTransmitData = 0x51C;
constexpr std::uint32_t kUartBaudRate = 0x524;

// The processor starts on its RC oscillator, which is not exact enough for a UART. If the crystal does not start, the
// program continues: a console with a wrong baud rate is better than none.
void start_crystal() {
  register_at(kCrystalStarted) = 0;
  register_at(kStartCrystal) = 1;
  constexpr int kPolls = 20'000;  // it takes about a millisecond
  for (int poll = 0; poll < kPolls && register_at(kCrystalStarted) == 0; ++poll) {
  }
}

void start_uart() {
  constexpr std::uint32_t kPin = 24, kInput = 25;  // connected to the board's USB interface
  register_at(kSetLevelHigh) = 1U << kPin;
  register_at(kSetDirectionOut) = 1U << kPin;
  register_at(kUart + kUartTransmitPin) = kPin;
  register_at(kUart + kUartReceivePin) = kInput;
  register_at(kUart + kUartBaudRate) = 0x01D7E000;  // 115200
  register_at(kUart + kUartEnable) = 4;
  register_at(kUart + kUartStartTransmitter) = 1;
  register_at(kUart + kUartStartReceiver) = 1;
}

}  // namespace

void start() {
  start_crystal();
  start_uart();
}

void put_character(char character) {
  register_at(kUart + kUartTransmitted) = 0;
  register_at(kUart + kUartTransmitData) = static_cast<unsigned char>(character);
  while (register_at(kUart + kUartTransmitted) == 0) {
  }
}

bool take_character(char& character) {
  if (register_at(kUart + kUartReceived) == 0) return false;
  register_at(kUart + kUartReceived) = 0;
  const std::uint32_t data = register_at(kUart + kUartReceiveData);
  character = static_cast<char>(data);
  return true;
}

void halt(int) {
  for (;;) asm volatile("wfi");
}

}  // namespace zstrip::board
