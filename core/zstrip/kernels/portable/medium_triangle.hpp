// Planes and rows of medium triangles in C++ for 32-bit processors: planes by exact products of words, then rows.
#pragma once

#include <bit>
#include <cstdint>

#include "zstrip/base/math.hpp"
#include "zstrip/pixels/colour.hpp"
#include "zstrip/pixels/medium_scan.hpp"
#include "zstrip/pixels/plane.hpp"
#include "zstrip/pixels/target.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// Sets the edge from one vertex down to another, at a row, for MediumRows.
[[gnu::noinline]] void set_medium_edge(EdgeWalk& edge, const SnappedVertex& from, const SnappedVertex& to,
                                       std::int32_t row, std::int32_t anchor_x);

/// The planes of a medium triangle, with the same bits as from PlaneSetup. There a step is floor(along * mantissa /
/// 2^(50 - zeros)), in units of 2^-24 for channels and depths of 16 fraction bits. Here the power of two is a constant,
/// because the triangle's sides are first shifted by the zeros.
class MediumPlanes {
 public:
  using Value = std::int32_t;
  MediumPlanes() = default;
  /// `area` is twice the signed area; the anchor is a pixel near the triangle. Of the vertices only x and y count.
  template <class Vertex>
  MediumPlanes(const Vertex& v0, const Vertex& v1, const Vertex& v2, std::int32_t area, std::int32_t anchor_x,
               std::int32_t anchor_y) {
    const int zeros = std::countl_zero(static_cast<std::uint32_t>(area));
    mantissa_ = of_any_sign(reciprocal(static_cast<std::uint32_t>(area) << zeros));
    // A side is at most area / 2^2 < 2^(30 - zeros): 23 bits after the shift.
    const int shift = zeros - 7;
    dx1_ = (v2.x - v0.x) * (1 << shift), dy1_ = (v0.y - v2.y) * (1 << shift);
    dx2_ = (v0.x - v1.x) * (1 << shift), dy2_ = (v1.y - v0.y) * (1 << shift);
    offset_x_ = anchor_x * 16 + kPixelCentre - v0.x;
    offset_y_ = anchor_y * 16 + kPixelCentre - v0.y;
  }

  /// Returns a channel's plane, or a wrong one if the channel changes by 128 a pixel: see has_steep().
  Plane channel(std::int32_t c0, std::int32_t c1, std::int32_t c2) {
    const std::int32_t d1 = c1 - c0, d2 = c2 - c0;
    // 8 + 23 bits.
    const auto step = [this](std::int32_t along) {
      const std::int64_t product = long_product(along, mantissa_);
      beyond_ |= static_cast<std::uint32_t>(product >> 32) + (std::uint32_t{1} << 26);
      return static_cast<std::int32_t>(product >> 27);
    };
    const std::int32_t step_x = step(d1 * dy1_ + d2 * dy2_);
    const std::int32_t step_y = step(d1 * dx1_ + d2 * dx2_);
    // Drops the 8 extra bits, rounded to nearest.
    const auto rounded = [](std::int32_t value) {
      return static_cast<std::uint32_t>((value >> 8) + ((value >> 7) & 1));
    };
    const std::int64_t to_anchor = long_product(step_x, offset_x_) + long_product(step_y, offset_y_);
    return {static_cast<std::uint32_t>(c0 << 16 | 0x8000) + static_cast<std::uint32_t>(to_anchor >> 12),
            rounded(step_x), rounded(step_y)};
  }

  /// True if a channel changes so steeply that its steps have more than 32 bits.
  bool has_steep() const { return beyond_ >> 27 != 0; }

  Plane depth(std::uint32_t depth_0, std::uint32_t depth_1, std::uint32_t depth_2) const {
    return plane(static_cast<std::int32_t>(depth_0), static_cast<std::int32_t>(depth_1 - depth_0),
                 static_cast<std::int32_t>(depth_2 - depth_0));
  }

