// What a fuzz target does with a broken promise.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <cstdlib>

namespace fuzz {

/// If the promise does not hold, says so on standard error and aborts: libFuzzer takes that for a finding and keeps the
/// input. `promise` is printf's format, without a line end.
[[gnu::format(printf, 2, 3)]] inline void require(bool holds, const char* promise, ...) {
  if (holds) return;
  std::fputs("BROKEN PROMISE: ", stderr);
  std::va_list values;
  va_start(values, promise);
  std::vfprintf(stderr, promise, values);
  va_end(values);
  std::fputc('\n', stderr);
  std::abort();
}

}  // namespace fuzz
