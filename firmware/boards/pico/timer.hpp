// The time from the chip's timer.
#pragma once

#include <cstdint>

namespace zstrip::board {

/// After start_pacing(), whose tick an RP2040's timer counts.
void start_timer();

/// Since start_timer(); begins again at 0 after 49 days.
std::uint32_t milliseconds();

}  // namespace zstrip::board