  Plane plane(std::int32_t value_0, std::int32_t d1, std::int32_t d2) const {
    // 31 + 23 bits, twice; a step has up to 41.
    const auto step = [this](std::int64_t along) {
      if constexpr (kMultipliesLonger) return longer_product_right(along, mantissa_, 43);
      const std::uint64_t low = long_product(static_cast<std::uint32_t>(along), static_cast<std::uint32_t>(mantissa_));
      const std::int64_t high = long_product(of_any_sign(static_cast<std::int32_t>(along >> 32)), mantissa_);
      return (high + static_cast<std::int64_t>(low >> 32)) >> 11;
    };
    const auto step_x = static_cast<std::uint64_t>(step(long_product(d1, dy1_) + long_product(d2, dy2_)));
    const auto step_y = static_cast<std::uint64_t>(step(long_product(d1, dx1_) + long_product(d2, dx2_)));
    const auto times = [](std::uint64_t step_a_pixel, std::int32_t pixels) {
      if constexpr (kMultipliesLonger) return step_a_pixel * static_cast<std::uint64_t>(std::int64_t{pixels});
      const auto low = static_cast<std::uint32_t>(step_a_pixel);
      const auto high = static_cast<std::uint32_t>(step_a_pixel >> 32) + (low >> 31);
      return static_cast<std::uint64_t>(long_product(static_cast<std::int32_t>(low), pixels)) +
             (std::uint64_t{high * static_cast<std::uint32_t>(pixels)} << 32);
    };
    const std::uint64_t to_anchor = times(step_x, offset_x_) + times(step_y, offset_y_);
    return {static_cast<std::uint32_t>(value_0) + static_cast<std::uint32_t>(to_anchor >> 12),
            static_cast<std::uint32_t>((step_x + 128) >> 8), static_cast<std::uint32_t>((step_y + 128) >> 8)};
  }

 private:
  std::int32_t mantissa_;
  std::int32_t dx1_, dy1_, dx2_, dy2_;  ///< weights of vertices 1 and 2 for a sub-pixel down and to the right
  std::int32_t offset_x_, offset_y_;
  std::uint32_t beyond_ = 0;  ///< the OR of the upper words of all channels' steps, each plus the limit
};

/// Sets the planes of a triangle from the scan's area, anchor and colours. Returns false if a channel is too steep.
inline bool set_medium_planes(MediumScan& scan, MediumPlanes& planes, const SnappedVertex& v0, const SnappedVertex& v1,
                              const SnappedVertex& v2) {
  const auto set = [&scan](MediumScan::Value value, const Plane& plane) {
    scan.start[value] = plane.start, scan.step_x[value] = plane.step_x, scan.step_y[value] = plane.step_y;
  };
  set(MediumScan::depth, planes.depth(v0.depth, v1.depth, v2.depth));
  if (!scan.has_channels) return true;
  const auto& c = scan.colours;
  const Plane red = planes.channel(c[0].r, c[1].r, c[2].r);
  set(MediumScan::red, red);
  const auto is_grey = [](const Colour& colour) { return colour.r == colour.g && colour.g == colour.b; };
  if (is_grey(c[0]) && is_grey(c[1]) && is_grey(c[2])) {  // the most common case: white light
    set(MediumScan::green, red);
    set(MediumScan::blue, red);
  } else {
    set(MediumScan::green, planes.channel(c[0].g, c[1].g, c[2].g));
    set(MediumScan::blue, planes.channel(c[0].b, c[1].b, c[2].b));
  }
  return !planes.has_steep();
}
inline bool set_up_medium_portable(MediumScan& scan, const SnappedVertex& v0, const SnappedVertex& v1,
                                   const SnappedVertex& v2) {
  MediumPlanes planes(v0, v1, v2, scan.area, scan.anchor_x, scan.anchor_y);
  return set_medium_planes(scan, planes, v0, v1, v2);
}

/// Draws `length` > 0 pixels of a row, from `column` on, counted from the anchor's column.
template <bool gouraud>
void scan_medium_row(const MediumScan& scan, std::int32_t column, std::int32_t length) {
  std::uint32_t z = scan.at(MediumScan::depth, column), r = 0, g = 0, b = 0;
  if constexpr (gouraud) {
    r = scan.at(MediumScan::red, column), g = scan.at(MediumScan::green, column);
    b = scan.at(MediumScan::blue, column);
  }
  std::uint16_t* cell = scan.rows.depth_row + column;
  std::uint16_t* pixel = scan.rows.colour_row + column;
  do {
    const auto code = static_cast<std::uint16_t>(z >> 16);
    if (*cell < code) {
      *cell = code;
      *pixel = gouraud ? rgb565(r, g, b) : scan.flat_colour;
    }
    ++cell, ++pixel;
    z += scan.step_x[MediumScan::depth];
    if constexpr (gouraud) {
      r += scan.step_x[MediumScan::red];
      g += scan.step_x[MediumScan::green];
      b += scan.step_x[MediumScan::blue];
    }
  } while (--length != 0);
}

/// Draws `count` > 0 rows, and moves the scan to the row below them.
template <bool gouraud>
void scan_medium_rows(MediumScan& scan, std::int32_t count) {
  do {
    const std::int32_t column = scan.rows.left.pixel, length = scan.rows.right.pixel - column;
    if (length > 0) scan_medium_row<gouraud>(scan, column, length);
    scan.rows.go_down();
    for (int i = 0; i < (gouraud ? 4 : 1); ++i) scan.start[i] += scan.step_y[i];
  } while (--count != 0);
}

}  // namespace zstrip::detail
