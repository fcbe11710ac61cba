// zstrip on the Raspberry Pi Pico SDK 1.5 or 2, by DMA: a bus for zstrip's own drivers of panels, here ST7789.
// Needs the libraries pico_stdlib, hardware_spi and hardware_dma. The program calls spi_init() with the panel's hertz,
// gives the pins of clock and data to the SPI, and makes the other two outputs.
// Format: rgb565_swapped. The DMA counts bytes, as they lie in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <hardware/dma.h>
#include <hardware/spi.h>
#include <pico/stdlib.h>
#include <zstrip_hal/st7789.hpp>

namespace adapters {

struct PicoClock {
  void wait(std::uint32_t microseconds) { sleep_us(microseconds); }
};

/// CommandDataBus of zstrip_hal/bus.hpp.
class PicoSpiDma {
 public:
  using Error = zstrip::hal::Error;

  PicoSpiDma(spi_inst_t* spi, uint data_command_pin, uint select_pin)
      : spi_(spi), data_command_(data_command_pin), select_(select_pin) {}

  /// Call it once, before the panel's start(). Error::bus: all DMA channels are in use.
  Error start() {
    channel_ = dma_claim_unused_channel(false);
    return channel_ >= 0 ? Error::none : Error::bus;
  }

  Error write_command(std::span<const std::byte> bytes) {
    select(false);
    spi_write_blocking(spi_, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    gpio_put(select_, true);
    return Error::none;
  }
  Error write_data(std::span<const std::byte> bytes) {
    if (channel_ < 0) return Error::bus;
    select(true);
    dma_channel_config config = dma_channel_get_default_config(channel());
    channel_config_set_transfer_data_size(&config, DMA_SIZE_8);
    channel_config_set_dreq(&config, spi_get_dreq(spi_, true));
    dma_channel_configure(channel(), &config, &spi_get_hw(spi_)->dr, bytes.data(), static_cast<uint>(bytes.size()),
                          true);
    sending_ = true;
    return Error::none;
  }
  Error wait() {
    constexpr std::uint32_t kTimeout = 1'000'000;  // us
    if (!sending_) return Error::none;
    const std::uint32_t start = time_us_32();
    Error error = Error::none;
    while (error == Error::none && (dma_channel_is_busy(channel()) || spi_is_busy(spi_))) {
      if (time_us_32() - start > kTimeout) error = Error::timeout;
    }
    if (error != Error::none) dma_channel_abort(channel());
    sending_ = false;
    gpio_put(select_, true);
    return error;
  }

 private:
  uint channel() const { return static_cast<uint>(channel_); }
  void select(bool data) {
    gpio_put(data_command_, data);
    gpio_put(select_, false);
  }

  spi_inst_t* spi_;
  uint data_command_, select_;
  int channel_ = -1;
  bool sending_ = false;
};

using PicoPanel = zstrip::hal::St7789<PicoSpiDma, PicoClock>;
static_assert(zstrip::hal::Display<PicoPanel>);

}  // namespace adapters
