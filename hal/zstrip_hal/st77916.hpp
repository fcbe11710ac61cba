// Sitronix ST77916: controller of round IPS panels of 360x360, on QSPI (qspi.hpp). Serial clock up to 50 MHz (20 ns a
// write cycle). Voltages, gamma and timing differ from one maker's glass to the next: give its list of commands as
// DcsConfig::module_commands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/mipi_dcs.hpp"

namespace zstrip::hal {

/// The controller, with pixels of 16 bits. It answers no id here.
struct St77916Controller {
  /// @{
  /// See DcsController.
  static constexpr std::uint16_t kColumns = 360;
  static constexpr std::uint16_t kRows = 360;
  static constexpr bool kHasBrightness = true;
  static constexpr std::uint32_t kId = 0;
  static constexpr auto kSettings = bytes();

  static constexpr std::uint8_t pixel_format(DisplayFormat format) {
    return format == DisplayFormat::rgb565_swapped ? 0x55 : 0;
  }
  /// @}
};

/// The usual round module of 1.8 inches, without its maker's list of commands.
inline constexpr DcsConfig kSt77916Module360x360{.width = 360, .height = 360, .inverted = true};

/// A panel with the controller ST77916. `bus` and `clock` must outlive it.
template <CommandDataBus Bus, Clock Time>
class St77916 : public DcsPanel<St77916Controller, Bus, Time> {
 public:
  /// Sends nothing: start() does.
  constexpr St77916(Bus& bus, Time& clock, const DcsConfig& config)
      : DcsPanel<St77916Controller, Bus, Time>(bus, clock, config) {}
};

}  // namespace zstrip::hal
