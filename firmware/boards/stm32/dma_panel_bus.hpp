// A panel on SPI1 of an STM32F405/407 with a D/C and a select line; data goes by DMA while the processor draws.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "stm32/spi.hpp"
#include "zstrip_hal/bus.hpp"
#include "zstrip_hal/output_pin.hpp"

namespace zstrip::board::stm32 {

/// The stream of DMA2 that feeds SPI1.
class SpiDma {
 public:
  static constexpr std::uint32_t kSpi1 = 0x40013000;
  static constexpr std::size_t kMaxBytes = 65'535;  // its counter has 16 bits

  /// Begins to send 1 to kMaxBytes bytes, which must lie in the SRAM at 0x20000000 or in flash: DMA2 cannot access the
  /// core-coupled memory.
  void start(std::span<const std::byte> bytes);
  /// Waits until all bytes have left the memory. Returns Error::timeout, or Error::bus for a fault that the stream
  /// reports; the stream is off in any case.
  hal::Error finish();

 private:
  std::uint32_t polls_left_ = 0;
};

/// Commands are polled. wait() gives up after about twice the time of the transfer, at 10 MHz and more.
template <hal::OutputPin DataCommandPin, hal::OutputPin SelectPin>
class DmaPanelBus {
 public:
  /// See SpiMaster::start(); the clocks of SPI1, DMA2 and the ports must run. Call it once, before any other function.
  hal::Error start(std::uint32_t divider) {
    spi_.start(divider);
    return SelectPin().set(true);
  }

  hal::Error write_command(std::span<const std::byte> bytes) {
    hal::Error error = select(false);
    if (error == hal::Error::none) error = spi_.send(bytes);
    return deselect(error);
  }

  hal::Error write_data(std::span<const std::byte> bytes) {
    const hal::Error selected = select(true);
    if (selected != hal::Error::none || bytes.empty()) return deselect(selected);  // a stream without bytes never ends
    while (bytes.size() > SpiDma::kMaxBytes) {
      begin(bytes.first(SpiDma::kMaxBytes));
      if (const hal::Error error = dma_.finish(); error != hal::Error::none) return deselect(error);
      spi_.use_dma(false);
      bytes = bytes.subspan(SpiDma::kMaxBytes);
    }
    begin(bytes);
    sending_ = true;
    return hal::Error::none;
  }

  hal::Error wait() {
    if (!sending_) return hal::Error::none;
    sending_ = false;
    hal::Error error = dma_.finish();
    if (error == hal::Error::none) error = spi_.finish();
    return deselect(error);
  }

 private:
  /// Starts the stream first, then the SPI's requests; they are switched off in the opposite order (RM0090, 10.3.17).
  void begin(std::span<const std::byte> bytes) {
    dma_.start(bytes);
    spi_.use_dma(true);
  }
  hal::Error select(bool data) {
    const hal::Error error = DataCommandPin().set(data);
    return error != hal::Error::none ? error : SelectPin().set(false);
  }
  /// Returns only the first error.
  hal::Error deselect(hal::Error error) {
    spi_.use_dma(false);
    if (error != hal::Error::none) spi_.abort();
    const hal::Error deselected = SelectPin().set(true);
    return error != hal::Error::none ? error : deselected;
  }

  SpiMaster spi_{SpiDma::kSpi1};
  SpiDma dma_;
  bool sending_ = false;
};

}  // namespace zstrip::board::stm32
