// The signals that end the program.
#include "stop_signals.hpp"

#include <poll.h>
#include <sys/signalfd.h>

#include <algorithm>
#include <csignal>

namespace zstrip::panel {
namespace {

/// Real-time signals would also end the program without a message, but are not handled.
constexpr int kStopping[] = {SIGINT,  SIGTERM,   SIGHUP,  SIGUSR1, SIGUSR2, SIGALRM,
                             SIGPROF, SIGVTALRM, SIGXCPU, SIGIO,   SIGPWR,  SIGSTKFLT};

}  // namespace

StopSignals::StopSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  const auto add = [&signals](int signal) {
    struct sigaction action {};
    const bool is_ignored = sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
    // nohup ignores SIGHUP, and a shell ignores SIGINT for a program in the background.
    if (is_ignored && signal != SIGINT && signal != SIGTERM) return;
    if (is_ignored) std::signal(signal, SIG_DFL);
    sigaddset(&signals, signal);
  };
  for (const int signal : kStopping) add(signal);
  for (int signal = SIGRTMIN; signal <= SIGRTMAX; ++signal) add(signal);
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
  sigprocmask(SIG_BLOCK, &signals, nullptr);
  file_ = hal::FileDescriptor(signalfd(-1, &signals, SFD_CLOEXEC | SFD_NONBLOCK));
}

bool StopSignals::arrived_before(Clock::time_point deadline) {
  while (!arrived_) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    const long long most = ended_ ? kWatchEvery.count() : 60'000;  // milliseconds of one wait
    pollfd waiting{file_.get(), POLLIN, 0};
    arrived_ = poll(&waiting, 1, static_cast<int>(std::clamp<long long>(left, 0, most))) > 0 || (ended_ && ended_());
    if (!arrived_ && Clock::now() >= deadline) break;
  }
  return arrived_;
}

void StopSignals::wait() {
  while (!arrived_before(Clock::now() + std::chrono::minutes(1))) {
  }
}

}  // namespace zstrip::panel
