// Sitronix ST7796S: controller of colour panels of 320x480, on a command/data bus. Public drivers give a serial clock
// of at most 15 MHz (66 ns a write cycle); modules are commonly run at 40 MHz and more, at your own risk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/mipi_dcs.hpp"

namespace zstrip::hal {

/// The controller of 320x480 pixels, 16 or 18 bits each.
struct St7796Controller {
  /// @{
  /// See DcsController.
  static constexpr std::uint16_t kColumns = 320;
  static constexpr std::uint16_t kRows = 480;
  static constexpr bool kHasBrightness = true;
  static constexpr std::uint32_t kId = 0x007796;
  /// Read ID4, D3h: a dummy clock, then three bytes.
  template <ReadableBus Bus>
  static Error read_id(Bus& bus, std::span<std::byte, 3> id) {
    return bus.read(std::byte{0xD3}, 1, id);
  }
  // Command table 2; the values are those that the makers of modules agree on.
  // clang-format off
  static constexpr auto kSettings = bytes(
      0xF0, 1, 0xC3,  0xF0, 1, 0x96,  // unlock both parts of the table
      0xB4, 1, 0x01,                  // inversion by dots
      0xB6, 3, 0x80, 0x22, 0x3B,      // display function: 480 lines
      0xE8, 8, 0x40, 0x8A, 0x00, 0x00, 0x29, 0x19, 0xA5, 0x33,  // output timing
      0xC1, 1, 0x06,                  // GVDD, GVCL
      0xC2, 1, 0xA7,                  // current of the amplifiers
      0xC5, 1, 0x18,                  // VCOM
      0xE0, 14, 0xF0, 0x09, 0x0B, 0x06, 0x04, 0x15, 0x2F, 0x54, 0x42, 0x3C, 0x17, 0x14, 0x18, 0x1B,
      0xE1, 14, 0xE0, 0x09, 0x0B, 0x06, 0x04, 0x03, 0x2B, 0x43, 0x42, 0x3B, 0x16, 0x14, 0x17, 0x1B,
      0xF0, 1, 0x3C,  0xF0, 1, 0x69); // lock them again
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

/// The usual module of 3.5 or 4 inches, upright. IPS panels need `inverted`, too.
inline constexpr DcsConfig kSt7796Module320x480{.width = 320, .height = 480, .columns_reversed = true, .bgr = true};

/// A panel with the controller ST7796. `bus` and `clock` must outlive it.
template <CommandDataBus Bus, Clock Time>
class St7796 : public DcsPanel<St7796Controller, Bus, Time> {
 public:
  /// Sends nothing: start() does.
  constexpr St7796(Bus& bus, Time& clock, const DcsConfig& config = kSt7796Module320x480)
      : DcsPanel<St7796Controller, Bus, Time>(bus, clock, config) {}
};

}  // namespace zstrip::hal
