// The frame clock, on which a board sleeps, and the watchdog, which resets it if it hangs. Each board defines these
// functions.
#pragma once

namespace zstrip::board {

/// Starts the frame clock and the watchdog, if the board has one. From now on the board resets itself unless
/// feed_watchdog() is called within a time that the board states, a few of its frames. The watchdog cannot be stopped.
void start_pacing();

/// Sleeps until the next tick of the frame clock; if one has passed since the last call, returns at once.
void wait_for_tick();

/// Call it only for shown frames, or while a host has paused them: then neither a driver that waits for ever nor a
/// running interrupt keeps a hanging board alive.
void feed_watchdog();

}  // namespace zstrip::board
