// The main program of boards that show one scene on one display for ever; see host_control.hpp.
#pragma once

#include <cstdint>

#include "portable/failure.hpp"
#include "portable/fault_return.hpp"
#include "portable/host_control.hpp"
#include "portable/pacing.hpp"
#include "zstrip_hal/display.hpp"

namespace zstrip::board {

/// Shows frame after frame of `Player`'s motion on a display that was started, one a tick or as fast as they can be
/// drawn; between frames the board sleeps. Call start_pacing() before. Returns only after a failure, also after a fault
/// of the processor.
template <class Player, hal::Display Panel>
Failure show_scene(Panel& panel) {
  if (mark_fault_return()) return {"fault", FaultWords::all()};
  HostControl control;
  for (std::uint32_t frame = 0;; frame = (frame + 1) % Player::kFrames) {
    if (const Failure failure = Player::show(panel, frame)) return failure;
    feed_watchdog();
    control.frame_shown(frame);
    wait_for_tick();
  }
}

}  // namespace zstrip::board
