// Keeps a crash inside a file parser from looking like a crash of zstrip.
#pragma once

#include <csignal>

#include <array>
#include <cstddef>
#include <memory>
#include <string>

namespace zstrip::sim {

/// While it lives, a fatal signal of this process (bad access, stack overflow, abort, arithmetic trap) prints
/// `message` and a line end to stderr and ends the process with ExitStatus::input. One at a time; not for threads.
class CrashGuard {
 public:
  explicit CrashGuard(const std::string& message);
  ~CrashGuard();
  CrashGuard(const CrashGuard&) = delete;
  CrashGuard& operator=(const CrashGuard&) = delete;

 private:
  static constexpr std::array kSignals{SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL};
  std::string line_;
  std::unique_ptr<std::byte[]> stack_;  ///< the handler's own: the other one may have overflowed
  stack_t previous_stack_{};
  std::array<struct sigaction, kSignals.size()> previous_{};
};

}  // namespace zstrip::sim
