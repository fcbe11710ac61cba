// One pass over the strips, or over pairs of them.
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

std::vector<StripTimes> two_core_timeline(double begin, std::span<const StripWork> strips) {
  std::vector<StripTimes> times;
  double free_cores = begin, free_bus = 0;
  for (std::size_t first = 0; first < strips.size(); first += 2) {
    double both_drawn = free_cores;
    for (std::size_t strip = first; strip < std::min(first + 2, strips.size()); ++strip) {
      StripTimes t;
      t.draw_begin = free_cores;
      t.draw_end = t.draw_begin + strips[strip].draw;
      both_drawn = std::max(both_drawn, t.draw_end);
      // The first of a pair is sent while the second core draws on.
      t.send_begin = std::max(strip == first ? t.draw_end : both_drawn, free_bus);
      t.send_end = t.send_begin + strips[strip].send;
      free_bus = t.send_end;
      times.push_back(t);
    }
    free_cores = times.back().send_begin;
  }
  return times;
}

}  // namespace zstrip::sim
