// Draws lines and points: steps along the longer axis, and draws as many pixels across it as the line is wide.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/base/statistics.hpp"
#include "zstrip/effects/fog/fogged_colour.hpp"
#include "zstrip/effects/lines/lines.hpp"
#include "zstrip/geometry/colour_product.hpp"
#include "zstrip/geometry/segment.hpp"
#include "zstrip/pixels/colour.hpp"
#include "zstrip/pixels/depth_rule.hpp"
#include "zstrip/raster/fragment_settings.hpp"
#include "zstrip/visibility/traits.hpp"

namespace zstrip::detail {

/// The samples of a pixel, because widths of lines are in pixels. Samples that lie side by side are not square.
struct SampleGrid {
  std::int32_t columns = 1, rows = 1;
};

/// The colour of one line's pixels; the effects determine which members are used.
template <Effects effects>
struct LineShade {
  Colour colour{};
  std::uint16_t pixel = 0;        ///< `colour` in RGB565
  const FogCurve* fog = nullptr;  ///< only with effect::fog
  std::int64_t depth_offset = 0;  ///< the offset of distance_at
  [[no_unique_address]] MemberIf<effects, effect::dithered_colours, DitherAnchor> dither{};
  [[no_unique_address]] MemberIf<effects, effect::supersampled, SampleGrid> grid{};

  /// Returns the colour of a raster pixel; `depth` in 1/2^32 of all codes.
  std::uint16_t operator()([[maybe_unused]] std::int32_t column, [[maybe_unused]] std::int32_t row,
                           [[maybe_unused]] std::uint32_t depth) const {
    if constexpr (effects.has(effect::fog)) {
      if (fog == nullptr) return pixel;
      constexpr bool kOrthographic = effects.has(effect::orthographic);
      const FragmentColour own{colour.r, colour.g, colour.b, 255};
      if constexpr (effects.has(effect::dithered_colours)) {
        if (dither.dithered) {
          return fogged_colour<kOrthographic>(*fog, own, depth, depth_offset, dither.threshold(column, row));
        }
      }
      return fogged_colour<kOrthographic>(*fog, own, depth, depth_offset);
    }
    return pixel;
  }
};

template <Effects effects>
class LineFill {
 public:
  static constexpr DepthMode kMode = depth_mode(effects);
  static constexpr bool kStatistics = effects.has(effect::statistics);
  static constexpr bool kOrthographic = effects.has(effect::orthographic);
  static constexpr bool kSupersampled = effects.has(effect::supersampled);
  using Target = TargetFor<kMode>;
  using Rule = DepthRule<kMode>;
  using Shade = LineShade<effects>;

  /// Draws all segments of a set. `shade` has everything except the colour.
  static void draw(const Target& target, const CompiledLines& compiled, const LineSet& lines, const Mesh& mesh,
                   const RasterOrigin& origin, Shade shade) {
    const Rect box = compiled.box.cut_to(target.area);
    if (box.empty()) return;
    if constexpr (methods::keeps_bounds(kMode.method())) target.method->bounds.forget(box);
    const NarrowProjection<kOrthographic> narrow(compiled.instance, origin);
    shade.colour = compiled.instance.base;
    shade.pixel = rgb565(shade.colour);
    for (const Segment& segment : lines.segments) {
      const bool is_point = segment.a == segment.b;
      SnappedSegment snapped;
      if (!snap_segment<kOrthographic, kMode.format>(compiled.instance, narrow, origin, mesh.positions[segment.a],
                                                     mesh.positions[segment.b], is_point, snapped)) {
        continue;
      }
      if (!mesh.colours.empty()) {
        shade.colour = product(compiled.instance.base, mesh.colours[segment.a]);
        shade.pixel = rgb565(shade.colour);
      }
      const LineFill fill(target, snapped, shade);
      if (is_point) {
        fill.point(snapped.a, lines.width);
      } else {
        fill.line(snapped, lines.width);
      }
    }
  }

 private:
  struct End {
    std::int32_t along, across;
    std::uint32_t depth;
  };

  /// Fraction bits of stepped depth in addition to those of a vertex.
  static constexpr int kDepthBits = 32;

  LineFill(const Target& target, const SnappedSegment& ends, const Shade& shade)
      : target_(target), shade_(shade), rule_(target, vertex(ends.a), vertex(ends.b), vertex(ends.b), 1) {}

  static RasterVertex vertex(const WidePosition& p) { return {p.x, p.y, p.depth, 0, 0, 0, 0, 0}; }
  static std::uint64_t stepped(std::uint32_t depth) { return std::uint64_t{depth} << kDepthBits; }

  static std::int32_t pixel_of(std::int32_t coordinate) { return (coordinate - kCentreBias) >> 4; }
  /// Returns the coordinate whose pixel_of is the first of `width` pixels around `coordinate`.
  static std::int32_t before(std::int32_t coordinate, std::int32_t width) { return coordinate - 8 * (width - 1); }

  /// These convert `width` pixels of the picture to columns, or rows, of samples.
  std::int32_t in_columns(std::int32_t width) const {
    if constexpr (kSupersampled) return width * shade_.grid.columns;
    return width;
  }
  std::int32_t in_rows(std::int32_t width) const {
    if constexpr (kSupersampled) return width * shade_.grid.rows;
    return width;
  }

  void point(const WidePosition& p, std::int32_t width) const {
    const std::int32_t wide = in_columns(width), high = in_rows(width);
    const std::int32_t left = pixel_of(before(p.x, wide)), top = pixel_of(before(p.y, high));
    const std::int32_t end = std::min(left + wide, target_.area.right);
    for (std::int32_t column = std::max(left, target_.area.left); column < end; ++column) {
      across<true>(column, top, high, stepped(p.depth));
    }
  }

