// zstrip on the HAL of STM32Cube, for families whose SPI has HAL_SPI_Transmit(), as F4 and H7: a bus for zstrip's own
// drivers of panels, here ST7789, that blocks (Stm32HalSpi) or sends by DMA (Stm32HalSpiDma).
// Needs main.h of a project of CubeMX, which includes the family's HAL, and an SPI that MX_SPIx_Init() has started:
// master, 8 bits, high bit first, select by software; CPOL low, CPHA 1 edge, or high and 2 edges for a panel without a
// select pin. D/C, select and reset are outputs that start high. DMA needs a request SPIx_TX, memory to peripheral,
// normal, both sides bytes, and the interrupts of that DMA and of the SPI.
// Format: rgb565_swapped. Bytes are sent as they lie in memory. On an H7 DMA reaches no buffer in DTCM: strips lie in
// another RAM, which the linker script says.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <main.h>
#include <zstrip_hal/output_pin.hpp>
#include <zstrip_hal/st7789.hpp>

namespace adapters {

/// An output pin of the HAL: Stm32Pin{GPIOB, GPIO_PIN_6}.
struct Stm32Pin {
  GPIO_TypeDef* port;
  std::uint16_t mask;

  zstrip::hal::Error set(bool high) {
    HAL_GPIO_WritePin(port, mask, high ? GPIO_PIN_SET : GPIO_PIN_RESET);
    return zstrip::hal::Error::none;
  }
};

struct Stm32Clock {
  void wait(std::uint32_t microseconds) { HAL_Delay((microseconds + 999) / 1000); }
};

/// CommandDataBus of zstrip_hal/bus.hpp. All bytes have been sent when a function returns. Error::timeout after 1 s.
class Stm32HalSpi {
 public:
  using Error = zstrip::hal::Error;

  /// `spi` must outlive it.
  Stm32HalSpi(SPI_HandleTypeDef& spi, Stm32Pin data_command, Stm32Pin select)
      : spi_(spi), data_command_(data_command), select_(select) {}

  Error write_command(std::span<const std::byte> bytes) { return send(bytes, false); }
  Error write_data(std::span<const std::byte> bytes) { return send(bytes, true); }
  Error wait() { return Error::none; }

 protected:
  static constexpr std::uint32_t kTimeout = 1000;   // ms
  static constexpr std::size_t kMaxBlock = 0xFFFF;  // the HAL counts in 16 bits

  static Error error_of(HAL_StatusTypeDef status) {
    if (status == HAL_OK) return Error::none;
    return status == HAL_TIMEOUT ? Error::timeout : Error::bus;
  }
  static std::uint16_t block_of(std::span<const std::byte> bytes) {
    return static_cast<std::uint16_t>(bytes.size() < kMaxBlock ? bytes.size() : kMaxBlock);
  }
  /// Older releases do not declare it const, but only read it.
  static std::uint8_t* start_of(std::span<const std::byte> bytes) {
    return const_cast<std::uint8_t*>(reinterpret_cast<const std::uint8_t*>(bytes.data()));
  }

  void select(bool data) {
    (void)data_command_.set(data);
    (void)select_.set(false);
  }
  void deselect() { (void)select_.set(true); }

  SPI_HandleTypeDef& spi_;

 private:
  Error send(std::span<const std::byte> bytes, bool data) {
    select(data);
    Error error = Error::none;
    while (error == Error::none && !bytes.empty()) {
      const std::uint16_t count = block_of(bytes);
      error = error_of(HAL_SPI_Transmit(&spi_, start_of(bytes), count, kTimeout));
      bytes = bytes.subspan(count);
    }
    deselect();
    return error;
  }

  Stm32Pin data_command_, select_;
};

/// Stm32HalSpi that sends data by DMA. If there are more than 65,535 bytes, wait() starts the rest. The handle's state
/// says that a transfer has ended, so that the program can use the HAL's callbacks for itself.
class Stm32HalSpiDma : public Stm32HalSpi {
 public:
  using Stm32HalSpi::Stm32HalSpi;

  Error write_data(std::span<const std::byte> bytes) {
    if (bytes.empty()) return Error::none;
    clean_cache(bytes);
    select(true);
    return start(bytes);
  }
  Error wait() {
    Error error = Error::none;
    while (sending_ && error == Error::none) {
      error = wait_for_block();
      if (error == Error::none && !rest_.empty()) {
        error = start(rest_);
      } else if (sending_) {
        sending_ = false;
        deselect();
      }
    }
    return error;
  }

 private:
  Error start(std::span<const std::byte> bytes) {
    const std::uint16_t count = block_of(bytes);
    rest_ = bytes.subspan(count);
    const Error error = error_of(HAL_SPI_Transmit_DMA(&spi_, start_of(bytes), count));
    sending_ = error == Error::none;
    if (!sending_) deselect();
    return error;
  }

  Error wait_for_block() {
    const std::uint32_t started = HAL_GetTick();
    while (HAL_SPI_GetState(&spi_) != HAL_SPI_STATE_READY) {
      if (HAL_GetTick() - started <= kTimeout) continue;
      (void)HAL_SPI_Abort(&spi_);
      return Error::timeout;
    }
    return HAL_SPI_GetError(&spi_) == HAL_SPI_ERROR_NONE ? Error::none : Error::bus;
  }

  /// Writes the strip from a Cortex-M7's data cache to memory, by whole lines, where a DMA finds it.
  static void clean_cache([[maybe_unused]] std::span<const std::byte> bytes) {
#if defined(__DCACHE_PRESENT) && __DCACHE_PRESENT == 1U
    constexpr std::uintptr_t kLine = 32;
    const auto first = reinterpret_cast<std::uintptr_t>(bytes.data());
    const std::uintptr_t aligned = first & ~(kLine - 1);
    SCB_CleanDCache_by_Addr(reinterpret_cast<std::uint32_t*>(aligned),
                            static_cast<std::int32_t>(first - aligned + bytes.size()));
#endif
  }

  std::span<const std::byte> rest_;
  bool sending_ = false;
};

using Stm32Panel = zstrip::hal::St7789<Stm32HalSpiDma, Stm32Clock>;
using Stm32BlockingPanel = zstrip::hal::St7789<Stm32HalSpi, Stm32Clock>;
static_assert(zstrip::hal::Display<Stm32Panel> && zstrip::hal::Display<Stm32BlockingPanel>);

}  // namespace adapters
