// Transforms a meshlet's vertices, in assembly for Thumb-1 (Cortex-M0, M0+), with perspective and z16.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/geometry/project.hpp"

namespace zstrip::detail {

/// A LinearForm with each coefficient as two halves, because a product of 32 bits is made of products of halves.
struct LinearHalves {
  std::int32_t x_low, x_high, offset, y_low, y_high, z_low, z_high;

  explicit LinearHalves(const LinearForm& form)
      : x_low(form.x & 0xFFFF),
        x_high(form.x >> 16),
        offset(form.offset),
        y_low(form.y & 0xFFFF),
        y_high(form.y >> 16),
        z_low(form.z & 0xFFFF),
        z_high(form.z >> 16) {}
};

/// Values of an instance and its projection, in the order in which the loop reads them.
struct HalvedTransform {
  LinearHalves x, y, w;
  std::uint32_t w_near, w_range;
  std::int32_t shift_x, bias_x, shift_y, bias_y;  ///< from NarrowProjection
  std::uint32_t depth_scale_low, depth_scale_high, depth_normalisation, depth_shift, depth_offset;

  HalvedTransform(const CompiledInstance& instance, const RasterOrigin& origin)
      : HalvedTransform(instance, origin, NarrowProjection<false>(instance, origin)) {}

 private:
  HalvedTransform(const CompiledInstance& instance, const RasterOrigin& origin, const NarrowProjection<false>& narrow)
      : x(instance.x),
        y(instance.y),
        w(instance.w),
        w_near(narrow.w_near),
        w_range(narrow.w_range),
        shift_x(narrow.shift_x),
        bias_x(narrow.bias_x),
        shift_y(narrow.shift_y),
        bias_y(narrow.bias_y),
        depth_scale_low(instance.depth_scale & 0xFFFF),
        depth_scale_high(instance.depth_scale >> 16),
        depth_normalisation(instance.depth_normalisation),
        depth_shift(instance.depth_shift),
        depth_offset(origin.depth_offset) {}
};

/// Writes `count` > 0 vertices. Returns true if all are narrow.
bool transform_vertices_thumb1(const HalvedTransform& transform, const Position* positions, std::uint32_t count,
                               SnappedVertex* vertices);

}  // namespace zstrip::detail
