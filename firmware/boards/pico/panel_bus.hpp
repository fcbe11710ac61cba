// A panel on SPI0 of the RP2040 or RP2350; data goes by DMA while the processor draws.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/bus.hpp"

namespace zstrip::board {

/// SPI mode 0, 8 bits, 12.5 MHz; pins as in pins.hpp. Commands are polled. wait() gives up after about twice the time
/// of the transfer; after any error the panel is deselected and the controller is empty.
class PanelBus {
 public:
  /// Call it once, before any other function.
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
