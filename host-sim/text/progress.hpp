// A progress bar for work that takes more than a second, on a terminal only.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace zstrip::sim {

/// Draws on stderr; erases its line when it is destroyed. Silent if `enabled` is false, or if stderr is not a
/// terminal.
class Progress {
 public:
  /// `step` is the word for one step.
  Progress(std::uint32_t steps, bool enabled, const char* step = "frame");
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of the steps are finished.
  void show(std::uint32_t done);
  /// Does the same if the number of steps was not known before, and adds an estimate of the time that is left.
  void show(std::uint32_t done, std::uint32_t steps);

 private:
  std::uint32_t steps_;
  bool enabled_;
  const char* step_;
  std::string left_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_ = start_;
};

}  // namespace zstrip::sim
