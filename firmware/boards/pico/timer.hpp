// Reads the chip's timer as the time.
#pragma once

#include <cstdint>

namespace zstrip::board {

/// Call it after start_pacing(), whose tick the RP2040's timer counts.
void start_timer();

/// Returns the milliseconds since start_timer(); wraps to 0 after 49 days.
std::uint32_t milliseconds();

}  // namespace zstrip::board
