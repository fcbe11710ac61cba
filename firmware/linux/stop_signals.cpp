// The signals that ask the program to end.
#include "stop_signals.hpp"

#include <poll.h>
#include <sys/signalfd.h>

#include <algorithm>
#include <csignal>

namespace zstrip::panel {

StopSignals::StopSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    // nohup has SIGHUP ignored, a shell SIGINT of a program in the background.
    if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN && signal == SIGHUP) continue;
    if (action.sa_handler == SIG_IGN) std::signal(signal, SIG_DFL);
    sigaddset(&signals, signal);
  }
  sigprocmask(SIG_BLOCK, &signals, nullptr);
  file_ = hal::FileDescriptor(signalfd(-1, &signals, SFD_CLOEXEC | SFD_NONBLOCK));
}

bool StopSignals::arrived_before(Clock::time_point deadline) {
  while (!arrived_) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    constexpr long long kLongest = 60'000;  // at a time
    pollfd waiting{file_.get(), POLLIN, 0};
    arrived_ = poll(&waiting, 1, static_cast<int>(std::clamp<long long>(left, 0, kLongest))) > 0;
    if (!arrived_ && Clock::now() >= deadline) break;
  }
  return arrived_;
}

void StopSignals::wait() {
  while (!arrived_before(Clock::now() + std::chrono::minutes(1))) {
  }
}

}  // namespace zstrip::panel
