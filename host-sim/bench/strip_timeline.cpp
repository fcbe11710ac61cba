// One pass over the strips; with two cores, from one end of a task to the next.
#include "bench/strip_timeline.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

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

namespace {

/// The algorithm of hal/zstrip_hal/shared_strips.hpp, with times instead of work.
class TwoCores {
 public:
  TwoCores(double begin, std::span<const StripWork> strips)
      : strips_(strips), times_(strips.size()), is_drawn_(strips.size()), now_(begin), bus_end_(begin) {}

  std::vector<StripTimes> run() {
    for (;;) {
      for (Core& core : cores_) {
        while (core.task == Task::none && take(core)) {
          if (core.end <= now_) finish(core);
        }
      }
      Core* next = nullptr;
      for (Core& core : cores_) {
        if (core.task != Task::none && (next == nullptr || core.end < next->end)) next = &core;
      }
      if (next == nullptr) return std::move(times_);
      now_ = next->end;
      finish(*next);
    }
  }

 private:
  enum class Task : std::uint8_t { none, draw, send, wait };
  struct Core {
    Task task = Task::none;
    std::size_t strip = 0;
    double end = 0;
  };
  static constexpr std::size_t kBuffers = 3;

  /// Returns false if the core waits for the other core.
  bool take(Core& core) {
    if (written_ < next_ && is_drawn_[written_] && !is_display_used_) {
      is_display_used_ = true;
      core = {Task::send, written_, std::max(now_, bus_end_)};
    } else if (next_ < strips_.size() && next_ < free_ + kBuffers) {
      times_[next_].draw_begin = now_;
      times_[next_].draw_end = now_ + strips_[next_].draw;
      core = {Task::draw, next_, times_[next_].draw_end};
      ++next_;
    } else if (next_ < strips_.size() && free_ < written_ && !is_display_used_) {
      is_display_used_ = true;
      core = {Task::wait, written_, std::max(now_, bus_end_)};
    } else {
      return false;
    }
    return true;
  }
  void finish(Core& core) {
    if (core.task == Task::draw) {
      is_drawn_[core.strip] = true;
    } else {
      is_display_used_ = false;
      free_ = core.strip;
    }
    if (core.task == Task::send) {
      bus_end_ = now_ + strips_[core.strip].send;
      times_[core.strip].send_begin = now_;
      times_[core.strip].send_end = bus_end_;
      ++written_;
    }
    core.task = Task::none;
  }

  std::span<const StripWork> strips_;
  std::vector<StripTimes> times_;
  std::vector<bool> is_drawn_;
  double now_, bus_end_;
  Core cores_[2];
  std::size_t next_ = 0, written_ = 0, free_ = 0;
  bool is_display_used_ = false;
};

}  // namespace

std::vector<StripTimes> two_core_timeline(double begin, std::span<const StripWork> strips) {
  return TwoCores(begin, strips).run();
}

}  // namespace zstrip::sim
