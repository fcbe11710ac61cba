// When a board that shows frames for ever sleeps, and what resets it if it does not go on. Each board defines these.
#pragma once

namespace zstrip::board {

/// Starts the frame clock and the watchdog, if the board has one: from now on the board resets itself unless
/// feed_watchdog() is called within what the board states, a few of its frames. Once started it cannot be stopped.
void start_pacing();

/// Sleeps until the next tick of the frame clock; if one has passed since the last call, returns at once.
void wait_for_tick();

/// Only frames that were shown, or a host that has paused them, may feed it: then no driver that waits for ever, and no
/// interrupt that still runs, keeps a board alive that does nothing.
void feed_watchdog();

}  // namespace zstrip::board
