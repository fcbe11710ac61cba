// Arm MPS2: the console is UART 0 (CMSDK); the program ends through semihosting.
#include "cortex_m/board.hpp"

#include "cortex_m/registers.hpp"
#include "cortex_m/semihosting.hpp"

namespace zstrip::board {
namespace {

#if ZSTRIP_MPS2_IMAGE == 547
constexpr std::uint32_t kUart0 = 0x59303000;  // in AN547, secure; offset 0 is the data register
#elif ZSTRIP_MPS2_IMAGE == 505
constexpr std::uint32_t kUart0 = 0x50200000;  // in AN505, secure
#else
constexpr std::uint32_t kUart0 = 0x40004000;  // in AN385, AN386 and AN500
#endif
constexpr std::uint32_t kUartState = 0x004;
constexpr std::uint32_t kUartControl = 0x008;
constexpr std::uint32_t kUartBaudDivider = 0x010;
constexpr std::uint32_t kTransmitFull = 1U << 0;
constexpr std::uint32_t kTransmitEnable = 1U << 0;

}  // namespace

void start() {
  register_at(kUart0 + kUartBaudDivider) = 217;  // 115200 baud at 25 MHz
  register_at(kUart0 + kUartControl) = kTransmitEnable;
}

void put_character(char character) {
  while ((register_at(kUart0 + kUartState) & kTransmitFull) != 0) {
  }
  register_at(kUart0) = static_cast<unsigned char>(character);
}

void halt(int status) { exit_emulator(status); }

}  // namespace zstrip::board
