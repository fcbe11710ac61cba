// The main program of the scenes on the board's OLED.
#pragma once

#include "lm3s6965evb/oled_bus.hpp"
#include "portable/panel_program.hpp"
#include "zstrip_hal/ssd0323.hpp"

namespace zstrip::board {

using Oled = hal::Ssd0323<OledBus>;

/// Shows the motion for ever; main returns the result. The bus is polled: a second strip of pixels would save no time.
template <class Motion, class Bus>
int show_on_oled(Bus& bus) {
  bus.start();
  hal::Ssd0323 panel(bus);
  return run_on_panel<ScenePlayer<Motion>>(panel);
}

}  // namespace zstrip::board
