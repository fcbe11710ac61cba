// The signals that end the program: SIGINT, SIGTERM, SIGHUP, and the others that would end it without a word.
#pragma once

#include <chrono>
#include <functional>
#include <utility>

#include "zstrip_hal_linux/file_descriptor.hpp"

namespace zstrip::panel {

/// From the first object on they end nothing by themselves, but are waited for here; SIGPIPE and SIGXFSZ are ignored,
/// so that what is written fails instead. SIGQUIT, signals of crashes and SIGKILL still end the program at once.
class StopSignals {
 public:
  using Clock = std::chrono::steady_clock;

  StopSignals();

  /// Something else that counts as a signal when it is true. It is asked by every function below, and every
  /// kWatchEvery as long as one waits. None: nothing is.
  void watch(std::function<bool()> ended) { ended_ = std::move(ended); }
  static constexpr std::chrono::milliseconds kWatchEvery{15};

  /// True if a signal has arrived.
  bool arrived() { return arrived_before(Clock::now()); }
  /// Returns true as soon as one has arrived, false at `deadline`.
  bool arrived_before(Clock::time_point deadline);
  /// Returns when one has arrived.
  void wait();

 private:
  hal::FileDescriptor file_;
  std::function<bool()> ended_;
  bool arrived_ = false;
};

}  // namespace zstrip::panel
