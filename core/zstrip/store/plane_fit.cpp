// A plane gives a cell exactly if cell <= plane < cell + 1 there. So the heights (the cells minus the slopes' part)
// must lie within one code of each other. The search minimises their spread, which is a convex function of the slopes.
#include "zstrip/store/plane_fit.hpp"

#include <algorithm>
#include <bit>

namespace zstrip::detail {
namespace {

constexpr std::uint32_t kFraction = 10;  // of slopes and heights while searching
constexpr std::int32_t kOneCode = 1 << kFraction;

/// A search never starts this far from the slopes of a plane; products of smaller spreads stay below 2^31.
constexpr std::int32_t kFarOff = kOneCode * 64;
constexpr int kMaxSteps = 4;
/// From this spread on no search gets below one code. Most tiles without a plane end here.
constexpr std::int32_t kHopeless = kOneCode * 5 / 4;

struct Slopes {
  std::int32_t x, y;
};

struct Heights {
  std::int32_t least = INT32_MAX, greatest = INT32_MIN;

  void include(std::int32_t low, std::int32_t high) {
    least = std::min(least, low);
    greatest = std::max(greatest, high);
  }
  std::int32_t spread() const { return greatest - least; }
};

struct Extremes {
  std::int32_t least = INT32_MAX, greatest = INT32_MIN;
  std::int32_t low_x = 0, low_y = 0, high_x = 0, high_y = 0;
  std::int32_t spread() const { return greatest - least; }
};

/// The possible slopes; empty if least > greatest.
struct Interval {
  std::int32_t least, greatest;
  bool empty() const { return least > greatest; }
  void cut(std::int32_t low, std::int32_t high) {
    least = std::max(least, low);
    greatest = std::min(greatest, high);
  }
};

constexpr Interval kAnySlope{-(kOneCode << 16), kOneCode << 16};

/// Cuts the interval to the slopes that two cells allow: they are `distance` apart and differ by `difference` codes,
/// within one code.
void cut_to(Interval& interval, std::int32_t difference, std::int32_t distance) {
  interval.cut((difference - 1) * kOneCode / distance - 1, (difference + 1) * kOneCode / distance + 1);
}

class PlaneSearch {
 public:
  explicit PlaneSearch(const CoveredCells& tile) : tile_(tile) {}

  std::optional<FittedPlane> find() {
    const Interval along_x = slopes_along_x(), along_y = slopes_along_y();
    if (along_x.empty() || along_y.empty()) return std::nullopt;
    approach(along_x, along_y);
    if (best_spread_ >= kHopeless) return std::nullopt;
    if (best_spread_ >= kOneCode) minimise(along_x, along_y);
    if (best_spread_ >= kOneCode) return std::nullopt;
    for (const PlaneForm& form : kPlaneForms) {
      if (const auto plane = in_form(form)) return plane;
    }
    return std::nullopt;
  }

 private:
  /// Returns the slopes that the first and the last covered cell of each row allow.
  Interval slopes_along_x() const {
    Interval slopes = kAnySlope;
    for (std::uint32_t y = 0; y < tile_.height; ++y) {
      const std::uint32_t row = tile_.cover[y];
      if ((row & (row - 1)) == 0) continue;  // fewer than two covered cells
      const auto first = static_cast<std::uint32_t>(std::countr_zero(row));
      const auto last = static_cast<std::uint32_t>(std::bit_width(row)) - 1;
      cut_to(slopes, cell(last, y) - cell(first, y), static_cast<std::int32_t>(last - first));
      if (slopes.empty()) return slopes;
    }
    return slopes.least == kAnySlope.least ? Interval{0, 0} : slopes;
  }

  Interval slopes_along_y() const {
    Interval slopes = kAnySlope;
    for (std::uint32_t x = 0; x < tile_.width; ++x) {
      std::uint32_t first = 0, last = tile_.height - 1;
      while (first < last && !covered(x, first)) ++first;
      while (last > first && !covered(x, last)) --last;
      if (first == last) continue;
      cut_to(slopes, cell(x, last) - cell(x, first), static_cast<std::int32_t>(last - first));
      if (slopes.empty()) return slopes;
    }
    return slopes.least == kAnySlope.least ? Interval{0, 0} : slopes;
  }

