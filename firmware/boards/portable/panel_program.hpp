// The rest of a main program, once a panel's bus is up: the panel starts, the scene runs, and what fails is said.
#pragma once

#include "portable/panic.hpp"
#include "portable/scene_loop.hpp"
#include "portable/scene_player.hpp"
#include "zstrip_hal/output_pin.hpp"

namespace zstrip::board {

/// Starts the watchdog and the panel, and shows the scene for ever; the result is main's. A player that is no scene of
/// constants has a loop of its own and longer words.
template <class Player, class Panel>
int run_on_panel(Panel& panel) {
  start_pacing();
  constexpr bool kHasLoop = requires { Player::show_for_ever(panel); };
  Failure failure;
  if (const hal::Error error = panel.start(); error != hal::Error::none) {
    failure = {"start of the display", hal::message(error)};
  } else if constexpr (kHasLoop) {
    failure = Player::show_for_ever(panel);
  } else {
    failure = show_scene<Player>(panel);
  }
  if constexpr (kHasLoop) {
    panic<Player::kMaxWords>(panel, failure);
  } else {
    panic(panel, failure);
  }
  return 1;
}

/// The same for a panel with a reset line, and perhaps a backlight, which is switched on first: a panic is to be seen.
template <class Player, class Panel, hal::OutputPin ResetPin, hal::Clock Time, hal::OutputPin LightPin = hal::NoPin>
int run_on_panel(Panel& panel, ResetPin reset, Time& clock, LightPin light = {}) {
  hal::Error error = hal::reset_panel(reset, clock);
  if (error == hal::Error::none) error = light.set(true);
  if (error != hal::Error::none) {
    print(Failure{"reset of the display", hal::message(error)});
    return 1;
  }
  return run_on_panel<Player>(panel);
}

}  // namespace zstrip::board
