// Chipone CO5300: controller of AMOLED panels up to 480 columns, on QSPI (qspi.hpp). Serial clock up to 50 MHz (20 ns a
// write cycle). Windows begin and end at even columns and rows; rows and columns cannot be exchanged, so that the
// picture cannot be on its side.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/mipi_dcs.hpp"

namespace zstrip::hal {

/// The controller, with pixels of 16 bits. It answers no id here.
struct Co5300Controller {
  /// @{
  /// See DcsController.
  static constexpr std::uint16_t kColumns = 480;
  static constexpr std::uint16_t kRows = 502;
  static constexpr bool kHasBrightness = true;
  static constexpr std::uint32_t kId = 0;
  static constexpr DcsTraits kTraits{.even_areas = true, .exchanges = false, .brightness_control = 0x20};
  // clang-format off
  static constexpr auto kSettings = bytes(
      0xFE, 1, 0x00,   // user commands
      0xC4, 1, 0x80,   // pixels by QSPI
      0x53, 1, 0x20,   // brightness by command
      0x51, 1, 0xFF,   // brightness
      0x63, 1, 0xFF);  // brightness in bright light
  // clang-format on

  static constexpr std::uint8_t pixel_format(DisplayFormat format) {
    return format == DisplayFormat::rgb565_swapped ? 0x55 : 0;
  }
  /// @}
};

/// The usual round module of 1.43 or 1.75 inches. Modules of 410x502 have column_offset 22, of 280x456 20.
inline constexpr DcsConfig kCo5300Module466x466{.width = 466, .height = 466, .column_offset = 6};

/// A panel with the controller CO5300; areas have even edges, else Error::alignment. `bus` and `clock` must outlive it.
template <CommandDataBus Bus, Clock Time>
class Co5300 : public DcsPanel<Co5300Controller, Bus, Time> {
 public:
  static constexpr std::uint16_t kRowStep = 2;  ///< rows of a strip are a multiple of this

  /// Sends nothing: start() does.
  constexpr Co5300(Bus& bus, Time& clock, const DcsConfig& config = kCo5300Module466x466)
      : DcsPanel<Co5300Controller, Bus, Time>(bus, clock, config) {}
};

}  // namespace zstrip::hal