  /// Starts at the middle of both intervals. Each step changes the slopes along the line between the highest and the
  /// lowest cell. A few steps are nearly always enough.
  void approach(const Interval& along_x, const Interval& along_y) {
    Slopes slopes{(along_x.least + along_x.greatest) >> 1, (along_y.least + along_y.greatest) >> 1};
    if (is_whole()) slopes = least_squares();
    for (int step = 0; step < kMaxSteps; ++step) {
      const Extremes found = extremes(slopes);
      consider(slopes, found.least, found.greatest);
      const std::int32_t dx = found.high_x - found.low_x, dy = found.high_y - found.low_y;
      if (done_ || found.spread() >= kFarOff || (dx == 0 && dy == 0)) return;
      const std::int32_t excess = found.spread() - kOneCode * 5 / 8;
      const std::int32_t length = dx * dx + dy * dy;
      slopes.x += excess * dx / length;
      slopes.y += excess * dy / length;
    }
  }

  void minimise(Interval along_x, const Interval& along_y) {
    while (along_x.greatest - along_x.least > 1) {
      const std::int32_t middle = (along_x.least + along_x.greatest) >> 1;
      const std::int32_t left = least_spread(middle, along_y);
      if (done_) return;
      const std::int32_t right = least_spread(middle + 1, along_y);
      if (done_) return;
      if (left <= right) {
        along_x.greatest = middle;
      } else {
        along_x.least = middle + 1;
      }
    }
    for (std::int32_t x = along_x.least; x <= along_x.greatest && !done_; ++x) least_spread(x, along_y);
  }

  /// Searches the slopes along y for one slope along x; keeps the best slopes so far.
  std::int32_t least_spread(std::int32_t slope_x, Interval along_y) {
    std::array<Heights, kTileSide> rows;
    for (std::uint32_t y = 0; y < tile_.height; ++y) rows[y] = row_heights(y, slope_x);
    const auto spread = [&](std::int32_t slope_y) {
      Heights all;
      for (std::uint32_t y = 0; y < tile_.height; ++y) {
        if (tile_.cover[y] == 0) continue;
        const std::int32_t down = slope_y * static_cast<std::int32_t>(y);
        all.include(rows[y].least - down, rows[y].greatest - down);
      }
      consider({slope_x, slope_y}, all.least, all.greatest);
      return all.spread();
    };
    while (along_y.greatest > along_y.least) {
      const std::int32_t middle = (along_y.least + along_y.greatest) >> 1;
      if (spread(middle) <= spread(middle + 1)) {
        along_y.greatest = middle;
      } else {
        along_y.least = middle + 1;
      }
    }
    return spread(along_y.least);
  }

  bool is_whole() const {
    if (tile_.height < kTileSide) return false;
    return std::all_of(tile_.cover.begin(), tile_.cover.end(), [](std::uint8_t row) { return row == 0xFF; });
  }

  /// Returns the slopes of least squares for 8 x 8 cells: the sums of (2 x - 7) cell and (2 y - 7) cell, divided by
  /// 672.
  Slopes least_squares() const {
    Slopes sums{0, 0};
    const std::uint16_t* cell = tile_.cells.data();
    for (std::int32_t y = 0; y < 8; ++y) {
      std::int32_t row = 0;
      for (std::int32_t x = 0; x < 8; ++x, ++cell) {
        row += *cell;
        sums.x += (2 * x - 7) * *cell;
      }
      sums.y += (2 * y - 7) * row;
    }
    static_assert(kFraction == 10);
    return {sums.x * 32 / 21, sums.y * 32 / 21};  // sums are below 2^24
  }

