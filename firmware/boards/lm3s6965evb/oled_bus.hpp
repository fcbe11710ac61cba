// The wires to the board's OLED: SSI0, with PC7 as D/C and PA3 as chip select. The SD card on the same wires is kept
// deselected (PD0).
#pragma once

#include <cstddef>
#include <span>

#include "zstrip_hal/bus.hpp"

namespace zstrip::board {

/// SPI mode 0, 8 bits, 3.6 MHz. Polled: all bytes have been sent when a function returns, so wait() has nothing to do.
/// Error::timeout if the controller takes no byte for about 2 ms; the next transfer first waits as long for the
/// remaining bytes.
class OledBus {
 public:
  /// Call it once, before any other function, when the clocks of the ports run.
  void start();

  hal::Error write_command(std::span<const std::byte> bytes);
  hal::Error write_data(std::span<const std::byte> bytes);
  hal::Error wait() { return hal::Error::none; }
};

static_assert(hal::CommandDataBus<OledBus>);

}  // namespace zstrip::board
