// The SPI of STM32F1 and STM32F4 as a master that only sends. Sources: RM0041, chapter 22; RM0090, chapter 28.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "cortex_m/registers.hpp"
#include "zstrip_hal/error.hpp"

namespace zstrip::board::stm32 {

// Offsets and bits, RM0090, 28.5.
inline constexpr std::uint32_t kSpiControl1 = 0x00;
inline constexpr std::uint32_t kSpiControl2 = 0x04;
inline constexpr std::uint32_t kSpiStatus = 0x08;
inline constexpr std::uint32_t kSpiData = 0x0C;
inline constexpr std::uint32_t kSpiMaster = 1U << 2, kSpiDividerShift = 3, kSpiEnable = 1U << 6;
inline constexpr std::uint32_t kSpiSelectInternal = 3U << 8;  // SSM and SSI: the program drives the select line as a
                                                              // pin
inline constexpr std::uint32_t kSpiTransmitByDma = 1U << 1;   // in control 2
inline constexpr std::uint32_t kSpiTransmitEmpty = 1U << 1, kSpiBusy = 1U << 7;

/// The controller at this address; its clock must run and its pins must be configured. Mode 0, 8 bits, highest first.
class SpiMaster {
 public:
  explicit constexpr SpiMaster(std::uint32_t address) : address_(address) {}

  /// The serial clock is the peripheral's divided by 2^(divider + 1); `divider` 0..7.
  void start(std::uint32_t divider);

  /// Returns when the last bit is sent. Error::timeout if the controller takes no byte within kPolls polls.
  hal::Error send(std::span<const std::byte> bytes);

  /// Waits until the shift register is empty, too.
  hal::Error finish();

  /// Switches the controller off and on. First gives a remaining byte as much time as finish() does, so that it is not
  /// sent with the next transfer.
  void abort();

  std::uint32_t data_register() const { return address_ + kSpiData; }
  void use_dma(bool on) { at(kSpiControl2) = on ? kSpiTransmitByDma : 0; }

  /// Each poll takes at least six cycles: 0.7 ms in total at 160 MHz, 15 ms at 8 MHz. A byte takes at most 256 * 8
  /// cycles.
  static constexpr int kPolls = 20'000;

 private:
  volatile std::uint32_t& at(std::uint32_t offset) { return register_at(address_ + offset); }
  hal::Error wait_for(std::uint32_t mask, std::uint32_t value);

  std::uint32_t address_;
};

}  // namespace zstrip::board::stm32
