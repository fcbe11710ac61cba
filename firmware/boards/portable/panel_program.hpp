// The rest of a main program, once a panel's bus is up: the panel starts, the scene runs, and what fails is said.
#pragma once

#include "portable/scene_loop.hpp"
#include "portable/scene_player.hpp"
#include "portable/turntable_motion.hpp"
#include "zstrip_hal/output_pin.hpp"

namespace zstrip::board {

/// Resets and starts `panel`, switches the backlight on and shows the scene for ever; the result is main's.
template <class Player, class Panel, hal::OutputPin ResetPin, hal::Clock Time, hal::OutputPin LightPin = hal::NoPin>
int run_on_panel(Panel& panel, ResetPin reset, Time& clock, LightPin light = {}) {
  hal::Error error = hal::reset_panel(reset, clock);
  if (error == hal::Error::none) error = panel.start();
  if (error == hal::Error::none) error = light.set(true);
  if (error != hal::Error::none) {
    print(Failure{"start of the display", hal::message(error)});
    return 1;
  }
  print(show_scene<Player>(panel));
  return 1;
}

}  // namespace zstrip::board
