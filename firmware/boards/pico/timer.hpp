// What time it is, from the RP2040's timer.
#pragma once

#include <cstdint>

namespace zstrip::board {

/// After start_pacing(), whose tick the timer counts.
void start_timer();

/// Since start_timer(); begins again at 0 after 49 days.
std::uint32_t milliseconds();

}  // namespace zstrip::board
