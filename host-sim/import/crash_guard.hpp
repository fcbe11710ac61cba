// Reports a crash or an endless loop inside a file parser as an error of the file.
#pragma once

#include <sys/resource.h>

#include <csignal>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace zstrip::sim {

/// During its lifetime, a fatal signal of this process (bad access, stack overflow, abort, arithmetic trap) prints
/// `crashed` and a line end to stderr, and ends the process with ExitStatus::input. Using `limit` of processor time
/// does the same with `too_long`. Requests for more than `memory` bytes of memory are refused, as if the machine had no
/// more. Only one object at a time; not for threads.
class CrashGuard {
 public:
  CrashGuard(const std::string& crashed, const std::string& too_long, std::chrono::seconds limit, std::uint64_t memory);
  ~CrashGuard();
  CrashGuard(const CrashGuard&) = delete;
  CrashGuard& operator=(const CrashGuard&) = delete;

  /// Removes the limits of time and memory; crashes are still reported.
  void lift_limits();

 private:
  static constexpr std::array kSignals{SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGPROF};
  std::string crash_line_;
  std::string time_line_;
  std::unique_ptr<std::byte[]> stack_;  ///< the handler's own stack, because the other one may have overflowed
  stack_t previous_stack_{};
  rlimit previous_memory_{};
  std::array<struct sigaction, kSignals.size()> previous_{};
};

/// True if a request for this much memory would succeed now.
bool machine_gives(std::uint64_t bytes);

}  // namespace zstrip::sim
