// Blends the pixels that an edge crosses with their neighbours on the other side of the edge.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "zstrip/effects/edges/edges.hpp"
#include "zstrip/pixels/colour.hpp"
#include "zstrip/view.hpp"

namespace zstrip::detail {

/// Returns an RGB565 pixel with `weight`/32 of another one; weight 0..32. Rounded to nearest.
constexpr std::uint16_t blended(std::uint16_t own, std::uint16_t other, std::uint32_t weight) {
  const auto spread = [](std::uint32_t pixel) { return (pixel | (pixel << 16)) & kSpreadChannels; };
  const std::uint32_t sum = spread(own) * (32 - weight) + spread(other) * weight + 16 * kOneInEach;
  const std::uint32_t mean = (sum >> 5) & kSpreadChannels;
  return static_cast<std::uint16_t>(mean | (mean >> 16));
}

/// A strip whose edges are blended. Rectangles are in raster pixels.
struct EdgeTarget {
  Rect area;
  std::uint16_t* pixels;     ///< without gaps
  Rect known;                ///< the strip with its apron
  const std::uint16_t* own;  ///< pixels of `known` before blending, without gaps
  Rect depth_area;           ///< the part of `known` with depths
  const std::uint16_t* depth;

  /// Returns the code of a pixel; 0 if nothing was drawn there.
  std::uint32_t code(std::int32_t x, std::int32_t y) const {
    if (x < depth_area.left || x >= depth_area.right || y < depth_area.top || y >= depth_area.bottom) return 0;
    return depth[(y - depth_area.top) * depth_area.width() + (x - depth_area.left)];
  }

  /// The codes that belong to an edge's surface.
  struct Surface {
    std::int32_t tolerance;
    bool crease;  ///< both sides of the edge belong to the surface

    bool has(std::uint32_t code, std::int32_t edge) const {
      const std::int32_t off = static_cast<std::int32_t>(code) - edge;
      return off <= tolerance && off >= -tolerance;
    }
  };

  /// Blends pixel (x, y) with its neighbour (to_x, to_y), if the edge is visible there. `edge` is its code there.
  void blend(std::int32_t x, std::int32_t y, std::int32_t to_x, std::int32_t to_y, std::uint32_t weight,
             std::int32_t edge, const Surface& surface) const {
    if (to_x < known.left || to_x >= known.right || to_y < known.top || to_y >= known.bottom) return;
    const auto [farther, nearer] = std::minmax({code(x, y), code(to_x, to_y)});
    if (!surface.has(nearer, edge)) return;
    // A face of a crease may be narrower than a pixel; the neighbour then shows another surface.
    if (surface.crease && (farther == 0 || !surface.has(farther, edge))) return;
    std::uint16_t& pixel = pixels[(y - area.top) * area.width() + (x - area.left)];
    pixel = blended(pixel, own[(to_y - known.top) * known.width() + (to_x - known.left)], weight);
  }
};

/// Walks an edge along its longer axis. In each column (or row) whose middle the edge crosses, the pixel there is
/// blended with the one on the other side of the edge. The weight is the part of the pixel's height (or width) on that
/// side, in the middle of the column (or row). `Int` has 32 bits for narrow edges, 64 for all.
template <class Int>
class EdgeBlend {
 public:
  static void draw(const EdgeTarget& target, const SeenEdge& edge) {
    const Int dx = Int{edge.b.x} - edge.a.x, dy = Int{edge.b.y} - edge.a.y;
    const EdgeTarget::Surface surface{static_cast<std::int32_t>(tolerance_of<Int>(edge)), edge.crease};
    if (std::max(dx, -dx) >= std::max(dy, -dy)) {
      in_order<true>(target, {edge.a.x, edge.a.y, edge.a.depth}, {edge.b.x, edge.b.y, edge.b.depth}, surface);
    } else {
      in_order<false>(target, {edge.a.y, edge.a.x, edge.a.depth}, {edge.b.y, edge.b.x, edge.b.depth}, surface);
    }
  }

