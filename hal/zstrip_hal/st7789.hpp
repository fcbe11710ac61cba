// Sitronix ST7789V: controller of colour panels up to 240x320, most of them IPS, on a command/data bus. Serial clock up
// to 15 MHz by the data sheet (66 ns a write cycle); modules are commonly run at 40 MHz and more, at your own risk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/mipi_dcs.hpp"

namespace zstrip::hal {

/// The controller of 240x320 pixels, 12, 16 or 18 bits each.
struct St7789Controller {
  /// @{
  /// See DcsController.
  static constexpr std::uint16_t kColumns = 240;
  static constexpr std::uint16_t kRows = 320;
  static constexpr bool kHasBrightness = true;
  static constexpr std::uint32_t kId = 0x858552;
  template <ReadableBus Bus>
  static Error read_id(Bus& bus, std::span<std::byte, 3> id) {
    return read_display_id(bus, id);
  }
  static constexpr auto kSettings = bytes();  // the values after a reset suit these panels

  /// COLMOD: the upper digit sets the RGB interface, the lower digit the serial bus.
  static constexpr std::uint8_t pixel_format(DisplayFormat format) {
    switch (format) {
      case DisplayFormat::rgb444: return 0x53;
      case DisplayFormat::rgb565_swapped: return 0x55;
      case DisplayFormat::rgb666: return 0x66;
      default: return 0;
    }
  }
  /// @}
};

/// The usual module of 240x240: IPS, the glass in the first 240 rows of the memory. For 240x320 set `height`; 135x240
/// has column_offset 52 and row_offset 40, 170x320 column_offset 35.
inline constexpr DcsConfig kSt7789Module240x240{.width = 240, .height = 240, .inverted = true};

/// A panel with the controller ST7789. `bus` and `clock` must outlive it.
template <CommandDataBus Bus, Clock Time>
class St7789 : public DcsPanel<St7789Controller, Bus, Time> {
 public:
  /// Sends nothing: start() does.
  constexpr St7789(Bus& bus, Time& clock, const DcsConfig& config = kSt7789Module240x240)
      : DcsPanel<St7789Controller, Bus, Time>(bus, clock, config) {}
};

}  // namespace zstrip::hal
