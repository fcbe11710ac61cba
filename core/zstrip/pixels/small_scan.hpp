// The data of the kernel of small triangles, for all implementations: the size limit of small triangles, and the values
// that a scan of a triangle's box steps.
#pragma once

#include <cstdint>

#include "zstrip/base/statistics.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// Width plus height of the bounding box, in 1/16 pixels, below which a triangle is small. Then
/// width * height <= 90 * 90 = 8100, so an edge function >> 4 is within -512..511.
inline constexpr std::int32_t kSmallExtent = 181;

/// Depth differences of small triangles stay below 8192 codes, so that 31-bit products keep the promised precision.
inline constexpr std::uint32_t kSmallDepthDifference = 1U << 29;  // 16.16

/// Returns true if draw_small_triangle may draw this triangle. Depends only on the triangle, not on the strip.
inline bool is_small(std::int32_t width, std::int32_t height, const SnappedVertex& a, const SnappedVertex& b,
                     const SnappedVertex& c) {
  // Compares halves, because differences of whole depths need 33 bits.
  const auto near_a = [&a](const SnappedVertex& v) {
    return (a.depth >> 1) - (v.depth >> 1) + kSmallDepthDifference / 2 < kSmallDepthDifference;
  };
  return width + height < kSmallExtent && near_a(b) && near_a(c);
}

/// Three edge functions / 16 in fields of 10, 11 and 11 bits. Pixel steps are multiples of 16, so the division by 16
/// loses nothing that a sign could show. A field that goes negative borrows from the one above; while all are >= 0
/// there is no borrow, so "no sign bit set" is exact.
struct PackedEdges {
  std::uint32_t word;
  static constexpr std::uint32_t kSigns = (1U << 31) | (1U << 21) | (1U << 10);

  static constexpr std::uint32_t pack(std::int32_t a, std::int32_t b, std::int32_t c) {
    return (static_cast<std::uint32_t>(a) << 22) + (static_cast<std::uint32_t>(b) << 11) +
           static_cast<std::uint32_t>(c);
  }
  /// Returns the field of an edge function that grows by `right` and `down`. The fill rule subtracts one unless the
  /// edge is a left one or a horizontal top one.
  static constexpr std::int32_t field(std::int32_t exact, std::int32_t right, std::int32_t down) {
    return (exact + ((right * 65536 + down) >> 31)) >> 4;
  }
  constexpr bool inside() const { return (word & kSigns) == 0; }
};

/// A value that is linear over the triangle: its start at the anchor pixel and its steps a pixel. Modulo 2^32: on very
/// thin triangles the steps overflow and cancel.
struct SmallPlane {
  std::uint32_t start, step_x, step_y;

  std::uint32_t at(std::uint32_t columns, std::uint32_t rows) const { return start + step_x * columns + step_y * rows; }
};

/// All values of a scan, in memory: set-up and scan are short only if neither keeps the other's values in registers.
struct SmallScan {
  /// The values with planes: PackedEdges; depth in 16.16 codes; green in 8.8; red and blue, two 8.8 values in a word,
  /// which never leave 0..255, see channel_start.
  enum Value { edges, depth, green, red_blue };
  // The assembly depends on the order of the members up to anchor_y.
  std::uint32_t start[4], step_x[4], step_y[4];  ///< of each Value
  std::uint16_t* depth_row;
  std::uint16_t* colour_row;
  std::int32_t depth_stride, colour_stride;
  std::int32_t width, height;  ///< size of the box, > 0
  Colour colours[3];
  std::int32_t area;
  std::int32_t anchor_x, anchor_y;
  std::uint32_t first_column, first_row;  ///< first pixel of the box, counted from the anchor
  std::uint16_t flat_colour;
  Statistics* statistics;

  void set(Value value, const SmallPlane& plane) {
    start[value] = plane.start, step_x[value] = plane.step_x, step_y[value] = plane.step_y;
  }
  /// Copies byte by byte, because GCC calls memcpy for an unaligned colour on a Cortex-M0.
  void set_colour(int vertex, const Colour& colour) {
    colours[vertex].r = colour.r, colours[vertex].g = colour.g, colours[vertex].b = colour.b;
  }
  std::uint32_t at(Value value, std::uint32_t column, std::uint32_t row) const {
    return SmallPlane{start[value], step_x[value], step_y[value]}.at(column, row);
  }

  /// Forces the results of a set-up stage into memory. Otherwise GCC mixes the stages, and has a dozen registers for
  /// the values of all of them.
  void settle() {
#if defined(__arm__)
    asm volatile("" : "+m"(*this));
#endif
  }
};

}  // namespace zstrip::detail
