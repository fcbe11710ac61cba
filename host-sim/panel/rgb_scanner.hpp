// A model of a controller that refreshes an RGB panel from two strips, as an ESP32-S3 does from its bounce buffers.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "panel/rgb_model.hpp"
#include "zstrip_hal/clock.hpp"

namespace zstrip::sim {

/// Reads its two buffers in turn, strip after strip, frame after frame. Also the clock that moves the panel's time.
class RgbScanner {
 public:
  /// Asks for a strip in a buffer, when the controller has read what was in it.
  using Interrupt = std::function<void(std::span<std::byte> buffer, std::uint16_t strip)>;

  /// `rows`: of a strip. The buffers are full of noise.
  RgbScanner(RgbModel& panel, const RgbTimings& timings, std::uint16_t rows, Interrupt interrupt);

  /// Asks for the first two strips, and begins a frame.
  void start();
  /// The pixel clock stands still until the next start().
  void stop() { is_running_ = false; }
  /// Lets time pass: rows and interrupts that are due happen in it.
  void wait(std::uint32_t microseconds);
  /// Shows the rest of the strip that is being read at once, so that the glass can be compared before it has been read.
  void show_rest();

  /// Returns the bytes that the controller has read.
  std::uint64_t bytes() const { return bytes_; }

 private:
  void scan_row();
  void show_row();
  void ask();
  int strips() const { return (timings_.height + rows_ - 1) / rows_; }

  RgbModel& panel_;
  RgbTimings timings_;
  int rows_;
  Interrupt interrupt_;
  std::array<std::vector<std::byte>, 2> buffers_;
  bool is_running_ = false;
  Nanoseconds due_{};     // when the next row is
  int line_ = 0;          // of the frame with its blanking, from the edge of VSYNC
  int shown_ = 0;         // rows of pixels that the panel has of this frame
  unsigned asked_ = 0;    // buffers so far
  unsigned reading_ = 0;  // buffers that were read so far
  int next_strip_ = 0;    // to be asked for
  std::uint64_t bytes_ = 0;
};

static_assert(hal::Clock<RgbScanner>);

}  // namespace zstrip::sim
