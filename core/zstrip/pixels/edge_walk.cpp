// Sets up an edge of wide coordinates in 64 bits; see edge_walk.hpp.
#include "zstrip/pixels/edge_walk.hpp"

#include "zstrip/base/division.hpp"

namespace zstrip::detail {
namespace {

// Twice the product of two differences of wide coordinates, plus the denominator for rounding up.
static_assert(2 * (kGuardBits + 1) + 1 < 62);
// The denominator is 16 times a difference; clipping may round to 1/16 beyond the guard band.
static_assert(4 + kGuardBits + 1 < 31);

struct Floor {
  std::int32_t quotient;
  std::uint32_t rest;
};

/// Returns the floor of a quotient that fits 32 bits: a pixel, or pixels a row.
Floor floor_of(std::int64_t numerator, std::uint32_t denominator) {
  const bool negative = numerator < 0;
  const auto [quotient, rest] = divide_long(static_cast<std::uint64_t>(negative ? ~numerator : numerator), denominator);
  // floor(-(n + 1) / d) = -(floor(n / d) + 1)
  if (negative) return {static_cast<std::int32_t>(~quotient), denominator - 1 - rest};
  return {static_cast<std::int32_t>(quotient), rest};
}

}  // namespace

EdgeWalk EdgeWalk::wide(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1, std::int32_t row) {
  const std::int32_t dx = x1 - x0;
  const auto dy = static_cast<std::uint32_t>(y1 - y0);
  const std::uint32_t denominator = dy * 16;
  const std::int64_t numerator = std::int64_t{x0 - kPixelCentre} * dy + std::int64_t{row * 16 + kPixelCentre - y0} * dx;
  const Floor start = floor_of(numerator + denominator - 1, denominator);
  const Floor step = floor_of(dx, dy);
  EdgeWalk edge;
  edge.pixel = start.quotient, edge.step = step.quotient;
  edge.remainder = start.rest, edge.remainder_step = step.rest * 16, edge.denominator = denominator;
  return edge;
}

}  // namespace zstrip::detail
