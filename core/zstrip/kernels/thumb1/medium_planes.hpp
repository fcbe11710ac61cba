// The planes of medium triangles, in assembly for Thumb-1 (Cortex-M0, M0+).
#pragma once

#include <bit>
#include <cstdint>

#include "zstrip/base/math.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/pixels/medium_scan.hpp"
#include "zstrip/pixels/plane.hpp"

namespace zstrip::detail {

struct TexturedScan;
struct TexturedVertex;

/// The planes of MediumPlanes for a triangle for which fits_words is true. There sides are shifted so that a quotient
/// is always the same bits of its product. Here sides stay below 2^13, so that a factor is one word, and the remaining
/// shift comes last. Needs no limit for steep channels.
class ThumbPlanes {
 public:
  using Value = std::int32_t;
  ThumbPlanes() = default;
  template <class Vertex>
  ThumbPlanes(const Vertex& v0, const Vertex& v1, const Vertex& v2, std::int32_t area, std::int32_t anchor_x,
              std::int32_t anchor_y) {
    const int zeros = std::countl_zero(static_cast<std::uint32_t>(area));
    const auto mantissa = static_cast<std::uint32_t>(reciprocal(static_cast<std::uint32_t>(area) << zeros));
    mantissa_low_ = mantissa & 0xFFFF, mantissa_high_ = mantissa >> 16;
    // A side is at most area / 2 < 2^(31 - zeros): 2^13 after the shift.
    const int left = zeros > 18 ? zeros - 18 : 0;
    right_ = 18 - zeros + left;
    x1_ = (v0.y - v2.y) * (1 << left), x2_ = (v1.y - v0.y) * (1 << left);
    y1_ = (v2.x - v0.x) * (1 << left), y2_ = (v0.x - v1.x) * (1 << left);
    offset_x_ = anchor_x * 16 + kPixelCentre - v0.x;
    offset_y_ = anchor_y * 16 + kPixelCentre - v0.y;
  }

  Plane plane(std::int32_t value_0, std::int32_t d1, std::int32_t d2) const {
    Plane plane;
    set_plane(plane, *this, value_0, d1, d2);
    return plane;
  }
  /// Sets the planes of the scan's colours.
  void set_channels(MediumScan& scan) const;
  /// Sets up the texture as TextureCoordinates<false> and its start_rows() do, if its fits_words() is true.
  void set_texture(TexturedScan& scan, const TexturedVertex* const (&vertices)[3], std::int64_t depth_offset) const;

 private:
  static void set_plane(Plane& plane, const ThumbPlanes& planes, std::int32_t value_0, std::int32_t d1,
                        std::int32_t d2) asm("zstrip_set_plane_thumb");
  struct Layout;  ///< checks the offsets of the members

  // The assembly depends on the order of the members.
  std::uint32_t mantissa_low_, mantissa_high_;  ///< halves of 1 / area
  std::int32_t x1_, x2_, y1_, y2_;              ///< weights of vertices 1 and 2 for a sub-pixel to the right and down
  std::int32_t offset_x_, offset_y_;            ///< from vertex 0 to the anchor's centre
  std::int32_t right_;                          ///< the remaining shift of quotients, 0 .. 11
};

/// Sets the planes of a triangle from the scan's colours. No channel is too steep here.
inline bool set_medium_planes(MediumScan& scan, const ThumbPlanes& planes, const SnappedVertex& v0,
                              const SnappedVertex& v1, const SnappedVertex& v2) {
  const Plane depth = planes.plane(static_cast<std::int32_t>(v0.depth), static_cast<std::int32_t>(v1.depth - v0.depth),
                                   static_cast<std::int32_t>(v2.depth - v0.depth));
  scan.start[MediumScan::depth] = depth.start, scan.step_y[MediumScan::depth] = depth.step_y;
  scan.step_x[MediumScan::depth] = depth.step_x;
  if (scan.has_channels) planes.set_channels(scan);
  return true;
}

}  // namespace zstrip::detail
