// Ilitek ILI9341: controller of colour panels of 240x320, on a command/data bus. The data sheet allows a serial clock
// up to 10 MHz (100 ns a write cycle); modules are commonly run at 40 MHz, at your own risk. The controller has no
// format of 12 bits a pixel on a serial bus.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/mipi_dcs.hpp"

namespace zstrip::hal {

/// The controller of 240x320 pixels, 16 or 18 bits each.
struct Ili9341Controller {
  /// @{
  /// See DcsController.
  static constexpr std::uint16_t kColumns = 240;
  static constexpr std::uint16_t kRows = 320;
  static constexpr bool kHasBrightness = true;
  static constexpr std::uint32_t kId = 0x009341;
  /// Command D9h, which selects a byte of ID4, is not in the data sheet; the libraries of Adafruit and others read
  /// these parts with it.
  template <ReadableBus Bus>
  static Error read_id(Bus& bus, std::span<std::byte, 3> id) {
    return read_id4(bus, std::byte{0xD9}, id);
  }
  // Level 2 commands; the values are those that the makers of modules agree on.
  // clang-format off
  static constexpr auto kSettings = bytes(
      0xB1, 2, 0x00, 0x18,        // frame rate 79 Hz
      0xC0, 1, 0x23,              // GVDD 4.6 V
      0xC1, 1, 0x10,              // AVDD, VGH and VGL by the charge pumps
      0xC5, 2, 0x3E, 0x28,        // VCOMH 4.25 V, VCOML -1.5 V
      0xC7, 1, 0x86,              // offset of both
      0x26, 1, 0x01,              // gamma curve
      0xE0, 15, 0x0F, 0x31, 0x2B, 0x0C, 0x0E, 0x08, 0x4E, 0xF1, 0x37, 0x07, 0x10, 0x03, 0x0E, 0x09, 0x00,
      0xE1, 15, 0x00, 0x0E, 0x14, 0x03, 0x11, 0x07, 0x31, 0xC1, 0x48, 0x08, 0x0F, 0x0C, 0x31, 0x36, 0x0F);
  // clang-format on

  static constexpr std::uint8_t pixel_format(DisplayFormat format) {
    switch (format) {
      case DisplayFormat::rgb565_swapped: return 0x55;
      case DisplayFormat::rgb666: return 0x66;
      default: return 0;
    }
  }
  /// @}
};

/// The usual module of 2.2 to 3.2 inches, upright.
inline constexpr DcsConfig kIli9341Module240x320{.width = 240, .height = 320, .columns_reversed = true, .bgr = true};

/// A panel with the controller ILI9341. `bus` and `clock` must outlive it.
template <CommandDataBus Bus, Clock Time>
class Ili9341 : public DcsPanel<Ili9341Controller, Bus, Time> {
 public:
  /// Sends nothing: start() does.
  constexpr Ili9341(Bus& bus, Time& clock, const DcsConfig& config = kIli9341Module240x320)
      : DcsPanel<Ili9341Controller, Bus, Time>(bus, clock, config) {}
};

}  // namespace zstrip::hal
