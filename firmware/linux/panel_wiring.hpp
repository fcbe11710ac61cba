// The wiring of a panel on a Linux machine, from an address: the bus, D/C, reset and backlight.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "display_address.hpp"
#include "zstrip_hal/bit_banged_spi.hpp"
#include "zstrip_hal_linux/gpio.hpp"
#include "zstrip_hal_linux/i2cdev.hpp"
#include "zstrip_hal_linux/spidev.hpp"

namespace zstrip::panel {

/// The words for lines and bus: either `spidev`, or `clock` and `data` with optional `select` and `miso`, or `i2c`
/// without D/C.
struct PanelWiring {
  /// Takes its keys from the address. Faults: a word is missing, or two exclude each other.
  static hal::Outcome<PanelWiring> take(DisplayAddress& address);

  std::optional<std::string> spidev, clock, data, select, miso, i2c, data_command, reset, backlight;
  std::optional<std::uint32_t> hertz;
  std::uint8_t address = 0x3C;  ///< on I2C

  /// True if a wire carries the panel's answers. With spidev the controller has one.
  bool can_read() const { return spidev || miso; }
};

using BitBangedBus = hal::BitBangedSpi<hal::GpioPin, hal::GpioPin, hal::GpioPin, hal::GpioPin, hal::GpioInput>;

/// Open lines and bus; a line that is not wired is a pin without a line.
struct OpenWiring {
  /// `usual_hertz`: spidev's clock, unless the wiring has another one. Faults name line and device, and the remedy.
  static hal::Outcome<OpenWiring> open(const PanelWiring& wiring, std::uint32_t usual_hertz);

  std::variant<hal::SpidevBus, BitBangedBus, hal::I2cdevBus> bus;
  hal::GpioPin reset;      ///< starts high
  hal::GpioPin backlight;  ///< starts low: off
};

}  // namespace zstrip::panel
