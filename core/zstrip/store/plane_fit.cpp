// A plane gives a cell exactly if cell <= plane < cell + 1 there. So the cells minus the slopes' part, the heights,
// must lie within one code of each other: the slopes are searched for which their spread, a convex function, is least.
#include "zstrip/store/plane_fit.hpp"

#include <algorithm>
#include <bit>

namespace zstrip::detail {
namespace {

constexpr std::uint32_t kFraction = 10;  // of slopes and heights while searching
constexpr std::int32_t kOneCode = 1 << kFraction;

struct Slopes {
  std::int32_t x, y;
};

/// Least and greatest height.
struct Heights {
  std::int32_t least = INT32_MAX, greatest = INT32_MIN;

  void include(std::int32_t low, std::int32_t high) {
    least = std::min(least, low);
    greatest = std::max(greatest, high);
  }
  std::int32_t spread() const { return greatest - least; }
};

/// The slopes that may be; empty if least > greatest.
struct Interval {
  std::int32_t least, greatest;
  bool empty() const { return least > greatest; }
  void cut(std::int32_t low, std::int32_t high) {
    least = std::max(least, low);
    greatest = std::min(greatest, high);
  }
};

constexpr Interval kAnySlope{-(kOneCode << 16), kOneCode << 16};

/// Two cells `distance` apart that differ by `difference` codes allow only slopes within a code of that.
void cut_to(Interval& interval, std::int32_t difference, std::int32_t distance) {
  interval.cut((difference - 1) * kOneCode / distance - 1, (difference + 1) * kOneCode / distance + 1);
}

class PlaneSearch {
 public:
  explicit PlaneSearch(const CoveredCells& tile) : tile_(tile) {}

  std::optional<FittedPlane> find() {
    const Interval along_x = slopes_along_x(), along_y = slopes_along_y();
    if (along_x.empty() || along_y.empty()) return std::nullopt;
    minimise(along_x, along_y);
    if (best_spread_ >= kOneCode) return std::nullopt;
    for (const PlaneForm& form : kPlaneForms) {
      if (const auto plane = in_form(form)) return plane;
    }
    return std::nullopt;
  }

 private:
  /// From the first and the last covered cell of each row.
  Interval slopes_along_x() const {
    Interval slopes = kAnySlope;
    for (std::uint32_t y = 0; y < tile_.height; ++y) {
      const std::uint32_t row = tile_.cover[y];
      if ((row & (row - 1)) == 0) continue;  // fewer than two
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

  void minimise(Interval along_x, const Interval& along_y) {
    while (along_x.greatest - along_x.least > 1) {
      const std::int32_t middle = (along_x.least + along_x.greatest) >> 1;
      const std::int32_t left = least_spread(middle, along_y);
      if (good_enough()) return;
      const std::int32_t right = least_spread(middle + 1, along_y);
      if (good_enough()) return;
      if (left <= right) {
        along_x.greatest = middle;
      } else {
        along_x.least = middle + 1;
      }
    }
    for (std::int32_t x = along_x.least; x <= along_x.greatest && !good_enough(); ++x) least_spread(x, along_y);
  }

  /// For one slope along x; keeps the best slopes so far.
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
      if (all.spread() < best_spread_) {
        best_spread_ = all.spread();
        best_ = {slope_x, slope_y};
      }
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

  /// The second form's start always fits.
  bool good_enough() const { return best_spread_ <= kOneCode - (kOneCode >> kPlaneForms[1].start_fraction); }

  /// The slopes rounded to what the form holds, down or up each.
  std::optional<FittedPlane> in_form(const PlaneForm& form) const {
    const std::int32_t limit = std::int32_t{1} << (form.slope_bits - 1);
    const auto fits = [limit](std::int32_t slope, std::uint32_t dropped) {
      const std::int32_t rounded = slope >> dropped;
      return rounded >= -limit && rounded + 1 < limit;
    };
    const std::uint32_t finest = std::min(kFraction, form.start_fraction + 7U);
    for (std::uint32_t fraction = finest; fraction >= form.start_fraction; --fraction) {
      const std::uint32_t dropped = kFraction - fraction;
      if (!fits(best_.x, dropped) || !fits(best_.y, dropped)) continue;
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
        // start must lie in greatest .. least + 1 code - 1 unit, on the form's grid.
        const std::uint32_t grid = kFraction - form.start_fraction;
        const std::int32_t start = (all.greatest + (1 << grid) - 1) >> grid;
        if ((start << grid) > all.least + kOneCode - 1) continue;
        if (start < 0 || start >> (16 + form.start_fraction) != 0) continue;
        return FittedPlane{&form, fraction - form.start_fraction, static_cast<std::uint32_t>(start), slopes.x,
                           slopes.y};
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
};

}  // namespace

std::optional<FittedPlane> fit_plane(const CoveredCells& tile) { return PlaneSearch(tile).find(); }

}  // namespace zstrip::detail
