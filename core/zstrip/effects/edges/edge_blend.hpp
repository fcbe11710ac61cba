// Blends the pixels that an edge crosses with their neighbours on the other side of the edge.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
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

/// A strip whose edges are blended. Rectangles are in raster pixels and not empty.
struct EdgeTarget {
  Rect area;
  std::uint16_t* pixels;     ///< without gaps
  Rect known;                ///< the strip with its apron
  const std::uint16_t* own;  ///< pixels of `known` before blending, without gaps
  Rect depth_area;           ///< the part of `known` with depths
  const std::uint16_t* depth;
};

/// The codes that belong to an edge's surface.
struct EdgeSurface {
  std::int32_t tolerance;
  bool crease;  ///< both sides of the edge belong to the surface

  bool has(std::int32_t code, std::int32_t edge) const {
    const std::int32_t off = code - edge;
    return off <= tolerance && off >= -tolerance;
  }
};

/// A rectangle without gaps, by places along and across an edge instead of x and y. One code for both directions halves
/// the flash of blending.
struct EdgeRect {
  struct Range {
    std::int32_t first, length;
    constexpr std::int32_t end() const { return first + length; }
    [[gnu::always_inline]] constexpr bool has(std::int32_t place) const {
      return static_cast<std::uint32_t>(place - first) < static_cast<std::uint32_t>(length);
    }
  };
  Range along, across;
  std::int32_t step_along, step_across;

  [[gnu::always_inline]] constexpr EdgeRect(const Rect& rect, bool columns)
      : along{columns ? rect.left : rect.top, columns ? rect.width() : rect.height()},
        across{columns ? rect.top : rect.left, columns ? rect.height() : rect.width()},
        step_along(columns ? 1 : rect.width()),
        step_across(columns ? rect.width() : 1) {}
  [[gnu::always_inline]] constexpr std::int32_t index(std::int32_t place_along, std::int32_t place_across) const {
    return (place_along - along.first) * step_along + (place_across - across.first) * step_across;
  }
};

