// Registers of the STM32F405 and STM32F407 that the boards use, except SPI, USART and watchdog, which other families
// also have. Source: RM0090; the comments give its chapters. docs/hardware-review.md lists the sources against which
// each register was checked.
#pragma once

#include <cstdint>

namespace zstrip::board::stm32 {

// RCC, 7.3. Ports A.. are bits 0.. of AHB1.
inline constexpr std::uint32_t kClockControl = 0x40023800;
inline constexpr std::uint32_t kHseOn = 1U << 16, kHseReady = 1U << 17, kPllOn = 1U << 24, kPllReady = 1U << 25;
inline constexpr std::uint32_t kPllConfig = 0x40023804;
inline constexpr std::uint32_t kPllNShift = 6, kPllPShift = 16, kPllFromHse = 1U << 22, kPllQShift = 24;
inline constexpr std::uint32_t kPllReserved = 0xF0BC8000;  // must not be changed
inline constexpr std::uint32_t kClockConfig = 0x40023808;
inline constexpr std::uint32_t kApb1By4 = 5U << 10, kApb2By2 = 4U << 13;
inline constexpr std::uint32_t kUsePll = 2, kUsesPll = 2U << 2, kUsedMask = 3U << 2;
inline constexpr std::uint32_t kAhb1Enable = 0x40023830;
inline constexpr std::uint32_t kAhb1Dma2 = 1U << 22;
inline constexpr std::uint32_t kApb1Enable = 0x40023840;
inline constexpr std::uint32_t kApb1Spi2 = 1U << 14, kApb1Usart2 = 1U << 17, kApb1Power = 1U << 28;
inline constexpr std::uint32_t kApb2Enable = 0x40023844;
inline constexpr std::uint32_t kApb2Usart6 = 1U << 5, kApb2Spi1 = 1U << 12;

// PWR, 5.4.1; FLASH, 3.9.1
inline constexpr std::uint32_t kPowerControl = 0x40007000;
inline constexpr std::uint32_t kVoltageScale1 = 1U << 14;  // above 144 MHz
inline constexpr std::uint32_t kFlashAccess = 0x40023C00;
inline constexpr std::uint32_t kWaitStates5 = 5, kWaitStatesMask = 7;
inline constexpr std::uint32_t kPrefetch = 1U << 8, kInstructionCache = 1U << 9, kDataCache = 1U << 10;

// GPIO, 8.4: two bits a pin of mode and speed, four of the alternate function, eight pins a register
constexpr std::uint32_t gpio_f4(char port) { return 0x40020000U + 0x400U * static_cast<std::uint32_t>(port - 'A'); }
inline constexpr std::uint32_t kGpioMode = 0x00, kGpioSpeed = 0x08, kGpioSetReset = 0x18;
inline constexpr std::uint32_t kGpioAlternateLow = 0x20, kGpioAlternateHigh = 0x24;
inline constexpr std::uint32_t kGpioOutput = 1, kGpioAlternate = 2, kGpioHighSpeed = 2;  // 50 MHz

// DMA2, 10.5; stream 3 with channel 3 is SPI1_TX (10.3.3, table 43)
inline constexpr std::uint32_t kDma2 = 0x40026400;
inline constexpr std::uint32_t kDmaStatusLow = kDma2 + 0x00, kDmaClearLow = kDma2 + 0x08;
inline constexpr std::uint32_t kDmaAllFlags3 = 0x3DU << 22;
inline constexpr std::uint32_t kDmaFaults3 = 1U << 24 | 1U << 25;  // direct mode and transfer; the FIFO is not used
inline constexpr std::uint32_t kDmaComplete3 = 1U << 27;
inline constexpr std::uint32_t kDmaStream3 = kDma2 + 0x10 + 3 * 0x18;
inline constexpr std::uint32_t kDmaConfig3 = kDmaStream3 + 0x00, kDmaCount3 = kDmaStream3 + 0x04;
inline constexpr std::uint32_t kDmaPeripheral3 = kDmaStream3 + 0x08, kDmaMemory3 = kDmaStream3 + 0x0C;
inline constexpr std::uint32_t kDmaEnable = 1U << 0, kDmaFromMemory = 1U << 6, kDmaIncrementMemory = 1U << 10;
inline constexpr std::uint32_t kDmaChannel3 = 3U << 25;

}  // namespace zstrip::board::stm32
