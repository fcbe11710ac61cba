// The depth of a triangle over the picture: one plane or, with the small float, one for each of its octaves.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/pixels/depth_rule.hpp"
#include "zstrip/pixels/plane.hpp"

namespace zstrip::detail {

/// A run of pixels in one row. `columns`, `rows` are relative to the anchor of the triangle's planes. The triangle may
/// cover more of the row than the strip contains. Subdivisions count from the ends of the whole run, so that they do
/// not depend on the strip.
template <class Cell = std::uint16_t>
struct Span {
  Cell* depth;
  std::uint16_t* colour;
  std::int32_t length;  ///< > 0
  std::int32_t columns, rows;
  std::int32_t skipped;       ///< pixels of the whole run to the left of this one
  std::int32_t whole_length;  ///< length of the run before it was cut to the strip
};

/// A plane of 16.16 codes, or of wide depths, over the whole triangle.
template <DepthFormat format>
class TriangleDepth {
 public:
  template <class Planes>
  TriangleDepth(const Planes& setup, const RasterVertex& v0, const RasterVertex& v1, const RasterVertex& v2) {
    if constexpr (format == DepthFormat::z16) {
      plane_ = setup.plane(v0.depth, std::int64_t{v1.depth} - v0.depth, std::int64_t{v2.depth} - v0.depth);
    } else {
      plane_ = setup.wide_plane(v0.depth, std::int64_t{v1.depth} - v0.depth, std::int64_t{v2.depth} - v0.depth);
    }
  }

  template <class Cell, class Draw>
  void for_each_run(const Span<Cell>& span, const Draw& draw) const {
    draw(span, plane_);
  }
  const auto& plane() const { return plane_; }

 private:
  std::conditional_t<format == DepthFormat::z16, Plane, WidePlane> plane_;
};

/// Inside an octave the code is affine in near / w, so that a run of one octave is drawn exactly like z16. A wide plane
/// of near / w, which is set up only for triangles of several octaves, gives the octave of a pixel.
template <>
class TriangleDepth<DepthFormat::float16> {
 public:
  template <class Planes>
  TriangleDepth(const Planes& setup, const RasterVertex& v0, const RasterVertex& v1, const RasterVertex& v2) {
    const auto [farthest, nearest] = std::minmax({v0.depth, v1.depth, v2.depth});
    first_ = float16_octave(farthest);
    last_ = float16_octave(nearest);
    for (std::uint32_t octave = first_; octave <= last_; ++octave) {
      const std::int64_t at_0 = float16_depth(v0.depth, octave);
      planes_[octave] = setup.plane(at_0, float16_depth(v1.depth, octave) - at_0,  // below 2^36
                                    float16_depth(v2.depth, octave) - at_0);
    }
    if (first_ != last_) {
      near_over_w_ = setup.wide_plane(v0.depth, std::int64_t{v1.depth} - v0.depth, std::int64_t{v2.depth} - v0.depth);
    }
  }

  template <class Cell, class Draw>
  void for_each_run(const Span<Cell>& span, const Draw& draw) const {
    if (first_ == last_) {
      draw(span, planes_[first_]);
      return;
    }
    // The shift drops 8 of a step's 64 bits; the step between two pixels that the triangle covers needs 53.
    const std::int64_t step = static_cast<std::int64_t>(near_over_w_.step_x << 8) >> 8;
    Span<Cell> run = span;
    for (std::int32_t left = span.length; left > 0; left -= run.length) {
      const std::uint64_t start = near_over_w_.at(run.columns, run.rows) & kMask;
      const std::uint32_t octave = octave_of(start);
      const std::uint64_t end = (start + near_over_w_.step_x * static_cast<std::uint64_t>(left - 1)) & kMask;
      run.length = octave_of(end) == octave ? left : std::min(left, columns_in_octave(start, octave, step));
      draw(run, planes_[octave]);
      run.depth += run.length;
      run.colour += run.length;
      run.columns += run.length;
      run.skipped += run.length;
    }
  }

 private:
  static constexpr std::uint64_t kMask = (std::uint64_t{1} << (32 + kWideBits)) - 1;

  /// Limited to the octaves of the vertices: a value that rounding puts outside of them uses the nearest plane.
  std::uint32_t octave_of(std::uint64_t near_over_w) const {
    return std::clamp(float16_octave(static_cast<std::uint32_t>(near_over_w >> kWideBits)), first_, last_);
  }
  /// Returns the number of pixels, from one of value `start` on, that are in this octave; at least 1.
  std::int32_t columns_in_octave(std::uint64_t start, std::uint32_t octave, std::int64_t step) const {
    const bool rises = step > 0;
    if (step == 0 || octave == (rises ? last_ : first_)) return INT32_MAX;
    // Octave o > 0 begins at 2^(25 + o).
    const std::uint64_t bottom = std::uint64_t{1} << (25 + octave + kWideBits);
    const std::uint64_t last_inside = rises ? 2 * bottom - 1 - start : start - bottom;
    const std::uint64_t steps = last_inside / static_cast<std::uint64_t>(rises ? step : -step);
    return steps < INT32_MAX ? static_cast<std::int32_t>(steps) + 1 : INT32_MAX;
  }

  std::uint32_t first_, last_;
  Plane planes_[7];
  WidePlane near_over_w_;
};

}  // namespace zstrip::detail
