// The pixel loop of spheres and ellipsoids: steps the radicand, takes its root, tests the depth, shades.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "zstrip/base/pixel_root.hpp"
#include "zstrip/base/statistics.hpp"
#include "zstrip/effects/quadrics/quadric.hpp"
#include "zstrip/pixels/depth_rule.hpp"
#include "zstrip/visibility/traits.hpp"

namespace zstrip::detail {

/// The side of a quadric that is drawn if both sides lie in the depth range.
enum class QuadricSide : std::uint8_t { near, far };

template <Effects effects, QuadricSide side = QuadricSide::near>
class QuadricFill {
 public:
  static constexpr DepthMode kMode = depth_mode(effects);
  static constexpr bool kStatistics = effects.has(effect::statistics);
  using Target = TargetFor<kMode>;
  using Rule = DepthRule<kMode>;

  /// `offset` is added to the depth of `quadric` by the frame's mapping.
  template <class Shade>
  static void draw(const Target& target, const CompiledQuadric& quadric, std::int64_t offset, const Shade& shade) {
    const Rect box = quadric.box.cut_to(target.area);
    if (box.empty()) return;
    if constexpr (methods::keeps_bounds(kMode.method())) target.method->bounds.forget(box);
    // The quadric's codes lie between these two in any mapping.
    const RasterVertex farthest{0, 0, static_cast<std::uint32_t>(quadric.farthest + offset), 0, 0, 0, 0, 0};
    const RasterVertex nearest{0, 0, static_cast<std::uint32_t>(quadric.nearest + offset), 0, 0, 0, 0, 0};
    const Rule rule(target, farthest, nearest, nearest, 1);
    if (quadric.cut) {
      fill<true>(target, quadric, box, offset, rule, shade);
    } else {
      fill<false>(target, quadric, box, offset, rule, shade);
    }
  }

 private:
  /// A root in units of depth.
  template <bool cut>
  using Root = std::conditional_t<cut, std::uint64_t, std::uint32_t>;

  template <bool cut>
  static Root<cut> root_of(std::uint64_t radicand, std::int32_t root_shift) {
    const WideRoot r = wide_root(radicand);
    const std::int32_t shift = 8 + root_shift - r.half_shift;
    if (shift >= 0) return Root<cut>{r.root} << shift;
    return shift > -32 ? r.root >> -shift : 0;
  }

  template <bool cut, class Shade>
  static void fill(const Target& target, const CompiledQuadric& q, const Rect& box, std::int64_t offset,
                   const Rule& rule, const Shade& shade) {
    const auto wide = [](std::int32_t value) { return static_cast<std::uint64_t>(std::int64_t{value}); };
    // A row that leaves the silhouette does not enter it again, unless the silhouette is a hyperbola.
    const bool convex = static_cast<std::int64_t>(q.radicand_xx) < 0;
    const std::int32_t left = box.left - q.anchor_x;
    // A root of 32 bits that belongs to the surface is below 2^31, so that a larger shift would also give 0.
    const std::int32_t direction_shift = cut ? q.direction_shift : std::min<std::int32_t>(q.direction_shift, 31);
    for (std::int32_t row = box.top; row < box.bottom; ++row) {
      const std::int32_t rows = row - q.anchor_y;
      std::uint64_t radicand = q.radicand + wide(left) * q.radicand_x + wide(rows) * q.radicand_y +
                               wide(left) * wide(left) * q.radicand_xx + wide(left) * wide(rows) * q.radicand_xy +
                               wide(rows) * wide(rows) * q.radicand_yy;
      std::uint64_t step = q.radicand_x + wide(2 * left + 1) * q.radicand_xx + wide(rows) * q.radicand_xy;
      auto linear = static_cast<Root<cut>>(q.linear + wide(left) * q.linear_x + wide(rows) * q.linear_y);
      auto* cell = target.template depth_row<typename Rule::Cell>(row) + (box.left - target.area.left);
      std::uint16_t* pixel = target.colour_row(row) + (box.left - target.area.left);
      for (std::int32_t columns = left; columns < left + box.width(); ++columns, ++cell, ++pixel) {
        if (static_cast<std::int64_t>(radicand) > 0) {
          const Root<cut> root = root_of<cut>(radicand, q.root_shift);
          draw_pixel<cut>(q, linear, root, offset, rule, *cell, [&](std::int32_t sign, std::uint32_t depth) {
            *pixel = shade(columns, rows, sign * static_cast<std::int32_t>(root >> direction_shift), depth);
            count_pass<kStatistics>(target.statistics);
          });
          if constexpr (kStatistics)
            ++target.statistics->fragments, ++target.statistics->work[WorkKind::fragments_of_quadrics];
        } else if (convex && static_cast<std::int64_t>(step) <= 0) {
          break;
        }
        radicand += step;
        step += 2 * q.radicand_xx;
        linear += static_cast<Root<cut>>(q.linear_x);
      }
    }
  }

  /// Calls paint(1, depth) or, for the far side, paint(-1, depth) if the pixel passes the test.
  template <bool cut, class Paint>
  static void draw_pixel(const CompiledQuadric& q, Root<cut> linear, Root<cut> root, std::int64_t offset,
                         const Rule& rule, typename Rule::Cell& cell, const Paint& paint) {
    const auto test = [&](Root<cut> relative, std::int32_t sign) {
      const std::uint32_t depth = static_cast<std::uint32_t>(relative) + static_cast<std::uint32_t>(offset);
      if (rule.draws(stepped_depth<kMode.format>(depth), cell)) paint(sign, depth);
    };
    if constexpr (!cut && side == QuadricSide::far) {
      test(linear - root, -1);
    } else if constexpr (!cut) {
      test(linear + root, 1);
    } else {
      const auto in_range = [&q](std::uint64_t relative) {
        const auto depth = static_cast<std::int64_t>(relative);
        return depth >= q.farthest && depth <= q.nearest;
      };
      if (in_range(linear + root)) {
        test(linear + root, 1);
      } else if (q.shows_inside && in_range(linear - root)) {
        test(linear - root, -1);
      }
    }
  }
};

}  // namespace zstrip::detail
