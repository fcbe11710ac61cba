// From the corner whose row and column continue linearly for the longest, a first plane is guessed; the cells near it
// are fitted exactly, what that plane does not give is left to the second one.
#include "zstrip/store/two_planes.hpp"

#include <algorithm>
#include <bit>

namespace zstrip::detail {
namespace {

/// Of slopes here: divisible by all distances in a tile, so that no division is needed.
constexpr std::int32_t kScale = 840;
constexpr std::array<std::int32_t, kTileSide> kReciprocal{0, 840, 420, 280, 210, 168, 140, 120};
/// How far from the guess a cell of the first plane may lie. With more, cells of the second one spoil the fit.
constexpr std::int32_t kNear = kScale;

/// The cells from one on in equal steps, as far as they can be a plane's.
struct Run {
  std::uint32_t length = 1;
  std::int32_t slope = 0;  ///< a step, times kScale

  Run(const std::uint16_t* cell, std::ptrdiff_t step, std::uint32_t most) {
    const std::int32_t first = *cell;
    std::int32_t least = INT32_MIN, greatest = INT32_MAX;
    for (; length < most; ++length) {
      cell += step;
      const std::int32_t low = std::max(least, (*cell - first - 1) * kReciprocal[length]);
      const std::int32_t high = std::min(greatest, (*cell - first + 1) * kReciprocal[length]);
      if (low >= high) break;  // both bounds are open
      least = low;
      greatest = high;
    }
    if (length > 1) slope = (least + greatest) / 2;
  }
};

struct Guess {
  std::int32_t start = 0, slope_x = 0, slope_y = 0;  ///< at the tile's first cell; times kScale
  std::uint32_t area = 0;

  /// From the corner in the last column or the last row, or the first ones.
  Guess(const CoveredCells& tile, bool right, bool bottom) {
    const std::uint32_t x = right ? tile.width - 1 : 0, y = bottom ? tile.height - 1 : 0;
    const std::uint16_t* const corner = tile.cells.data() + y * kTileSide + x;
    const auto down = static_cast<std::ptrdiff_t>(kTileSide);
    const Run row(corner, right ? -1 : 1, tile.width), column(corner, bottom ? -down : down, tile.height);
    area = row.length * column.length;
    slope_x = right ? -row.slope : row.slope;
    slope_y = bottom ? -column.slope : column.slope;
    start = *corner * kScale - slope_x * static_cast<std::int32_t>(x) - slope_y * static_cast<std::int32_t>(y);
  }
};

Guess best_guess(const CoveredCells& tile) {
  Guess best(tile, false, false);
  for (const auto& [right, bottom] : {std::pair{true, false}, {false, true}, {true, true}}) {
    const Guess other(tile, right, bottom);
    if (other.area > best.area) best = other;
  }
  return best;
}

/// The cells near a guess.
Cover near(const CoveredCells& tile, const Guess& guess) {
  Cover cover{};
  std::int32_t row_start = guess.start;
  for (std::uint32_t y = 0; y < tile.height; ++y, row_start += guess.slope_y) {
    std::int32_t value = row_start;
    for (std::uint32_t x = 0; x < tile.width; ++x, value += guess.slope_x) {
      const std::int32_t distance = tile.cells[y * kTileSide + x] * kScale - value;
      if (distance <= kNear && distance >= -kNear) cover[y] = static_cast<std::uint8_t>(cover[y] | 1U << x);
    }
  }
  return cover;
}

/// The cells that a plane gives exactly, as the decoder computes them.
Cover given(const CoveredCells& tile, const FittedPlane& plane) {
  const std::uint32_t up = 16U - plane.form->start_fraction, slope_up = up - plane.more_fraction;
  const std::uint32_t step_x = static_cast<std::uint32_t>(plane.slope_x) << slope_up;
  const std::uint32_t step_y = static_cast<std::uint32_t>(plane.slope_y) << slope_up;
  std::uint32_t row_start = plane.start << up;
  Cover cover{};
  for (std::uint32_t y = 0; y < tile.height; ++y, row_start += step_y) {
    std::uint32_t value = row_start;
    for (std::uint32_t x = 0; x < tile.width; ++x, value += step_x) {
      if (value >> 16 == tile.cells[y * kTileSide + x]) cover[y] = static_cast<std::uint8_t>(cover[y] | 1U << x);
    }
  }
  return cover;
}

bool is_empty(const Cover& cover) {
  return std::all_of(cover.begin(), cover.end(), [](std::uint8_t row) { return row == 0; });
}

}  // namespace

std::optional<TwoPlanes> fit_two_planes(const CoveredCells& tile) {
  CoveredCells part = tile;
  part.cover = near(tile, best_guess(tile));
  if (is_empty(part.cover)) return std::nullopt;
  const auto first = fit_plane(part);
  if (!first) return std::nullopt;
  TwoPlanes found{given(tile, *first), *first, {}};
  for (std::uint32_t y = 0; y < tile.height; ++y) part.cover[y] = tile.cover[y] ^ found.cover[y];
  if (is_empty(part.cover)) return std::nullopt;
  const auto others = fit_plane(part);
  if (!others) return std::nullopt;
  found.others = *others;
  return found;
}

}  // namespace zstrip::detail
