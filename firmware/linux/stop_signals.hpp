// The signals that end the program: SIGINT, SIGTERM, SIGHUP, and others that would end it without a message.
#pragma once

#include <chrono>
#include <functional>
#include <utility>

#include "zstrip_hal_linux/file_descriptor.hpp"

namespace zstrip::panel {

/// From the first object on, these signals no longer end the program: it waits for them here. SIGPIPE and SIGXFSZ are
/// ignored, so that writes fail instead. SIGQUIT, signals of crashes and SIGKILL still end the program at once.
class StopSignals {
 public:
  using Clock = std::chrono::steady_clock;

  StopSignals();

  /// Sets a function that counts as a signal when it returns true. Every function below calls it, and while one waits
  /// it is called every kWatchEvery. Empty: no function.
  void watch(std::function<bool()> ended) { ended_ = std::move(ended); }
  static constexpr std::chrono::milliseconds kWatchEvery{15};

  bool arrived() { return arrived_before(Clock::now()); }
  /// Returns true as soon as a signal has arrived, false at `deadline`.
  bool arrived_before(Clock::time_point deadline);
  /// Returns when a signal has arrived.
  void wait();

 private:
  hal::FileDescriptor file_;
  std::function<bool()> ended_;
  bool arrived_ = false;
};

}  // namespace zstrip::panel
