// Reports a crash or an endless loop inside a file parser as an error of the file.
#include "import/crash_guard.hpp"

#include <sys/mman.h>
#include <sys/time.h>
#include <unistd.h>

#include <string_view>

#include "address_sanitizer.hpp"
#include "result.hpp"

namespace zstrip::sim {
namespace {

constexpr std::size_t kStackBytes = 64 * 1024;

// AddressSanitizer maps terabytes.
constexpr bool kLimitsMemory = !kAddressSanitizer;

// The line that the handler may read: set before the handler is, and not changed while the handler can run.
std::string_view crash_line;
std::string_view time_line;

extern "C" void end_with_message(int signal) {
  const std::string_view line = signal == SIGPROF ? time_line : crash_line;
  // Only async-signal-safe calls; after a failed write the process can only end.
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, line.data(), line.size());
  ::_exit(static_cast<int>(ExitStatus::input));
}

/// Requests SIGPROF after this much processor time of the process; 0: never.
void set_clock(std::chrono::seconds limit) {
  itimerval timer{};
  timer.it_value.tv_sec = limit.count();
  ::setitimer(ITIMER_PROF, &timer, nullptr);
}

}  // namespace

CrashGuard::CrashGuard(const std::string& crashed, const std::string& too_long, std::chrono::seconds limit,
                       std::uint64_t memory)
    : crash_line_(crashed + '\n'), time_line_(too_long + '\n'), stack_(std::make_unique<std::byte[]>(kStackBytes)) {
  crash_line = crash_line_;
  time_line = time_line_;
  stack_t stack{};
  stack.ss_sp = stack_.get();
  stack.ss_size = kStackBytes;
  ::sigaltstack(&stack, &previous_stack_);
  struct sigaction action {};
  action.sa_handler = end_with_message;
  action.sa_flags = SA_ONSTACK;
  ::sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &action, &previous_[i]);
  set_clock(limit);
  ::getrlimit(RLIMIT_DATA, &previous_memory_);
  if (kLimitsMemory && memory < previous_memory_.rlim_cur) {
    const rlimit lower{memory, previous_memory_.rlim_max};
    ::setrlimit(RLIMIT_DATA, &lower);
  }
}

void CrashGuard::lift_limits() {
  set_clock({});
  ::setrlimit(RLIMIT_DATA, &previous_memory_);
}

CrashGuard::~CrashGuard() {
  lift_limits();
  for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &previous_[i], nullptr);
  ::sigaltstack(&previous_stack_, nullptr);
}

bool machine_gives(std::uint64_t bytes) {
  void* const memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return memory != MAP_FAILED && ::munmap(memory, bytes) == 0;
}

}  // namespace zstrip::sim
