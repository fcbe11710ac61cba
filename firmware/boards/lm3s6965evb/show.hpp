// The main program of the scenes on the board's OLED.
#pragma once

#include "lm3s6965evb/oled_bus.hpp"
#include "portable/scene_loop.hpp"
#include "portable/scene_player.hpp"
#include "zstrip_hal/ssd0323.hpp"

namespace zstrip::board {

using Oled = hal::Ssd0323<OledBus>;

/// Shows the motion for ever; the result is main's. The bus is polled: a second strip of pixels would not save time.
template <class Motion>
int show_on_oled() {
  static OledBus bus;
  bus.start();
  Oled panel(bus);
  if (const hal::Error error = panel.start(); error != hal::Error::none) {
    print(Failure{"start of the display", hal::message(error)});
    return 1;
  }
  print(show_scene<ScenePlayer<Motion>>(panel));
  return 1;
}

}  // namespace zstrip::board
