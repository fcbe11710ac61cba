// One pass over the strips.
#include "bench/strip_timeline.hpp"

#include <algorithm>

namespace zstrip::sim {

std::vector<StripTimes> strip_timeline(double begin, std::span<const StripWork> strips, bool overlap) {
  std::vector<StripTimes> times;
  double free_core = begin, free_bus = 0;
  for (const StripWork& strip : strips) {
    StripTimes t;
    t.draw_begin = free_core;
    t.draw_end = t.draw_begin + strip.draw;
    t.send_begin = std::max(t.draw_end, free_bus);
    t.send_end = t.send_begin + strip.send;
    free_bus = t.send_end;
    free_core = overlap ? t.send_begin : t.send_end;
    times.push_back(t);
  }
  return times;
}

}  // namespace zstrip::sim
