// A progress bar for work that takes more than a second, on a terminal only.
#include "text/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "text/text.hpp"

namespace zstrip::sim {

using namespace std::chrono_literals;

Progress::Progress(std::uint32_t steps, bool enabled, const char* step)
    : steps_(steps), enabled_(enabled && ::isatty(STDERR_FILENO) == 1), step_(step) {}

Progress::~Progress() {
  if (drawn_) write_text(stderr, "\r\x1b[K");
}

void Progress::show(std::uint32_t done, std::uint32_t steps) {
  steps_ = steps;
  const std::chrono::duration<double> past = std::chrono::steady_clock::now() - start_;
  left_ = done == 0 ? "" : fmt::format(", about {:.0f} s left", past.count() / done * (steps - done));
  show(done);
}

void Progress::show(std::uint32_t done) {
  const auto now = std::chrono::steady_clock::now();
  if (!enabled_ || now - start_ < 1s || now - last_ < 100ms) return;
  last_ = now;
  drawn_ = true;
  constexpr std::uint32_t kCells = 30;
  const std::uint32_t filled = static_cast<std::uint32_t>(std::uint64_t{kCells} * done / steps_);
  write_text(stderr, fmt::format("\r[{:=<{}}{: <{}}] {} {} of {}{}\x1b[K", "", filled, "", kCells - filled, step_, done,
                                 steps_, left_));
}

}  // namespace zstrip::sim
