// A progress bar for work that takes more than a second, on a terminal only.
#include "report/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "report/text.hpp"

namespace zstrip::sim {

using namespace std::chrono_literals;

Progress::Progress(std::uint32_t steps, bool enabled, const char* step)
    : steps_(steps), enabled_(enabled && ::isatty(STDERR_FILENO) == 1), step_(step) {}

Progress::~Progress() {
  if (drawn_) write_text(stderr, "\r\x1b[K");
}

void Progress::show(std::uint32_t done) {
  const auto now = std::chrono::steady_clock::now();
  if (!enabled_ || now - start_ < 1s || now - last_ < 100ms) return;
  last_ = now;
  drawn_ = true;
  constexpr std::uint32_t kCells = 30;
  const std::uint32_t filled = static_cast<std::uint32_t>(std::uint64_t{kCells} * done / steps_);
  write_text(stderr,
             fmt::format("\r[{:=<{}}{: <{}}] {} {} of {}", "", filled, "", kCells - filled, step_, done, steps_));
}

}  // namespace zstrip::sim