  Extremes extremes(const Slopes& slopes) const {
    Extremes found;
    std::int32_t start = 0;
    for (std::int32_t y = 0; y < static_cast<std::int32_t>(tile_.height); ++y, start += slopes.y) {
      std::uint32_t row = tile_.cover[static_cast<std::uint32_t>(y)];
      const std::uint16_t* cell = tile_.cells.data() + static_cast<std::uint32_t>(y) * kTileSide;
      std::int32_t across = start;
      for (std::int32_t x = 0; row != 0; ++x, row >>= 1, ++cell, across += slopes.x) {
        if ((row & 1) == 0) continue;
        const std::int32_t height = (*cell << kFraction) - across;
        if (height > found.greatest) found.greatest = height, found.high_x = x, found.high_y = y;
        if (height < found.least) found.least = height, found.low_x = x, found.low_y = y;
      }
    }
    return found;
  }

  Heights row_heights(std::uint32_t y, std::int32_t slope_x) const {
    Heights heights;
    std::uint32_t row = tile_.cover[y];
    std::int32_t across = 0;
    for (std::uint32_t x = 0; row != 0; ++x, row >>= 1, across += slope_x) {
      if ((row & 1) == 0) continue;
      const std::int32_t height = (cell(x, y) << kFraction) - across;
      heights.include(height, height);
    }
    return heights;
  }

  /// Returns the first start on a form's grid that is not below any height. It fits if it is less than a code above the
  /// least height.
  static std::int32_t start_above(std::int32_t greatest, const PlaneForm& form) {
    const std::uint32_t grid = kFraction - form.start_fraction;
    return (greatest + (1 << grid) - 1) >> grid << grid;
  }
  static bool fits(std::int32_t start, std::int32_t least) { return start < least + kOneCode; }

  /// Keeps these slopes if they are the best so far. The search ends when the second form's start fits.
  void consider(const Slopes& slopes, std::int32_t least, std::int32_t greatest) {
    if (done_) return;
    done_ = fits(start_above(greatest, kPlaneForms[1]), least);
    if (!done_ && greatest - least >= best_spread_) return;
    best_spread_ = greatest - least;
    best_ = slopes;
  }

  /// Rounds the slopes, each up or down, to the precision of the form.
  std::optional<FittedPlane> in_form(const PlaneForm& form) const {
    const std::int32_t limit = std::int32_t{1} << (form.slope_bits - 1);
    const auto holds = [limit](std::int32_t slope, std::uint32_t dropped) {
      const std::int32_t rounded = slope >> dropped;
      return rounded >= -limit && rounded + 1 < limit;
    };
    const std::uint32_t finest = std::min<std::uint32_t>(kFraction, form.start_fraction + 7U);
    for (std::uint32_t fraction = finest; fraction >= form.start_fraction; --fraction) {
      const std::uint32_t dropped = kFraction - fraction;
      if (!holds(best_.x, dropped) || !holds(best_.y, dropped)) continue;
      const std::int32_t choices = dropped == 0 ? 1 : 2;
      for (std::int32_t i = 0; i < choices * choices; ++i) {
        const Slopes slopes{(best_.x >> dropped) + i % choices, (best_.y >> dropped) + i / choices};
        Heights all;
        for (std::uint32_t y = 0; y < tile_.height; ++y) {
          if (tile_.cover[y] == 0) continue;
          const Heights row = row_heights(y, slopes.x << dropped);
          const std::int32_t down = (slopes.y << dropped) * static_cast<std::int32_t>(y);
          all.include(row.least - down, row.greatest - down);
        }
        const std::int32_t start = start_above(all.greatest, form);
        if (!fits(start, all.least) || start < 0 || start >= kOneCode << 16) continue;
        return FittedPlane{&form, fraction - form.start_fraction,
                           static_cast<std::uint32_t>(start) >> (kFraction - form.start_fraction), slopes.x, slopes.y};
      }
      return std::nullopt;  // a coarser grid of slopes is a part of this one
    }
    return std::nullopt;
  }

  bool covered(std::uint32_t x, std::uint32_t y) const { return (tile_.cover[y] >> x & 1) != 0; }
  std::int32_t cell(std::uint32_t x, std::uint32_t y) const { return tile_.cells[y * kTileSide + x]; }

  const CoveredCells& tile_;
  Slopes best_{};
  std::int32_t best_spread_ = INT32_MAX;
  bool done_ = false;
};

}  // namespace

std::optional<FittedPlane> fit_plane(const CoveredCells& tile) { return PlaneSearch(tile).find(); }

}  // namespace zstrip::detail
