// Prints the current step of long work: opening a model of millions of triangles takes minutes.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace zstrip::sim {

/// During its lifetime the current step is printed on stderr. On a terminal this is one line that is rewritten and
/// erased at the end, shown after the first second; elsewhere a line every ten seconds. Only one object at a time.
class StepReport {
 public:
  /// Silent unless `enabled`. `every`: time between two lines if stderr is not a terminal; 0: a line at each step.
  explicit StepReport(bool enabled, std::chrono::milliseconds every = std::chrono::seconds{10});
  ~StepReport();
  StepReport(const StepReport&) = delete;
  StepReport& operator=(const StepReport&) = delete;

 private:
  friend void tell_step(std::string step);
  friend void hide_step();
  using Clock = std::chrono::steady_clock;

  void run();
  void show();
  void hide();

  const bool on_terminal_;
  const std::chrono::milliseconds every_;
  const Clock::time_point start_ = Clock::now();
  std::mutex mutex_;  // of all below
  std::condition_variable ended_;
  std::string step_;
  bool drawn_ = false, is_over_ = false;
  std::thread thread_;
};

/// Begins a step, in words such as "reading 'model.obj'". Nothing is printed without a StepReport.
void tell_step(std::string step);
/// Erases the line of the terminal, before another one is written.
void hide_step();

}  // namespace zstrip::sim
