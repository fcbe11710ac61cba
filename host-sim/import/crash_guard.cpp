// Keeps a crash inside a file parser from looking like a crash of zstrip.
#include "import/crash_guard.hpp"

#include <unistd.h>

#include "result.hpp"

namespace zstrip::sim {
namespace {

constexpr std::size_t kStackBytes = 64 * 1024;

// What the handler may read: set before the handler is, never changed while it can run.
const char* guard_line = nullptr;
std::size_t guard_line_bytes = 0;

extern "C" void end_with_message(int /*signal*/) {
  // Only async-signal-safe calls; a failed write leaves nothing better to do than to end.
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, guard_line, guard_line_bytes);
  ::_exit(static_cast<int>(ExitStatus::input));
}

}  // namespace

CrashGuard::CrashGuard(const std::string& message)
    : line_(message + '\n'), stack_(std::make_unique<std::byte[]>(kStackBytes)) {
  guard_line = line_.data();
  guard_line_bytes = line_.size();
  stack_t stack{};
  stack.ss_sp = stack_.get();
  stack.ss_size = kStackBytes;
  ::sigaltstack(&stack, &previous_stack_);
  struct sigaction action {};
  action.sa_handler = end_with_message;
  action.sa_flags = SA_ONSTACK;
  ::sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &action, &previous_[i]);
}

CrashGuard::~CrashGuard() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &previous_[i], nullptr);
  ::sigaltstack(&previous_stack_, nullptr);
}

}  // namespace zstrip::sim
