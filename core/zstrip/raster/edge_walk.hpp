// An edge stepped row by row as an exact rational: quotient and remainder, no error at any row.
#pragma once

#include <cstdint>
#include <type_traits>

#include "zstrip/geometry/project.hpp"

namespace zstrip::detail {

// A product of two differences of wide coordinates, twice, and the denominator to round up.
static_assert(2 * (kGuardBits + 1) + 1 < 62);

/// Integer is int32_t for narrow coordinates, int64_t for wide ones: the same pixels, proven by the ranges in
/// docs/numerics.md. `pixel` is the first pixel whose centre is not left of the edge, so a span [left.pixel,
/// right.pixel) obeys the top-left rule by itself.
template <class Integer>
class EdgeWalk {
 public:
  EdgeWalk() = default;
  /// The edge from (x0, y0) down to (x1, y1), y0 < y1, at the pixel row `row`, whose centre lies in y0 .. y1.
  // Where many pipelines share a file, GCC would call it: up to 2 % of R10k on the host.
  [[gnu::always_inline]] EdgeWalk(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1,
                                  std::int32_t row) {
    const Integer dx = Integer{x1} - x0;
    const Integer dy = Integer{y1} - y0;
    denominator_ = dy * 16;
    // pixel = ceil(((x0 - centre) dy + (row centre - y0) dx) / (16 dy))
    const Integer numerator = (Integer{x0} - kPixelCentre) * dy + (Integer{row} * 16 + kPixelCentre - y0) * dx;
    Integer pixel_of_start{};
    divide(numerator + denominator_ - 1, denominator_, pixel_of_start, remainder_);
    pixel = static_cast<std::int32_t>(pixel_of_start);
    Integer step_pixels{};
    Integer rest{};
    divide(dx, dy, step_pixels, rest);
    step_ = static_cast<std::int32_t>(step_pixels);
    step_remainder_ = rest * 16;
  }
  void next_row() {
    pixel += step_;
    remainder_ += step_remainder_;
    if (remainder_ >= denominator_) {
      remainder_ -= denominator_;
      ++pixel;
    }
  }

  std::int32_t pixel = 0;

 private:
  static void divide(Integer numerator, Integer denominator, Integer& quotient, Integer& remainder) {
    quotient = numerator / denominator;
    remainder = numerator - quotient * denominator;
    if (remainder < 0) {
      remainder += denominator;
      --quotient;
    }
  }

  std::int32_t step_ = 0;
  Integer remainder_ = 0, step_remainder_ = 0, denominator_ = 1;
};

}  // namespace zstrip::detail
