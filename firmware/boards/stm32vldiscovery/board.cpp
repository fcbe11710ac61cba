// STM32VLDISCOVERY: UART of its STM32F100RB, on the internal oscillator of 8 MHz. Source: reference manual RM0041.
#include "cortex_m/board.hpp"

#include "cortex_m/registers.hpp"

namespace zstrip::board {
namespace {

constexpr std::uint32_t kClockEnableApb2 = 0x40021018;
constexpr std::uint32_t kGateGpioA = 1U << 2;
constexpr std::uint32_t kGateUsart1 = 1U << 14;

constexpr std::uint32_t kGpioAConfigHigh = 0x40010804;  // four bits a pin, from PA8 on

constexpr std::uint32_t kUsart1 = 0x40013800;
constexpr std::uint32_t kUsartStatus = 0x00;
constexpr std::uint32_t kTransmitEmpty = 1U << 7;
constexpr std::uint32_t kUsartData = 0x04;
constexpr std::uint32_t kUsartBaudRate = 0x08;
constexpr std::uint32_t kUsartControl1 = 0x0C;
constexpr std::uint32_t kTransmitEnable = 1U << 3;
constexpr std::uint32_t kUsartEnable = 1U << 13;

}  // namespace

void start() {
  register_at(kClockEnableApb2) = register_at(kClockEnableApb2) | kGateGpioA | kGateUsart1;
  constexpr std::uint32_t kPin9 = 4, kAlternateOutput = 0x9;  // push-pull, 10 MHz
  register_at(kGpioAConfigHigh) = (register_at(kGpioAConfigHigh) & ~(0xFU << kPin9)) | kAlternateOutput << kPin9;
  register_at(kUsart1 + kUsartBaudRate) = 69;  // 8 MHz / 115200
  register_at(kUsart1 + kUsartControl1) = kUsartEnable | kTransmitEnable;
}

void put_character(char character) {
  while ((register_at(kUsart1 + kUsartStatus) & kTransmitEmpty) == 0) {
  }
  register_at(kUsart1 + kUsartData) = static_cast<unsigned char>(character);
}

void halt(int) {
  for (;;) asm volatile("wfi");
}

}  // namespace zstrip::board
