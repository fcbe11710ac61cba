// The times at which each strip of a frame is drawn and sent, in the order of hal/zstrip_hal/present.hpp.
#pragma once

#include <span>
#include <vector>

namespace zstrip::sim {

/// The times of a strip, in seconds.
struct StripWork {
  double draw = 0;
  double send = 0;
};

/// Times in seconds from the beginning of the frame.
struct StripTimes {
  double draw_begin = 0, draw_end = 0;
  double send_begin = 0, send_end = 0;
};

/// `begin`: the time of begin_frame. With `overlap` there are two buffers, and one is sent while the other is drawn. A
/// transfer waits for the transfer before it, and the next strip is drawn when a transfer has begun.
std::vector<StripTimes> strip_timeline(double begin, std::span<const StripWork> strips, bool overlap);

/// The timeline of hal/zstrip_hal/second_core.hpp, with three buffers: each core begins its renderer's frame, takes the
/// next strip when it is free, and sends drawn strips in order.
std::vector<StripTimes> two_core_timeline(double begin, std::span<const StripWork> strips);

}  // namespace zstrip::sim
