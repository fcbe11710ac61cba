// Signals: which of them ask zstrip-panel to end in order, and which end nothing.
#include "stop_signals.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

namespace zstrip::panel {
namespace {

constexpr int kStopped = 10, kWentOn = 11;

[[noreturn]] void send(int signal) {
  StopSignals stop;
  std::raise(signal);
  _exit(stop.arrived() ? kStopped : kWentOn);
}

TEST(LinuxStopSignals, WhatWouldEndTheProgramWithoutAWordAsksItToStop) {
  for (int signal = 1; signal <= SIGRTMAX; ++signal) {
    if (signal > SIGSYS && signal < SIGRTMIN) continue;  // the C library's own
    switch (signal) {
      case SIGKILL:
      case SIGSTOP:
      case SIGTSTP:
      case SIGTTIN:
      case SIGTTOU: continue;  // not to be caught; or the program only pauses
      case SIGQUIT:
      case SIGILL:
      case SIGTRAP:
      case SIGABRT:
      case SIGBUS:
      case SIGFPE:
      case SIGSEGV:
      case SIGSYS: EXPECT_EXIT(send(signal), testing::KilledBySignal(signal), "") << signal; break;
      case SIGCHLD:
      case SIGCONT:
      case SIGURG:
      case SIGWINCH:
      case SIGPIPE:
      case SIGXFSZ: EXPECT_EXIT(send(signal), testing::ExitedWithCode(kWentOn), "") << signal; break;
      default: EXPECT_EXIT(send(signal), testing::ExitedWithCode(kStopped), "") << signal;
    }
  }
}

[[noreturn]] void watch() {
  StopSignals stop;
  int asked = 0;
  stop.watch([&asked] { return ++asked == 3; });
  const bool arrived = stop.arrived_before(StopSignals::Clock::now() + std::chrono::minutes(1));
  stop.watch({});
  _exit(arrived && asked == 3 && stop.arrived() ? kStopped : kWentOn);
}

TEST(LinuxStopSignals, WhatIsWatchedCountsAsOne) { EXPECT_EXIT(watch(), testing::ExitedWithCode(kStopped), ""); }

TEST(LinuxStopSignals, HangUpThatNohupIgnoresStaysIgnored) {
  std::signal(SIGHUP, SIG_IGN);
  EXPECT_EXIT(send(SIGHUP), testing::ExitedWithCode(kWentOn), "");
  std::signal(SIGINT, SIG_IGN);
  EXPECT_EXIT(send(SIGINT), testing::ExitedWithCode(kStopped), "");
}

}  // namespace
}  // namespace zstrip::panel
