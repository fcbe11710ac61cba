// Transforms a meshlet's vertices, in assembly for Thumb-2 (Cortex-M3, M4, M7), with perspective and z16.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/geometry/project.hpp"

namespace zstrip::detail {

/// Values of an instance and its projection, in the order in which the loop reads them.
struct NarrowTransform {
  LinearForm w;
  std::uint32_t w_near, w_range;
  LinearForm x, y;
  std::int32_t shift_x, shift_y, bias_x, bias_y;  ///< from NarrowProjection
  std::uint32_t depth_normalisation, depth_scale, depth_shift, depth_offset;

  NarrowTransform(const CompiledInstance& instance, const RasterOrigin& origin)
      : NarrowTransform(instance, origin, NarrowProjection<false>(instance, origin)) {}

 private:
  NarrowTransform(const CompiledInstance& instance, const RasterOrigin& origin, const NarrowProjection<false>& narrow)
      : w(instance.w),
        w_near(narrow.w_near),
        w_range(narrow.w_range),
        x(instance.x),
        y(instance.y),
        shift_x(narrow.shift_x),
        shift_y(narrow.shift_y),
        bias_x(narrow.bias_x),
        bias_y(narrow.bias_y),
        depth_normalisation(instance.depth_normalisation),
        depth_scale(instance.depth_scale),
        depth_shift(instance.depth_shift),
        depth_offset(origin.depth_offset) {}
};

/// Writes `count` > 0 vertices. Returns true if all are narrow.
bool transform_vertices_thumb2(const NarrowTransform& transform, const Position* positions, std::uint32_t count,
                               SnappedVertex* vertices);

}  // namespace zstrip::detail