/// Walks an edge along its longer axis. In each column (or row) whose middle the edge crosses, the pixel there is
/// blended with the one on the other side of the edge. The weight is the part of the pixel's height (or width) on that
/// side, in the middle of the column (or row). `Int` has 32 bits for narrow edges, 64 for all.
template <class Int>
class EdgeBlend {
 public:
  /// Returns the number of pixels that the edge crosses in the strip.
  static std::uint32_t draw(const EdgeTarget& target, const SeenEdge& edge) {
    const Int dx = Int{edge.b.x} - edge.a.x, dy = Int{edge.b.y} - edge.a.y;
    const bool columns = std::max(dx, -dx) >= std::max(dy, -dy);
    const auto end = [columns](const WidePosition& p) {
      return columns ? End{p.x, p.y, p.depth} : End{p.y, p.x, p.depth};
    };
    const End a = end(edge.a), b = end(edge.b);
    const EdgeBlend blend(target, {static_cast<std::int32_t>(tolerance_of<Int>(edge)), edge.crease}, columns);
    // From the lower end, so that both directions give the same pixels.
    return a.along <= b.along ? blend.walk(a, b) : blend.walk(b, a);
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
  static constexpr int kPixelBits = kBits + 4;  ///< fraction bits of a pixel across the edge

  using Bits = std::make_unsigned_t<Int>;

  struct End {
    std::int32_t along, across;
    std::uint32_t depth;
  };

  const EdgeTarget& target_;
  const EdgeSurface surface_;
  const EdgeRect area_, known_, depth_;

  EdgeBlend(const EdgeTarget& target, const EdgeSurface& surface, bool columns)
      : target_(target),
        surface_(surface),
        area_(target.area, columns),
        known_(target.known, columns),
        depth_(target.depth_area, columns) {}

  /// Returns the code of a pixel; 0 if nothing was drawn there.
  std::int32_t code(std::int32_t along, std::int32_t across) const {
    return depth_.along.has(along) && depth_.across.has(across) ? target_.depth[depth_.index(along, across)] : 0;
  }

  /// Blends a pixel with its neighbour `other`, if the edge is visible there. `edge` is its code there.
  void blend(std::int32_t along, std::int32_t across, std::int32_t other, std::uint32_t weight,
             std::int32_t edge) const {
    if (!known_.across.has(other)) return;
    const std::int32_t codes[] = {code(along, across), code(along, other)};
    const auto [farther, nearer] = std::minmax(codes[0], codes[1]);
    if (!surface_.has(nearer, edge)) return;
    // A face of a crease may be narrower than a pixel; the neighbour then shows another surface.
    if (surface_.crease && (farther == 0 || !surface_.has(farther, edge))) return;
    std::uint16_t& pixel = target_.pixels[area_.index(along, across)];
    pixel = blended(pixel, target_.own[known_.index(along, other)], weight);
  }

  static constexpr Int quotient(Int numerator, Int length) {
    return (numerator + (numerator < 0 ? -length / 2 : length / 2)) / length;
  }

  /// Returns the number of steps until the place `across`, which grows by 16 `slope` a step, is in the strip; the
  /// greatest number if it never is.
  Bits steps_until_inside(Int across, Int slope) const {
    const Int pixel = across >> kPixelBits;
    if (area_.across.has(static_cast<std::int32_t>(pixel))) return 0;
    const bool below = pixel < area_.across.first;
    if (slope == 0 || below != (slope > 0)) return std::numeric_limits<Bits>::max();
    // Differences are in the range of Bits: a view reaches 2^11 pixels from its middle, a narrow edge 2^10.
    const auto border = [](std::int32_t place) { return static_cast<Bits>(Int{place}) << kPixelBits; };
    const Bits off = below ? border(area_.across.first) - static_cast<Bits>(across)
                           : static_cast<Bits>(across) - border(area_.across.end()) + 1;
    const Bits step = 16 * static_cast<Bits>(below ? slope : -slope);
    return (off + step - 1) / step;
  }

  std::uint32_t walk(const End& low, const End& high) const {
    // Only pixels whose middles lie between the ends: of two edges that meet, only one contains the middle of the pixel
    // in which they meet.
    std::int32_t first = std::max(low.along >> 4, area_.along.first);
    const std::int32_t end = std::min(high.along >> 4, area_.along.end());
    if (first >= end) return 0;
    const Int length = Int{high.along} - low.along;
    const Int rise = Int{high.across} - low.across;
    const Int slope = quotient(rise << kBits, length);
    const auto start = [&] { return Int{first} * 16 + kPixelCentre - low.along; };
    const auto across_at_start = [&] {
      return ((Int{low.across} << kBits) + slope * start()) - (Int{kCentreBias} << kBits);
    };
    const Bits skipped = steps_until_inside(across_at_start(), slope);
    if (skipped >= static_cast<Bits>(end - first)) return 0;
    first += static_cast<std::int32_t>(skipped);
    Int across = across_at_start();
    const Int fall = static_cast<Int>(high.depth >> 8) - static_cast<Int>(low.depth >> 8);
    const Int depth_slope = quotient(fall << kDepthBits, length);
    Int depth = depth_slope * start();
    // After the last middle the depth may exceed an Int.
    const auto step = [](Int value, Int by) {
      return static_cast<Int>(static_cast<Bits>(value) + 16 * static_cast<Bits>(by));
    };
    std::int32_t along = first;
    for (; along < end; ++along, across = step(across, slope), depth = step(depth, depth_slope)) {
      const auto place = static_cast<std::int32_t>(across >> (kBits - 2));  // 1/64 pixels
      const std::int32_t pixel = place >> 6, part = place & 63;
      if (!area_.across.has(pixel)) break;
      const auto weight = static_cast<std::uint32_t>(part < 32 ? part + 1 : 64 - part) / 2;
      const std::int32_t other = part < 32 ? pixel - 1 : pixel + 1;
      const auto edge = static_cast<std::int32_t>(((depth >> kDepthBits) + static_cast<Int>(low.depth >> 8)) >> 8);
      blend(along, pixel, other, weight, edge);
    }
    return static_cast<std::uint32_t>(along - first);
  }
};

}  // namespace zstrip::detail