  /// Returns false if no pixel of the strip is blended.
  static bool crosses(const EdgeTarget& target, const SnappedVertex& a, const SnappedVertex& b) {
    const std::int32_t dx = b.x - a.x, dy = b.y - a.y;
    const auto within = [](std::int32_t p, std::int32_t q, std::int32_t first, std::int32_t end, std::int32_t border) {
      return std::max(std::min(p, q) >> 4, first - border) < std::min((std::max(p, q) >> 4) + border, end + border);
    };
    const bool columns = std::max(dx, -dx) >= std::max(dy, -dy);
    return within(a.x, b.x, target.area.left, target.area.right, columns ? 0 : 1) &&
           within(a.y, b.y, target.area.top, target.area.bottom, columns ? 1 : 0);
  }

 private:
  /// Fraction bits of a coordinate across the edge, and of a depth in addition to 1/256 code: as many as an Int allows.
  /// A slope, at most 1, is rounded: over the 2^15 sub-pixels of a narrow edge the error is 1/4 sub-pixel, or one code
  /// of depth. The place stays between the ends, within 2^30, or within 2^57 for wide edges.
  static constexpr int kBits = sizeof(Int) == 4 ? 16 : 32;
  static constexpr int kDepthBits = sizeof(Int) == 4 ? 6 : 30;

  struct End {
    std::int32_t along, across;
    std::uint32_t depth;
  };

  /// Walks from the lower end, so that both directions give the same pixels.
  template <bool columns>
  static void in_order(const EdgeTarget& target, const End& a, const End& b, const EdgeTarget::Surface& surface) {
    if (a.along <= b.along) {
      walk<columns>(target, a, b, surface);
    } else {
      walk<columns>(target, b, a, surface);
    }
  }

  static constexpr Int quotient(Int numerator, Int length) {
    return (numerator + (numerator < 0 ? -length / 2 : length / 2)) / length;
  }

  template <bool columns>
  static void walk(const EdgeTarget& target, const End& low, const End& high, const EdgeTarget::Surface& surface) {
    const Rect& area = target.area;
    // Only pixels whose middles lie between the ends: of two edges that meet, only one contains the middle of the pixel
    // in which they meet.
    const std::int32_t first = std::max(low.along >> 4, columns ? area.left : area.top);
    const std::int32_t end = std::min(high.along >> 4, columns ? area.right : area.bottom);
    if (first >= end) return;
    const std::int32_t least = columns ? area.top : area.left, beyond = columns ? area.bottom : area.right;
    const Int length = Int{high.along} - low.along;
    const Int start = Int{first} * 16 + kPixelCentre - low.along;
    const Int rise = Int{high.across} - low.across;
    const Int slope = quotient(rise << kBits, length);
    Int across = ((Int{low.across} << kBits) + slope * start) - (Int{kCentreBias} << kBits);
    const Int fall = static_cast<Int>(high.depth >> 8) - static_cast<Int>(low.depth >> 8);
    const Int depth_slope = quotient(fall << kDepthBits, length);
    Int depth = depth_slope * start;
    // After the last middle the depth may exceed an Int.
    const auto step = [](Int value, Int by) {
      using Bits = std::make_unsigned_t<Int>;
      return static_cast<Int>(static_cast<Bits>(value) + 16 * static_cast<Bits>(by));
    };
    for (std::int32_t along = first; along < end;
         ++along, across = step(across, slope), depth = step(depth, depth_slope)) {
      const auto place = static_cast<std::int32_t>(across >> (kBits - 2));  // 1/64 pixels
      const std::int32_t pixel = place >> 6, part = place & 63;
      if (pixel < least || pixel >= beyond) continue;
      const auto weight = static_cast<std::uint32_t>(part < 32 ? part + 1 : 64 - part) / 2;
      const std::int32_t other = part < 32 ? pixel - 1 : pixel + 1;
      const auto code = static_cast<std::int32_t>(((depth >> kDepthBits) + static_cast<Int>(low.depth >> 8)) >> 8);
      if constexpr (columns) {
        target.blend(along, pixel, along, other, weight, code, surface);
      } else {
        target.blend(pixel, along, other, along, weight, code, surface);
      }
    }
  }
};

}  // namespace zstrip::detail
