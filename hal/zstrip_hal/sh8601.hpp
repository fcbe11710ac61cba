// Sino Wealth SH8601: controller of AMOLED panels of 368x448, on QSPI (qspi.hpp). Serial clock up to 50 MHz (20 ns a
// write cycle). Windows begin and end at even columns and rows. The picture can be mirrored left to right, but neither
// be on its side nor upside down.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/mipi_dcs.hpp"

namespace zstrip::hal {

/// The controller, with pixels of 16 bits. It answers no id here.
struct Sh8601Controller {
  /// @{
  /// See DcsController.
  static constexpr std::uint16_t kColumns = 368;
  static constexpr std::uint16_t kRows = 448;
  static constexpr bool kHasBrightness = true;
  static constexpr std::uint32_t kId = 0;
  static constexpr DcsTraits kTraits{
      .even_areas = true, .exchanges = false, .reverses_rows = false, .brightness_control = 0x20};
  static constexpr auto kSettings = bytes(0x53, 1, 0x20, 0x51, 1, 0xFF);  // brightness by command, and the brightest

  static constexpr std::uint8_t pixel_format(DisplayFormat format) {
    return format == DisplayFormat::rgb565_swapped ? 0x55 : 0;
  }
  /// @}
};

/// The usual module of 1.8 inches.
inline constexpr DcsConfig kSh8601Module368x448{.width = 368, .height = 448};

/// A panel with the controller SH8601; areas have even edges, else Error::alignment. `bus` and `clock` must outlive it.
template <CommandDataBus Bus, Clock Time>
class Sh8601 : public DcsPanel<Sh8601Controller, Bus, Time> {
 public:
  static constexpr std::uint16_t kRowStep = 2;  ///< rows of a strip are a multiple of this

  /// Sends nothing: start() does.
  constexpr Sh8601(Bus& bus, Time& clock, const DcsConfig& config = kSh8601Module368x448)
      : DcsPanel<Sh8601Controller, Bus, Time>(bus, clock, config) {}
};

}  // namespace zstrip::hal
