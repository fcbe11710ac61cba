// Ilitek ILI9488: controller of colour panels of 320x480, on a command/data bus. On a serial bus it takes no pixels of
// 16 bits, only of 18 in three bytes, so that a frame is half as much again. Public drivers give a serial clock of at
// most 20 MHz (50 ns a write cycle); modules are commonly run at 40 MHz, at your own risk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/mipi_dcs.hpp"

namespace zstrip::hal {

/// The controller of 320x480 pixels of 18 bits. Takes rgb666 as it is; rgb565_swapped it gets widened, pixel by pixel,
/// while it is sent: then strips take a third less RAM, and colours have 16 bits.
struct Ili9488Controller {
  /// @{
  /// See DcsController.
  static constexpr std::uint16_t kColumns = 320;
  static constexpr std::uint16_t kRows = 480;
  static constexpr bool kHasBrightness = true;
  static constexpr DcsTraits kTraits{.widens_565 = true};
  static constexpr std::uint32_t kId = 0x009488;
  /// Command FBh, SPI read command setting, selects a byte of ID4.
  template <ReadableBus Bus>
  static Error read_id(Bus& bus, std::span<std::byte, 3> id) {
    return read_id4(bus, std::byte{0xFB}, id);
  }
  // The values are those that the makers of modules agree on.
  // clang-format off
  static constexpr auto kSettings = bytes(
      0xE0, 15, 0x00, 0x03, 0x09, 0x08, 0x16, 0x0A, 0x3F, 0x78, 0x4C, 0x09, 0x0A, 0x08, 0x16, 0x1A, 0x0F,
      0xE1, 15, 0x00, 0x16, 0x19, 0x03, 0x0F, 0x05, 0x32, 0x45, 0x46, 0x04, 0x0E, 0x0D, 0x35, 0x37, 0x0F,
      0xC0, 2, 0x17, 0x15,              // power 1: VREG1OUT, VREG2OUT
      0xC1, 1, 0x41,                    // power 2: VGH, VGL
      0xC5, 3, 0x00, 0x12, 0x80,        // VCOM
      0xB0, 1, 0x00,                    // interface: answers on a line of their own
      0xB1, 2, 0xA0, 0x11,              // frame rate 60 Hz
      0xB4, 1, 0x02,                    // inversion by two dots
      0xB6, 3, 0x02, 0x02, 0x3B,        // display function: 480 lines, from the memory
      0xE9, 1, 0x00,                    // no 24 bits on parallel buses
      0xF7, 4, 0xA9, 0x51, 0x2C, 0x82); // adjust control
  // clang-format on

  static constexpr std::uint8_t pixel_format(DisplayFormat format) {
    return format == DisplayFormat::rgb666 || format == DisplayFormat::rgb565_swapped ? 0x66 : 0;
  }
  /// @}
};

/// The usual module of 3.5 inches, upright.
inline constexpr DcsConfig kIli9488Module320x480{
    .width = 320, .height = 480, .format = DisplayFormat::rgb666, .columns_reversed = true, .bgr = true};

/// A panel with the controller ILI9488. `bus` and `clock` must outlive it.
template <CommandDataBus Bus, Clock Time>
class Ili9488 : public DcsPanel<Ili9488Controller, Bus, Time> {
 public:
  /// Sends nothing: start() does.
  constexpr Ili9488(Bus& bus, Time& clock, const DcsConfig& config = kIli9488Module320x480)
      : DcsPanel<Ili9488Controller, Bus, Time>(bus, clock, config) {}
};

}  // namespace zstrip::hal
