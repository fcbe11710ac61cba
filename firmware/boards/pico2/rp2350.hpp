// The RP2350 of the Raspberry Pi Pico 2: registers that the board uses, and functions that differ from the RP2040's.
// Source: RP2350 data sheet; the comments give its chapters.
#pragma once

#include <cstdint>

#include "cortex_m/registers.hpp"
#include "pico/flash_map.hpp"

namespace zstrip::board::rp2350 {

// 7.5, subsystem resets
inline constexpr std::uint32_t kReset = 0x40020000, kResetDone = 0x40020008;
inline constexpr std::uint32_t kResetDma = 1U << 2, kResetIoBank0 = 1U << 6, kResetPadsBank0 = 1U << 9;
inline constexpr std::uint32_t kResetPllSys = 1U << 14, kResetSpi0 = 1U << 18, kResetTimer = 1U << 23;
inline constexpr std::uint32_t kResetUart0 = 1U << 26;

// 8.2, crystal oscillator
inline constexpr std::uint32_t kCrystalControl = 0x40048000, kCrystalStatus = 0x40048004;
inline constexpr std::uint32_t kCrystalStartup = 0x4004800C;
inline constexpr std::uint32_t kCrystalEnable = 0xFABU << 12 | 0xAA0, kCrystalStable = 1U << 31;

// 8.1, clocks
inline constexpr std::uint32_t kReferenceControl = 0x40010030, kReferenceSelected = 0x40010038;
inline constexpr std::uint32_t kReferenceFromCrystal = 2;
inline constexpr std::uint32_t kSystemControl = 0x4001003C, kSystemSelected = 0x40010044;
inline constexpr std::uint32_t kSystemFromAuxiliary = 1;  // the auxiliary source is the PLL, field 0 of bits 7..5
inline constexpr std::uint32_t kPeripheralControl = 0x40010048, kPeripheralEnable = 1U << 11;  // system clock

// 8.6, system PLL
inline constexpr std::uint32_t kPllControl = 0x40050000, kPllPower = 0x40050004, kPllFeedback = 0x40050008;
inline constexpr std::uint32_t kPllPostDividers = 0x4005000C;
inline constexpr std::uint32_t kPllLocked = 1U << 31;
inline constexpr std::uint32_t kPllPowerDown = 1U << 0, kPllPostDividersDown = 1U << 3, kPllVcoDown = 1U << 5;

// 7.4, power-on state machine; 12.9, watchdog; 8.5, its tick
inline constexpr std::uint32_t kWatchdogResets = 0x40018008;
inline constexpr std::uint32_t kAllButOscillators = 0x1FFFFF3;
inline constexpr std::uint32_t kWatchdogControl = 0x400D8000, kWatchdogLoad = 0x400D8004;
inline constexpr std::uint32_t kWatchdogEnable = 1U << 30;
inline constexpr std::uint32_t kWatchdogTick = 0x40108030, kWatchdogTickCycles = 0x40108034, kTickEnable = 1U << 0;

// 12.8, timer 0; 8.5, its tick. Reading the lower word latches the upper one.
inline constexpr std::uint32_t kTimerUpper = 0x400B0008, kTimerLower = 0x400B000C;
inline constexpr std::uint32_t kTimerTick = 0x40108018, kTimerTickCycles = 0x4010801C;

// 3.1.8, platform timer of the RISC-V processors, whose compare register each of them has for itself; 8.5, its tick
inline constexpr std::uint32_t kTime = 0xD00001B0, kTimeUpper = 0xD00001B4;
inline constexpr std::uint32_t kCompare = 0xD00001B8, kCompareUpper = 0xD00001BC;
inline constexpr std::uint32_t kTimeTick = 0x4010803C, kTimeTickCycles = 0x40108040;

// 9.11, GPIO and pads; 3.1, single-cycle IO
constexpr std::uint32_t pin_control(unsigned pin) { return 0x40028004U + 8U * pin; }
constexpr std::uint32_t pad(unsigned pin) { return 0x40038004U + 4U * pin; }
inline constexpr std::uint32_t kFunctionSpi = 1, kFunctionUart = 2, kFunctionSio = 5;
inline constexpr std::uint32_t kPadSchmitt = 1U << 1, kPadPullDown = 1U << 2, kPadPullUp = 1U << 3;
inline constexpr std::uint32_t kPad4Milliamperes = 1U << 4, kPadInput = 1U << 6;
inline constexpr std::uint32_t kPinsSet = 0xD0000018, kPinsClear = 0xD0000020, kPinsEnableOutput = 0xD0000038;

// 12.1, UART 0 (PL011)
inline constexpr std::uint32_t kUart0 = 0x40070000;

// 12.3, SPI 0 (PL022)
inline constexpr std::uint32_t kSpi0 = 0x40080000;

// 12.6, DMA: channel 0
inline constexpr std::uint32_t kDmaRead = 0x50000000, kDmaWrite = 0x50000004;
inline constexpr std::uint32_t kDmaCount = 0x50000008;    // the upper four bits are a mode, 0 here
inline constexpr std::uint32_t kDmaControl = 0x5000000C;  // writing it starts the channel
inline constexpr std::uint32_t kDmaControlOnly = 0x50000010;
inline constexpr std::uint32_t kDmaEnable = 1U << 0, kDmaIncrementRead = 1U << 4;
inline constexpr std::uint32_t kDmaAtSpi0Pace = 24U << 17;  // DREQ_SPI0_TX
inline constexpr std::uint32_t kDmaBusy = 1U << 26, kDmaFaults = 3U << 29;
inline constexpr std::uint32_t kDmaAbort = 0x50000464;

/// Returns the clock of the processor and the peripherals.
constexpr std::uint32_t hertz() { return 150'000'000; }

constexpr const pico::Board& board() { return pico::kPico2; }
constexpr const pico::Board& hot_board() { return pico::kPico2Hot; }

constexpr std::uint32_t watchdog_counts_per_second() { return 1'000'000; }

/// Starts a tick each microsecond from the crystal, for the watchdog.
inline void start_ticks() {
  register_at(kWatchdogTickCycles) = 12;
  register_at(kWatchdogTick) = kTickEnable;
}

/// Starts the tick of the platform timer, each microsecond.
inline void start_time_tick() {
  register_at(kTimeTickCycles) = 12;
  register_at(kTimeTick) = kTickEnable;
}

/// Starts the timer's own tick.
inline void start_timer_tick() {
  register_at(kTimerTickCycles) = 12;
  register_at(kTimerTick) = kTickEnable;
}

// After power-on a pad is isolated from its pin and its input is disabled. It is connected after the pin has its
// function. An input is pulled up, like an idle serial line: with a pull-down it would stay at 2 V (RP2350-E9).
inline void connect_output(unsigned pin) { register_at(pad(pin)) = kPad4Milliamperes | kPadPullDown | kPadSchmitt; }
inline void connect_input(unsigned pin) {
  register_at(pad(pin)) = kPadInput | kPad4Milliamperes | kPadPullUp | kPadSchmitt;
}

/// Call it before a channel is aborted: an enabled channel could start again (RP2350-E5).
inline void disable_dma() { register_at(kDmaControlOnly) = register_at(kDmaControlOnly) & ~kDmaEnable; }

}  // namespace zstrip::board::rp2350
