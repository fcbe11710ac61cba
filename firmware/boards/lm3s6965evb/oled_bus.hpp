// The wires to the board's OLED: SSI0 with PC7 as D/C, chip select on PA3, the SD card on the same wires (PD0) kept
// off.
#pragma once

#include <cstddef>
#include <span>

#include "zstrip_hal/bus.hpp"

namespace zstrip::board {

/// SPI mode 0, 8 bits, 3.6 MHz. Polled: everything has been sent when a function returns, so wait() has nothing to do.
/// Error::timeout if the controller takes no byte for about 2 ms; the next transfer first waits as long for what was
/// left.
class OledBus {
 public:
  /// To be called once, before anything else, with the clocks of the ports running.
  void start();

  hal::Error write_command(std::span<const std::byte> bytes);
  hal::Error write_data(std::span<const std::byte> bytes);
  hal::Error wait() { return hal::Error::none; }
};

static_assert(hal::CommandDataBus<OledBus>);

}  // namespace zstrip::board
