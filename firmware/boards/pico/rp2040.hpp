// The RP2040 of the Raspberry Pi Pico: registers that the board uses, and functions that differ from the RP2350's.
// Source: RP2040 data sheet; the comments give its chapters.
#pragma once

#include <cstdint>

#include "cortex_m/registers.hpp"
#include "pico/flash_map.hpp"

namespace zstrip::board::rp2040 {

// 2.14, subsystem resets
inline constexpr std::uint32_t kReset = 0x4000C000, kResetDone = 0x4000C008;
inline constexpr std::uint32_t kResetDma = 1U << 2, kResetIoBank0 = 1U << 5, kResetPadsBank0 = 1U << 8;
inline constexpr std::uint32_t kResetPllSys = 1U << 12, kResetSpi0 = 1U << 16, kResetTimer = 1U << 21;
inline constexpr std::uint32_t kResetUart0 = 1U << 22;

// 2.16, crystal oscillator
inline constexpr std::uint32_t kCrystalControl = 0x40024000, kCrystalStatus = 0x40024004;
inline constexpr std::uint32_t kCrystalStartup = 0x4002400C;
inline constexpr std::uint32_t kCrystalEnable = 0xFABU << 12 | 0xAA0, kCrystalStable = 1U << 31;

// 2.15, clocks
inline constexpr std::uint32_t kReferenceControl = 0x40008030, kReferenceSelected = 0x40008038;
inline constexpr std::uint32_t kReferenceFromCrystal = 2;
inline constexpr std::uint32_t kSystemControl = 0x4000803C, kSystemSelected = 0x40008044;
inline constexpr std::uint32_t kSystemFromAuxiliary = 1;  // the auxiliary source is the PLL, field 0 of bits 7..5
inline constexpr std::uint32_t kPeripheralControl = 0x40008048, kPeripheralEnable = 1U << 11;  // system clock

// 2.18, system PLL
inline constexpr std::uint32_t kPllControl = 0x40028000, kPllPower = 0x40028004, kPllFeedback = 0x40028008;
inline constexpr std::uint32_t kPllPostDividers = 0x4002800C;
inline constexpr std::uint32_t kPllLocked = 1U << 31;
inline constexpr std::uint32_t kPllPowerDown = 1U << 0, kPllPostDividersDown = 1U << 3, kPllVcoDown = 1U << 5;

// 2.13, power-on state machine; 4.7, watchdog
inline constexpr std::uint32_t kWatchdogResets = 0x40010008;
inline constexpr std::uint32_t kAllButOscillators = 0x1FFFC;
inline constexpr std::uint32_t kWatchdogControl = 0x40058000, kWatchdogLoad = 0x40058004, kWatchdogTick = 0x4005802C;
inline constexpr std::uint32_t kWatchdogEnable = 1U << 30, kTickEnable = 1U << 9;

// 4.6, timer: counts the watchdog's ticks, microseconds. Reading the lower word latches the upper one.
inline constexpr std::uint32_t kTimerUpper = 0x40054008, kTimerLower = 0x4005400C;

// 2.19, GPIO; 2.3.1, single-cycle IO
constexpr std::uint32_t pin_control(unsigned pin) { return 0x40014004U + 8U * pin; }
inline constexpr std::uint32_t kFunctionSpi = 1, kFunctionUart = 2, kFunctionSio = 5;
inline constexpr std::uint32_t kPinsSet = 0xD0000014, kPinsClear = 0xD0000018, kPinsEnableOutput = 0xD0000024;

// 4.2, UART 0 (PL011)
inline constexpr std::uint32_t kUart0 = 0x40034000;

// 4.4, SPI 0 (PL022)
inline constexpr std::uint32_t kSpi0 = 0x4003C000;

// 2.5, DMA: channel 0
inline constexpr std::uint32_t kDmaRead = 0x50000000, kDmaWrite = 0x50000004, kDmaCount = 0x50000008;
inline constexpr std::uint32_t kDmaControl = 0x5000000C;  // writing it starts the channel
inline constexpr std::uint32_t kDmaEnable = 1U << 0, kDmaIncrementRead = 1U << 4;
inline constexpr std::uint32_t kDmaAtSpi0Pace = 16U << 15;  // DREQ_SPI0_TX, 2.5.3.1
inline constexpr std::uint32_t kDmaBusy = 1U << 24, kDmaFaults = 3U << 29;
inline constexpr std::uint32_t kDmaAbort = 0x50000444;

/// Returns the clock of the processor and the peripherals.
constexpr std::uint32_t hertz() { return 125'000'000; }

constexpr const pico::Board& board() { return pico::kPico; }
constexpr const pico::Board& hot_board() { return pico::kPicoHot; }

/// The watchdog counts down by two each microsecond (RP2040-E1), so that 24 bits are 8.3 s.
constexpr std::uint32_t watchdog_counts_per_second() { return 2'000'000; }

/// Starts a tick each microsecond from the crystal, for watchdog and timer.
inline void start_ticks() { register_at(kWatchdogTick) = kTickEnable | 12; }

/// Does nothing: the timer counts the watchdog's ticks.
inline void start_timer_tick() {}

// After a reset, pads are connected and their inputs are enabled.
inline void connect_output(unsigned) {}
inline void connect_input(unsigned) {}

/// Call it before a channel is aborted. Does nothing here.
inline void disable_dma() {}

}  // namespace zstrip::board::rp2040
