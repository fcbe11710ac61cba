// A panel on an STM32's SPI with a D/C and a select line, polled.
#pragma once

#include <cstddef>
#include <span>

#include "stm32/spi.hpp"
#include "zstrip_hal/bus.hpp"
#include "zstrip_hal/output_pin.hpp"

namespace zstrip::board::stm32 {

/// All bytes have been sent when a function returns. Error::timeout as in SpiMaster::send; the panel is then deselected
/// and the controller is ready again.
template <hal::OutputPin DataCommandPin, hal::OutputPin SelectPin>
class PolledPanelBus {
 public:
  explicit constexpr PolledPanelBus(std::uint32_t spi_address) : spi_(spi_address) {}

  /// See SpiMaster::start(). Call it once, before any other function.
  hal::Error start(std::uint32_t divider) {
    spi_.start(divider);
    return SelectPin().set(true);
  }

  hal::Error write_command(std::span<const std::byte> bytes) { return write(bytes, false); }
  hal::Error write_data(std::span<const std::byte> bytes) { return write(bytes, true); }
  hal::Error wait() { return hal::Error::none; }

 private:
  hal::Error write(std::span<const std::byte> bytes, bool data) {
    hal::Error error = DataCommandPin().set(data);
    if (error == hal::Error::none) error = SelectPin().set(false);
    if (error == hal::Error::none) error = spi_.send(bytes);
    if (error != hal::Error::none) spi_.abort();
    const hal::Error deselected = SelectPin().set(true);
    return error != hal::Error::none ? error : deselected;
  }

  SpiMaster spi_;
};

}  // namespace zstrip::board::stm32
