// When each strip of a frame is drawn and sent, in the order of hal/zstrip_hal/present.hpp.
#pragma once

#include <span>
#include <vector>

namespace zstrip::sim {

/// What a strip takes, seconds.
struct StripWork {
  double draw = 0;
  double send = 0;
};

/// From the beginning of the frame, seconds.
struct StripTimes {
  double draw_begin = 0, draw_end = 0;
  double send_begin = 0, send_end = 0;
};

/// `begin`: what begin_frame takes. With `overlap` there are two buffers, and one is sent while the other is drawn; a
/// transfer waits for the one before it, and the next strip is drawn when a transfer has begun.
std::vector<StripTimes> strip_timeline(double begin, std::span<const StripWork> strips, bool overlap);

/// The same by hal/zstrip_hal/second_core.hpp: each core begins its renderer's frame, takes the next strip when it is
/// free, and sends what is drawn, in order. Of three buffers.
std::vector<StripTimes> two_core_timeline(double begin, std::span<const StripWork> strips);

}  // namespace zstrip::sim
