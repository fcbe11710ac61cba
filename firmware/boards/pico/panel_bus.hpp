// A panel on SPI0 of the RP2040 or RP2350; data goes by DMA while the processor draws.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/bus.hpp"

namespace zstrip::board {

/// SPI mode 0, 8 bits, 12.5 MHz; pins as in pins.hpp. Commands are polled. wait() gives up after about twice the time
/// that the bytes take; after any error the panel is deselected and the controller empty.
class PanelBus {
 public:
  /// To be called once, before anything else.
  void start();

  hal::Error write_command(std::span<const std::byte> bytes);
  hal::Error write_data(std::span<const std::byte> bytes);
  hal::Error wait();

 private:
  std::uint32_t polls_left_ = 0;
  bool sending_ = false;
};

static_assert(hal::CommandDataBus<PanelBus>);

}  // namespace zstrip::board
