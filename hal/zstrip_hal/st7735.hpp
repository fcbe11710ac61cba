// Sitronix ST7735R and ST7735S: controllers of colour panels up to 132x162, on a command/data bus. Serial clock up to
// 15 MHz (66 ns a write cycle).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/mipi_dcs.hpp"

namespace zstrip::hal {

/// For pins GM1 and GM0 at 00: the memory has 132x162 pixels.
struct St7735Controller {
  /// @{
  /// See DcsController.
  static constexpr std::uint16_t kColumns = 132;
  static constexpr std::uint16_t kRows = 162;
  static constexpr bool kHasBrightness = false;
  static constexpr std::uint32_t kId = 0x7C89F0;  // of an ST7735S; in an ST7735R the module's maker stores the id
  template <ReadableBus Bus>
  static Error read_id(Bus& bus, std::span<std::byte, 3> id) {
    return read_display_id(bus, id);
  }
  // Panel function commands; the values are those that the makers of modules agree on.
  // clang-format off
  static constexpr auto kSettings = bytes(
      0xB1, 3, 0x01, 0x2C, 0x2D,                    // frame rate, normal
      0xB2, 3, 0x01, 0x2C, 0x2D,                    // idle
      0xB3, 6, 0x01, 0x2C, 0x2D, 0x01, 0x2C, 0x2D,  // partial
      0xB4, 1, 0x07,                                // inversion by dots
      0xC0, 3, 0xA2, 0x02, 0x84,                    // GVDD
      0xC1, 1, 0xC5,                                // VGH, VGL
      0xC2, 2, 0x0A, 0x00,                          // current of the amplifiers, normal
      0xC3, 2, 0x8A, 0x2A,                          // idle
      0xC4, 2, 0x8A, 0xEE,                          // partial
      0xC5, 1, 0x0E,                                // VCOM
      0xE0, 16, 0x02, 0x1C, 0x07, 0x12, 0x37, 0x32, 0x29, 0x2D, 0x25, 0x29, 0x2B, 0x39, 0x00, 0x01, 0x03, 0x10,
      0xE1, 16, 0x03, 0x1D, 0x07, 0x06, 0x2E, 0x2C, 0x29, 0x2D, 0x2E, 0x2E, 0x37, 0x3F, 0x00, 0x00, 0x02, 0x10);
  // clang-format on

  static constexpr std::uint8_t pixel_format(DisplayFormat format) {
    switch (format) {
      case DisplayFormat::rgb444: return 0x03;
      case DisplayFormat::rgb565_swapped: return 0x05;
      case DisplayFormat::rgb666: return 0x06;
      default: return 0;
    }
  }
  /// @}
};

/// For pins GM1 and GM0 at 11: 128x160 pixels, without offsets.
struct St7735Gm11Controller : St7735Controller {
  /// @{
  /// See DcsController.
  static constexpr std::uint16_t kColumns = 128;
  static constexpr std::uint16_t kRows = 160;
  /// @}
};

/// For the pins' setting of modules with 128x128 pixels: rows that are counted from the bottom begin at row 131, not
/// 161. Public drivers have these numbers.
struct St7735Rows132Controller : St7735Controller {
  /// @{
  /// See DcsController.
  static constexpr std::uint16_t kRows = 132;
  /// @}
};

/// 128x160 in the middle of 132x162 ("green tab"). Modules of 80x160 need width 80, column_offset 26, bgr and inverted.
inline constexpr DcsConfig kSt7735Module128x160{
    .width = 128, .height = 160, .column_offset = 2, .row_offset = 1, .columns_reversed = true, .rows_reversed = true};

/// The usual module of 1.44 inches, for St7735Rows132Controller.
inline constexpr DcsConfig kSt7735Module128x128{.width = 128,
                                                .height = 128,
                                                .column_offset = 2,
                                                .row_offset = 3,
                                                .columns_reversed = true,
                                                .rows_reversed = true,
                                                .bgr = true};

/// A panel with the controller ST7735. `bus` and `clock` must outlive it.
template <CommandDataBus Bus, Clock Time, DcsController Controller = St7735Controller>
class St7735 : public DcsPanel<Controller, Bus, Time> {
 public:
  /// Sends nothing: start() does.
  constexpr St7735(Bus& bus, Time& clock, const DcsConfig& config = kSt7735Module128x160)
      : DcsPanel<Controller, Bus, Time>(bus, clock, config) {}
};

}  // namespace zstrip::hal
