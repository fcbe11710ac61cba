// Guesses a first plane from the corner whose row and column continue linearly for the longest distance, and a second
// plane from another corner. If few cells are far from both planes, the cells near the first guess are fitted exactly.
// The remaining cells are fitted to the second plane.
#include "zstrip/store/two_planes.hpp"

#include <algorithm>
#include <bit>

namespace zstrip::detail {
namespace {

/// Scale of the slopes here. It is divisible by all distances in a tile, so that no division is needed.
constexpr std::int32_t kScale = 840;
constexpr std::array<std::int32_t, kTileSide> kReciprocal{0, 840, 420, 280, 210, 168, 140, 120};
/// Largest distance of the first plane's cells from the guess. With more, cells of the second plane spoil the fit.
constexpr std::int32_t kNear = kScale;
/// Largest number of cells far from both guesses with which a fit is still tried.
constexpr std::uint32_t kMaxStrays = 8;

/// The longest run of cells from one cell on, in equal steps, that can lie in one plane.
struct PlanarRun {
  std::uint32_t length = 1;
  std::int32_t slope = 0;  ///< for one step, times kScale

  PlanarRun(const std::uint16_t* cell, std::ptrdiff_t step, std::uint32_t most) {
    const std::int32_t first = *cell;
    std::int32_t least = INT32_MIN, greatest = INT32_MAX;
    for (; length < most; ++length) {
      cell += step;
      const std::int32_t low = std::max(least, (*cell - first - 1) * kReciprocal[length]);
      const std::int32_t high = std::min(greatest, (*cell - first + 1) * kReciprocal[length]);
      if (low >= high) break;  // both bounds are exclusive
      least = low;
      greatest = high;
    }
    if (length > 1) slope = (least + greatest) / 2;
  }
};

struct Guess {
  std::int32_t start = 0, slope_x = 0, slope_y = 0;  ///< at the tile's first cell; times kScale
  std::uint32_t area = 0;
  std::uint32_t corner_x = 0, corner_y = 0;

  /// Guesses from the corner in the first or last column and row.
  Guess(const CoveredCells& tile, bool right, bool bottom) {
    const std::uint32_t x = right ? tile.width - 1 : 0, y = bottom ? tile.height - 1 : 0;
    const std::uint16_t* const corner = tile.cells.data() + y * kTileSide + x;
    const auto down = static_cast<std::ptrdiff_t>(kTileSide);
    const PlanarRun row(corner, right ? -1 : 1, tile.width), column(corner, bottom ? -down : down, tile.height);
    area = row.length * column.length;
    corner_x = x;
    corner_y = y;
    slope_x = right ? -row.slope : row.slope;
    slope_y = bottom ? -column.slope : column.slope;
    start = *corner * kScale - slope_x * static_cast<std::int32_t>(x) - slope_y * static_cast<std::int32_t>(y);
  }
};

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

/// Returns the best guess among the corners that are not in `cover`; nullptr if all corners are in it.
const Guess* best_outside(const std::array<Guess, 4>& guesses, const Cover& cover) {
  const Guess* best = nullptr;
  for (const Guess& guess : guesses) {
    if ((cover[guess.corner_y] >> guess.corner_x & 1) != 0) continue;
    if (best == nullptr || guess.area > best->area) best = &guess;
  }
  return best;
}

std::uint32_t cells_outside(const CoveredCells& tile, const Cover& a, const Cover& b) {
  std::uint32_t cells = 0;
  for (std::uint32_t y = 0; y < tile.height; ++y) {
    cells += static_cast<std::uint32_t>(std::popcount(static_cast<std::uint8_t>(tile.cover[y] & ~(a[y] | b[y]))));
  }
  return cells;
}

/// Returns the cells for which a plane gives the exact value, with the decoder's arithmetic.
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
  const std::array<Guess, 4> guesses{Guess{tile, false, false}, Guess{tile, true, false}, Guess{tile, false, true},
                                     Guess{tile, true, true}};
  CoveredCells part = tile;
  part.cover = near(tile, *best_outside(guesses, Cover{}));
  const Guess* const second = best_outside(guesses, part.cover);
  if (second == nullptr || cells_outside(tile, part.cover, near(tile, *second)) > kMaxStrays) return std::nullopt;
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
