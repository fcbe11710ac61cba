// A thread writes the lines while another one works, because some steps run in libraries that do not call back.
#include "text/step_report.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <system_error>
#include <utility>

#include "text/text.hpp"

namespace zstrip::sim {
namespace {

using namespace std::chrono_literals;

StepReport* current = nullptr;

}  // namespace

StepReport::StepReport(bool enabled, std::chrono::milliseconds every)
    : on_terminal_(::isatty(STDERR_FILENO) == 1), every_(every) {
  if (!enabled) return;
  current = this;
  if (every == 0ms) return;
  // The working thread handles the signals, not this one.
  sigset_t all, before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  try {
    thread_ = std::thread([this] { run(); });
  } catch (const std::system_error&) {
    current = nullptr;  // a machine without threads gets no report
  }
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

StepReport::~StepReport() {
  if (current != this) return;
  current = nullptr;
  {
    const std::scoped_lock lock(mutex_);
    is_over_ = true;
    hide();
  }
  ended_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void StepReport::run() {
  std::unique_lock lock(mutex_);
  auto next = start_ + (on_terminal_ ? 1s : every_);
  while (!ended_.wait_until(lock, next, [this] { return is_over_; })) {
    show();
    next += on_terminal_ ? 500ms : every_;
  }
}

void StepReport::show() {
  if (step_.empty()) return;
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - start_).count();
  const std::string line = fmt::format("zstrip: {}, {} s", printable(step_), seconds);
  write_text(stderr, on_terminal_ ? fmt::format("\r{:.79}\x1b[K", line) : line + '\n');
  drawn_ = on_terminal_;
}

void StepReport::hide() {
  if (std::exchange(drawn_, false)) write_text(stderr, "\r\x1b[K");
}

void tell_step(std::string step) {
  if (current == nullptr) return;
  const std::scoped_lock lock(current->mutex_);
  current->step_ = std::move(step);
  if (current->every_ == 0ms) current->show();
}

void hide_step() {
  if (current == nullptr) return;
  const std::scoped_lock lock(current->mutex_);
  current->hide();
}

}  // namespace zstrip::sim
