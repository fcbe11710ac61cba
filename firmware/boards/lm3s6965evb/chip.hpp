// Registers of the LM3S6965 that the board uses. Source: LM3S6965 data sheet.
#pragma once

#include <cstdint>

namespace zstrip::board::chip {

inline constexpr std::uint32_t kClockStatus = 0x400FE050;  // raw interrupt status
inline constexpr std::uint32_t kPllLocked = 1U << 6;
inline constexpr std::uint32_t kClockConfig = 0x400FE060;
inline constexpr std::uint32_t kClockGating0 = 0x400FE100;
inline constexpr std::uint32_t kGateWatchdog = 1U << 3;
inline constexpr std::uint32_t kClockGating1 = 0x400FE104;
inline constexpr std::uint32_t kGateUart0 = 1U << 0;
inline constexpr std::uint32_t kGateSsi0 = 1U << 4;
inline constexpr std::uint32_t kClockGating2 = 0x400FE108;
inline constexpr std::uint32_t kGateGpioA = 1U << 0;
inline constexpr std::uint32_t kGateGpioC = 1U << 2;
inline constexpr std::uint32_t kGateGpioD = 1U << 3;

// SP805
inline constexpr std::uint32_t kWatchdogLoad = 0x40000000;
inline constexpr std::uint32_t kWatchdogControl = 0x40000008;
inline constexpr std::uint32_t kWatchdogInterrupt = 1U << 0;
inline constexpr std::uint32_t kWatchdogReset = 1U << 1;
inline constexpr std::uint32_t kWatchdogClear = 0x4000000C;

// PL011
inline constexpr std::uint32_t kUart0 = 0x4000C000;

// PL061; bits 9..2 of an address of the data register mask the pins that the access touches.
inline constexpr std::uint32_t kGpioA = 0x40004000;
inline constexpr std::uint32_t kGpioC = 0x40006000;
inline constexpr std::uint32_t kGpioD = 0x40007000;
inline constexpr std::uint32_t kGpioDirection = 0x400;
inline constexpr std::uint32_t kGpioAlternate = 0x420;
inline constexpr std::uint32_t kGpioDigital = 0x51C;
constexpr std::uint32_t gpio_pins(std::uint32_t port, std::uint32_t mask) { return port + (mask << 2); }

// PL022
inline constexpr std::uint32_t kSsi0 = 0x40008000;
inline constexpr std::uint32_t kSsiControl0 = 0x000;
inline constexpr std::uint32_t kSsiControl1 = 0x004;
inline constexpr std::uint32_t kSsiOn = 1U << 1;
inline constexpr std::uint32_t kSsiData = 0x008;
inline constexpr std::uint32_t kSsiStatus = 0x00C;
inline constexpr std::uint32_t kSsiTransmitNotFull = 1U << 1;
inline constexpr std::uint32_t kSsiReceiveNotEmpty = 1U << 2;
inline constexpr std::uint32_t kSsiBusy = 1U << 4;
inline constexpr std::uint32_t kSsiPrescale = 0x010;

}  // namespace zstrip::board::chip
