// The rest of a main program, after it has started a panel's bus: starts the panel, runs the scene, reports failures.
#pragma once

#include "portable/panic.hpp"
#include "portable/scene_loop.hpp"
#include "portable/scene_player.hpp"
#include "zstrip_hal/output_pin.hpp"

namespace zstrip::board {

/// Starts the watchdog and the panel, and shows the scene for ever; main returns the result. A player whose scene is
/// not constant brings its own loop and longer messages.
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

/// Does the same for a panel with a reset line and an optional backlight, which is switched on first so that a panic is
/// visible.
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
