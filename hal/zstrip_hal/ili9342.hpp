// Ilitek ILI9342C: controller of colour panels of 320x240, whose glass is wide when it is upright, on a command/data
// bus. Serial clock up to 10 MHz (100 ns a write cycle), as an ILI9341; modules are commonly run at 40 MHz, at your own
// risk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/mipi_dcs.hpp"

namespace zstrip::hal {

/// The controller of 320x240 pixels, 16 or 18 bits each.
struct Ili9342Controller {
  /// @{
  /// See DcsController.
  static constexpr std::uint16_t kColumns = 320;
  static constexpr std::uint16_t kRows = 240;
  static constexpr bool kHasBrightness = true;
  static constexpr std::uint32_t kId = 0x009342;
  /// Reads the id by command D9h, as for an ILI9341.
  template <ReadableBus Bus>
  static Error read_id(Bus& bus, std::span<std::byte, 3> id) {
    return read_id4(bus, std::byte{0xD9}, id);
  }
  // Extended commands; the values are those that the makers of modules agree on.
  // clang-format off
  static constexpr auto kSettings = bytes(
      0xC8, 3, 0xFF, 0x93, 0x42,  // unlock the others
      0xC0, 2, 0x12, 0x12,        // power 1
      0xC1, 1, 0x03,              // power 2
      0xC5, 1, 0xF2,              // VCOM
      0xB0, 1, 0xE0,              // RGB interface, unused
      0xF6, 3, 0x01, 0x00, 0x00,  // interface
      0xE0, 15, 0x00, 0x0C, 0x11, 0x04, 0x11, 0x08, 0x37, 0x89, 0x4C, 0x06, 0x0C, 0x0A, 0x2E, 0x34, 0x0F,
      0xE1, 15, 0x00, 0x0B, 0x11, 0x05, 0x13, 0x09, 0x33, 0x67, 0x48, 0x07, 0x0E, 0x0B, 0x2E, 0x33, 0x0F,
      0xB6, 4, 0x08, 0x82, 0x1D, 0x04);  // display function
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

/// The usual IPS module of 2 inches. TN panels are not inverted.
inline constexpr DcsConfig kIli9342Module320x240{.width = 320, .height = 240, .bgr = true, .inverted = true};

/// A panel with the controller ILI9342C. `bus` and `clock` must outlive it.
template <CommandDataBus Bus, Clock Time>
class Ili9342 : public DcsPanel<Ili9342Controller, Bus, Time> {
 public:
  /// Sends nothing: start() does.
  constexpr Ili9342(Bus& bus, Time& clock, const DcsConfig& config = kIli9342Module320x240)
      : DcsPanel<Ili9342Controller, Bus, Time>(bus, clock, config) {}
};

}  // namespace zstrip::hal