  void line(const SnappedSegment& ends, std::int32_t width) const {
    const auto& [a, b] = ends;
    const auto distance = [](std::int32_t from, std::int32_t to) { return from < to ? to - from : from - to; };
    // Compares in pixels of the picture, whatever the samples are.
    if (in_rows(distance(a.x, b.x)) >= in_columns(distance(a.y, b.y))) {
      in_order<true>({a.x, a.y, a.depth}, {b.x, b.y, b.depth}, in_rows(width));
    } else {
      in_order<false>({a.y, a.x, a.depth}, {b.y, b.x, b.depth}, in_columns(width));
    }
  }

  /// Walks from the lower end, so that a line and its reverse have the same pixels.
  template <bool columns>
  void in_order(const End& a, const End& b, std::int32_t width) const {
    if (a.along <= b.along) {
      walk<columns>(a, b, width);
    } else {
      walk<columns>(b, a, width);
    }
  }

  /// `columns`: the longer axis is x. In each pixel of that axis which the line touches, draws `width` pixels around
  /// the line's point next to the pixel's centre.
  template <bool columns>
  void walk(const End& low, const End& high, std::int32_t width) const {
    const Rect& area = target_.area;
    const std::int32_t first = std::max(pixel_of(low.along), columns ? area.left : area.top);
    const std::int32_t last = std::min(pixel_of(high.along), (columns ? area.right : area.bottom) - 1);
    if (first > last) return;
    // Pixels whose centres lie between the ends. For the other pixels the next point is an end.
    const std::int32_t first_between = low.along >> 4, last_between = (high.along - kPixelCentre) >> 4;
    const auto end_at = [&](std::int32_t pixel, const End& end) {
      across<columns>(pixel, pixel_of(before(end.across, width)), width, stepped(end.depth));
    };
    if (first < first_between || low.along == high.along) end_at(first, low);
    if (low.along == high.along) return;
    between<columns>(low, high, std::max(first, first_between), std::min(last, last_between), width);
    if (last > last_between) end_at(last, high);
  }

  /// Pixels across are exact: quotient and remainder of the line's rational slope. The error of depth is below 1/8 of
  /// its unit: steps are rounded to 2^-30, and there are at most 2^27 sub-pixels.
  template <bool columns>
  void between(const End& low, const End& high, std::int32_t first, std::int32_t last, std::int32_t width) const {
    if (first > last) return;
    const std::int64_t length = std::int64_t{high.along} - low.along;  // below 2^27
    const std::int64_t rise = std::int64_t{high.across} - low.across;  // not more than `length`; twice that with two
                                                                       // samples
    const std::int64_t start = std::int64_t{first} * 16 + kPixelCentre - low.along;
    const auto denominator = static_cast<std::uint32_t>(length * 16);
    const std::int64_t numerator = (before(low.across, width) - kCentreBias) * length + rise * start;
    std::int64_t quotient = numerator / denominator, rest = numerator % denominator;
    if (rest < 0) rest += denominator, --quotient;
    auto pixel = static_cast<std::int32_t>(quotient);
    auto remainder = static_cast<std::uint32_t>(rest);
    std::int32_t step = rise == length ? 1 : rise < 0 ? -1 : 0;
    if constexpr (kSupersampled) {
      if (rise > length) step = rise == 2 * length ? 2 : 1;
      if (rise < -length) step = -2;
    }
    const auto step_remainder = static_cast<std::uint32_t>((rise - step * length) * 16);

    const std::int64_t depth_range = std::int64_t{high.depth} - low.depth;
    const std::uint64_t slope = static_cast<std::uint64_t>(depth_range * (std::int64_t{1} << 30) / length)
                                << (kDepthBits - 30);  // per sub-pixel
    std::uint64_t depth = stepped(low.depth) + slope * static_cast<std::uint64_t>(start);
    for (std::int32_t along = first; along <= last; ++along) {
      across<columns>(along, pixel, width, depth);
      depth += slope * 16;
      pixel += step;
      remainder += step_remainder;
      if (remainder >= denominator) remainder -= denominator, ++pixel;
    }
  }

  /// Draws `width` pixels of column (or row) `along`, from `first` on.
  template <bool columns>
  void across(std::int32_t along, std::int32_t first, std::int32_t width, std::uint64_t depth) const {
    const Rect& area = target_.area;
    const std::int32_t begin = std::max(first, columns ? area.top : area.left);
    const std::int32_t end = std::min(first + width, columns ? area.bottom : area.right);
    for (std::int32_t i = begin; i < end; ++i) {
      const std::int32_t x = columns ? along : i, y = columns ? i : along;
      auto& cell = target_.template depth_row<typename Rule::Cell>(y)[x - area.left];
      if constexpr (kStatistics)
        ++target_.statistics->fragments, ++target_.statistics->work[WorkKind::fragments_of_lines];
      if (!rule_.draws(value(depth), cell)) continue;
      target_.colour_row(y)[x - area.left] = shade_(x, y, static_cast<std::uint32_t>(depth >> kDepthBits));
      count_pass<kStatistics>(target_.statistics);
    }
  }

  static auto value(std::uint64_t depth) {
    if constexpr (kMode.format == DepthFormat::z16 || kMode.format == DepthFormat::float16) {
      return stepped_depth<kMode.format>(static_cast<std::uint32_t>(depth >> kDepthBits));
    } else {
      return depth >> (kDepthBits - kWideBits);
    }
  }

  const Target& target_;
  const Shade& shade_;
  Rule rule_;
};

}  // namespace zstrip::detail
