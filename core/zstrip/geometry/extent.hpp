// The strips that each meshlet touches, so that the other strips need not visit it.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/base/fixed.hpp"
#include "zstrip/plan/record_bytes.hpp"

namespace zstrip::detail {

/// Strips side by side and one below the other, in groups of 2^shift if there are more than 256. Inclusive; first_row >
/// last_row: the meshlet is invisible.
struct Extent {
  std::uint8_t first_row, last_row, first_column, last_column;

  static constexpr Extent none() { return {1, 0, 1, 0}; }
  constexpr bool empty() const { return first_row > last_row; }
};
static_assert(sizeof(Extent) == kExtentBytes);

/// The picture's division into strips. Converts raster pixels to strips without a division.
class StripGrid {
 public:
  StripGrid() = default;
  /// `bounds`: the pixels of the picture that can be drawn.
  StripGrid(const Plan& plan, const View& view, const Rect& bounds)
      : inverse_rows_(inverse(plan.strip_rows)),
        inverse_columns_(inverse(plan.strip_columns)),
        across_(static_cast<std::int32_t>(plan.columns_of_strips(view))),
        row_shift_(shift_for(plan.rows_of_strips(view))),
        column_shift_(shift_for(plan.columns_of_strips(view))),
        centre_x_(view.width >> 1),
        centre_y_(view.height >> 1),
        bounds_(bounds) {}

  struct Range {
    std::int32_t first, end;
  };
  /// Returns the rows of strips that contain raster rows top .. bottom - 1; none if first >= end.
  Range rows_of(std::int32_t top, std::int32_t bottom) const {
    const std::int32_t first = std::max(top + centre_y_, bounds_.top);
    const std::int32_t end = std::min(bottom + centre_y_, bounds_.bottom);
    if (first >= end) return {0, 0};
    return {strip(first, inverse_rows_), strip(end - 1, inverse_rows_) + 1};
  }

  /// Converts the y of a vertex, 12.4, to its strip, as multiply_high(y + centre_y, inverse), in a grid of whole rows.
  struct VertexRows {
    std::int32_t centre_y;  ///< 12.4
    std::uint32_t inverse;  ///< 2^28 / rows of a strip, rounded up: exact below 2^16; a negative value stays negative
    std::int32_t strips;    ///< 0 to strips - 1 can hold pixels
    std::int32_t end;       ///< end of the last of them, 12.4, at most 2^16
  };
  VertexRows vertex_rows(std::uint16_t strip_rows) const {
    const std::int32_t strips = strip(bounds_.bottom - 1, inverse_rows_) + 1;
    return {centre_y_ * 16, ((inverse_rows_ - 1) >> 3) + 1, strips,
            std::min<std::int32_t>(strips * strip_rows * 16, 0x10000)};
  }

  /// Returns the strips that contain raster pixels of `box`; an empty rectangle if none does.
  Rect strips_of(const Rect& box) const {
    if (box.empty()) return {};
    const std::int32_t left = std::max(box.left + centre_x_, bounds_.left);
    const std::int32_t right = std::min(box.right + centre_x_, bounds_.right);
    const Range rows = rows_of(box.top, box.bottom);
    if (left >= right || rows.first >= rows.end) return {};
    return {strip(left, inverse_columns_), rows.first, strip(right - 1, inverse_columns_) + 1, rows.end};
  }
  /// Returns the strips that contain these pixels of the picture.
  Rect strips_of_picture(const Rect& pixels) const {
    return strips_of(
        {pixels.left - centre_x_, pixels.top - centre_y_, pixels.right - centre_x_, pixels.bottom - centre_y_});
  }
  std::int32_t across() const { return across_; }
  struct Place {
    std::int32_t row, column;
  };
  /// Divides unsigned numbers, so that no signed division is linked.
  Place place_of(std::uint16_t strip) const {
    const auto across = static_cast<std::uint32_t>(across_);
    const std::uint32_t row = strip / across;
    return {static_cast<std::int32_t>(row), static_cast<std::int32_t>(strip - row * across)};
  }

  Extent extent_of(const Rect& box) const {
    const Rect strips = strips_of(box);
    if (strips.empty()) return Extent::none();
    const auto group = [](std::int32_t strip, std::uint32_t shift) {
      return static_cast<std::uint8_t>(strip >> shift);
    };
    return {group(strips.top, row_shift_), group(strips.bottom - 1, row_shift_), group(strips.left, column_shift_),
            group(strips.right - 1, column_shift_)};
  }
  /// Returns a rectangle that contains all strips of an extent that is not empty.
  Rect strips_of_extent(const Extent& extent) const {
    const auto end = [](std::uint8_t last, std::uint32_t shift, std::int32_t strips) {
      return std::min<std::int32_t>((last + 1) << shift, strips);
    };
    return {extent.first_column << column_shift_, extent.first_row << row_shift_,
            end(extent.last_column, column_shift_, across_),
            end(extent.last_row, row_shift_, strip(bounds_.bottom - 1, inverse_rows_) + 1)};
  }
  bool touches(const Extent& extent, const Place& strip) const {
    const std::int32_t row = strip.row >> row_shift_;
    const std::int32_t column = strip.column >> column_shift_;
    return row >= extent.first_row && row <= extent.last_row && column >= extent.first_column &&
           column <= extent.last_column;
  }

 private:
  /// Returns 2^31 / length, rounded up: exact quotients for pixels below 2^12.
  static std::uint32_t inverse(std::uint16_t length) { return 0x80000000U / length + 1; }
  static std::int32_t strip(std::int32_t pixel, std::uint32_t inverse) {
    return static_cast<std::int32_t>(multiply_high(static_cast<std::uint32_t>(pixel) << 1, inverse));
  }
  static std::uint32_t shift_for(std::uint32_t strips) {
    std::uint32_t shift = 0;
    while ((strips - 1) >> shift > 255) ++shift;
    return shift;
  }

  std::uint32_t inverse_rows_ = 0, inverse_columns_ = 0;
  std::int32_t across_ = 0;
  std::uint32_t row_shift_ = 0, column_shift_ = 0;
  std::int32_t centre_x_ = 0, centre_y_ = 0;
  Rect bounds_{};
};

}  // namespace zstrip::detail
