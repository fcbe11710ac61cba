// Where the RP2350 has the registers that the Pico 2's program uses. Source: pico-sdk, src/rp2350/hardware_regs; not
// the program's own numbers.
#pragma once

#include <cstdint>

namespace zstrip::pico2 {

inline constexpr std::uint32_t kReset = 0x40020000, kResetDone = 0x40020008;
inline constexpr std::uint32_t kXoscCtrl = 0x40048000, kXoscStatus = 0x40048004, kXoscStartup = 0x4004800C;
inline constexpr std::uint32_t kRefCtrl = 0x40010030, kRefSelected = 0x40010038;
inline constexpr std::uint32_t kSysCtrl = 0x4001003C, kSysSelected = 0x40010044, kPeriCtrl = 0x40010048;
inline constexpr std::uint32_t kPllCs = 0x40050000, kPllPwr = 0x40050004, kPllFbdiv = 0x40050008, kPllPrim = 0x4005000C;
inline constexpr std::uint32_t kWdsel = 0x40018008, kWatchdogCtrl = 0x400D8000, kWatchdogLoad = 0x400D8004;
inline constexpr std::uint32_t kTickCtrl = 0x40108030, kTickCycles = 0x40108034;
inline constexpr std::uint32_t kTimerUpper = 0x400B0008, kTimerLower = 0x400B000C;
inline constexpr std::uint32_t kTimerTickCtrl = 0x40108018, kTimerTickCycles = 0x4010801C;
inline constexpr std::uint32_t kSioSet = 0xD0000018, kSioClear = 0xD0000020, kSioEnable = 0xD0000038;
inline constexpr std::uint32_t kUart = 0x40070000, kUartFlags = kUart + 0x18, kUartInteger = kUart + 0x24;
inline constexpr std::uint32_t kUartFraction = kUart + 0x28, kUartLine = kUart + 0x2C, kUartCtrl = kUart + 0x30;
inline constexpr std::uint32_t kSpi = 0x40080000, kSpiCr1 = kSpi + 4, kSpiDr = kSpi + 8, kSpiSr = kSpi + 0xC;
inline constexpr std::uint32_t kSpiCpsr = kSpi + 0x10, kSpiDmacr = kSpi + 0x24;
inline constexpr std::uint32_t kDma = 0x50000000, kDmaWrite = kDma + 4, kDmaCount = kDma + 8, kDmaTrigger = kDma + 0xC;
inline constexpr std::uint32_t kDmaAlias = kDma + 0x10, kDmaAbort = kDma + 0x464;
constexpr std::uint32_t function_of(unsigned pin) { return 0x40028004 + 8 * pin; }
constexpr std::uint32_t pad_of(unsigned pin) { return 0x40038004 + 4 * pin; }

}  // namespace zstrip::pico2
