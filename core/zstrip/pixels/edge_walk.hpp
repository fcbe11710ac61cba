// Steps an edge row by row as an exact rational, quotient and remainder, without an error in any row.
#pragma once

#include <cstdint>
#include <type_traits>

#include "zstrip/base/division.hpp"
#include "zstrip/geometry/project.hpp"

namespace zstrip::detail {

/// `pixel` is the first one whose centre is not left of the edge: a span [left.pixel, right.pixel) obeys the top-left
/// rule.
struct EdgeWalk {
  EdgeWalk() = default;
  /// The edge from (x0, y0) down to (x1, y1), y0 < y1, at the pixel row `row`, whose centre lies in y0 .. y1. `narrow`:
  /// the coordinates are narrow; a bool or std::true_type. The pixels do not depend on it (docs/numerics.md).
  // GCC does not inline it in a file with many pipelines, which costs up to 2 % of R10k on the host.
  template <class Narrow>
  [[gnu::always_inline]] EdgeWalk(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1, std::int32_t row,
                                  Narrow narrow) {
    if constexpr (!std::is_same_v<Narrow, std::true_type>) {
      if (!narrow) {
        *this = wide(x0, y0, x1, y1, row);
        return;
      }
    }
    const std::int32_t dx = x1 - x0;
    const std::int32_t dy = y1 - y0;
    // pixel = ceil(((x0 - centre) dy + (row centre - y0) dx) / (16 dy))
    if constexpr (!kDivides) {
      // With dx = step dy + rest only the rest is divided: the time of a division depends on the bits of the quotient.
      std::int32_t rest = 0;
      divide(dx, dy, step, rest);
      const std::int32_t down = row * 16 + kPixelCentre - y0;
      const auto height = static_cast<std::uint32_t>(dy), over = static_cast<std::uint32_t>(down * rest);
      const std::uint32_t part = over / height;
      std::uint32_t left = over - part * height;
      std::int32_t sixteenths = x0 - kPixelCentre + down * step + static_cast<std::int32_t>(part) + 16;
      if (left == 0) --sixteenths, left = height;
      pixel = sixteenths >> 4;
      remainder = (static_cast<std::uint32_t>(sixteenths) & 15) * height + left - 1;
      remainder_step = static_cast<std::uint32_t>(rest) * 16;
      denominator = height * 16;
      return;
    }
    const std::int32_t numerator = (x0 - kPixelCentre) * dy + (row * 16 + kPixelCentre - y0) * dx;
    std::int32_t rest = 0;
    denominator = static_cast<std::uint32_t>(dy) * 16;
    divide(numerator + dy * 16 - 1, dy * 16, pixel, rest);
    remainder = static_cast<std::uint32_t>(rest);
    divide(dx, dy, step, rest);
    remainder_step = static_cast<std::uint32_t>(rest) * 16;
  }
  void next_row() {
    pixel += step;
    remainder += remainder_step;
    if (remainder >= denominator) {
      remainder -= denominator;
      ++pixel;
    }
  }

  std::int32_t pixel = 0;
  std::uint32_t remainder = 0;  ///< this and the members below are less than 2^31, also for wide edges
  std::int32_t step = 0;
  std::uint32_t remainder_step = 0, denominator = 1;

 private:
  /// Returned by value: the compiler would step an edge whose address is taken in memory.
  static EdgeWalk wide(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1, std::int32_t row);

  /// Divides and rounds down, so that the remainder is not negative.
  static void divide(std::int32_t numerator, std::int32_t by, std::int32_t& quotient, std::int32_t& rest) {
    if constexpr (kDivides) {
      quotient = numerator / by;
      rest = numerator - quotient * by;
      if (rest < 0) {
        rest += by;
        --quotient;
      }
    } else {
      // Unsigned, so that no signed division is linked. floor(-(n + 1) / d) = -(floor(n / d) + 1)
      const std::uint32_t sign = numerator < 0 ? ~std::uint32_t{0} : 0;
      const auto magnitude = static_cast<std::uint32_t>(numerator) ^ sign;
      const auto divisor = static_cast<std::uint32_t>(by);
      const std::uint32_t whole = magnitude / divisor;
      const std::uint32_t left = magnitude - whole * divisor;
      quotient = static_cast<std::int32_t>(whole ^ sign);
      rest = static_cast<std::int32_t>(sign != 0 ? divisor - 1 - left : left);
    }
  }
};

}  // namespace zstrip::detail
