// Rows in time, and an interrupt at the end of each strip.
#include "panel/rgb_scanner.hpp"

#include <algorithm>
#include <random>
#include <utility>

namespace zstrip::sim {

RgbScanner::RgbScanner(RgbModel& panel, const RgbTimings& timings, std::uint16_t rows, Interrupt interrupt)
    : panel_(panel), timings_(timings), rows_(rows), interrupt_(std::move(interrupt)) {
  std::minstd_rand random(1);
  for (std::vector<std::byte>& buffer : buffers_) {
    buffer.resize(std::size_t{2} * timings.width * rows);
    std::generate(buffer.begin(), buffer.end(), [&] { return static_cast<std::byte>(random()); });
  }
}

void RgbScanner::start() {
  panel_.start(timings_);
  is_running_ = true;
  due_ = panel_.now() + timings_.row_time();
  line_ = shown_ = next_strip_ = 0;
  asked_ = reading_ = 0;
  ask();
  ask();
}

void RgbScanner::ask() {
  const auto strip = static_cast<std::uint16_t>(next_strip_);
  next_strip_ = (next_strip_ + 1) % strips();
  interrupt_(buffers_[asked_++ % 2], strip);
}

void RgbScanner::wait(std::uint32_t microseconds) {
  const Nanoseconds end = panel_.now() + std::chrono::microseconds(microseconds);
  while (is_running_ && due_ <= end) {
    panel_.elapse(due_ - panel_.now());
    due_ += timings_.row_time();
    scan_row();
  }
  panel_.elapse(std::max(end - panel_.now(), 0ns));
}

void RgbScanner::scan_row() {
  const int first = static_cast<int>(timings_.rows.pulse + timings_.rows.back);
  const int row = line_ - first;
  if (line_ == 0) {
    panel_.begin_frame();
    shown_ = 0;
  }
  if (row >= 0 && row < timings_.height) {
    if (row == shown_) show_row();
    bytes_ += std::size_t{2} * timings_.width;
    if ((row + 1) % rows_ == 0 || row + 1 == timings_.height) {
      ++reading_;
      ask();
    }
  }
  if (++line_ == first + timings_.height + static_cast<int>(timings_.rows.front)) line_ = 0;
}

void RgbScanner::show_row() {
  const std::size_t bytes = std::size_t{2} * timings_.width;
  const std::span<const std::byte> strip(buffers_[reading_ % 2]);
  panel_.receive_row(strip.subspan(static_cast<std::size_t>(shown_ % rows_) * bytes, bytes));
  ++shown_;
}

void RgbScanner::show_rest() {
  const int end = std::min<int>(timings_.height, (shown_ / rows_ + 1) * rows_);
  while (shown_ < end) show_row();
}

}  // namespace zstrip::sim
