// A renderer and a display of small strips for tests of what hands one's pixels to the other: each call can fail.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "zstrip_hal/display.hpp"
#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

inline constexpr std::uint16_t kWidth = 6;
inline constexpr std::uint16_t kHeight = 10;

struct DrawStatus {
  bool failed = false;
  explicit operator bool() const { return !failed; }
};

/// Counts calls over renderers and display; the one of this number fails.
struct FailingStep {
  int at = -1;
  int steps = 0;
  bool fails() { return steps++ == at; }
};

/// Takes pixels only when asked to wait, as late as the contract allows, so that a buffer that is drawn into too early
/// shows in the picture.
class LateDisplay {
 public:
  explicit LateDisplay(FailingStep& step) : step_(step) {}

  std::uint16_t width() const { return kWidth; }
  std::uint16_t height() const { return kHeight; }
  DisplayFormat format() const { return DisplayFormat::gray4; }

  Error begin_frame() {
    if (step_.fails()) return Error::timeout;
    EXPECT_FALSE(in_frame);
    in_frame = true;
    return Error::none;
  }
  Error write(const Area& area, std::span<const std::byte> pixels) {
    EXPECT_TRUE(in_frame);
    EXPECT_TRUE(sending_.empty()) << "a write while another is under way";
    EXPECT_EQ(pixels.size(), bytes_per_row(area.width, format()) * area.height);
    if (step_.fails()) return Error::timeout;
    areas.push_back(area);
    sending_ = pixels;
    return Error::none;
  }
  Error wait() {
    shown.insert(shown.end(), sending_.begin(), sending_.end());
    sending_ = {};
    return step_.fails() ? Error::timeout : Error::none;
  }
  Error end_frame() {
    EXPECT_TRUE(in_frame);
    EXPECT_TRUE(sending_.empty()) << "the frame ends while pixels are being sent";
    in_frame = false;
    return step_.fails() ? Error::timeout : Error::none;
  }

  bool in_frame = false;
  std::vector<Area> areas;
  std::vector<std::byte> shown;

 private:
  FailingStep& step_;
  std::span<const std::byte> sending_;
};
static_assert(Display<LateDisplay>);

/// Fills the whole buffer with the number of the strip.
struct NumberedStrips {
  FailingStep& step;
  std::vector<std::uint16_t> drawn{};
  DrawStatus draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
    std::ranges::fill(pixels, static_cast<std::byte>(strip + 1));
    drawn.push_back(strip);
    return {step.fails()};
  }
};

}  // namespace zstrip::hal
