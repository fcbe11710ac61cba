// Transforms a triangle of a meshlet again in full width, and clips it to a polygon.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/effects.hpp"
#include "zstrip/effects/outlines/outline.hpp"
#include "zstrip/geometry/clip.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/raster/attributes.hpp"
#include "zstrip/raster/polygon.hpp"
#include "zstrip/raster/raster_effects.hpp"

namespace zstrip::detail {

/// Rotates the indices so that the vertex of least order becomes a. Planes start at vertex a, so that a triangle then
/// has the same depths and colours whichever vertex is its first.
template <class Order, class Corner>
void rotate_to_first(const Order& order, Corner& ia, Corner& ib, Corner& ic) {
  const auto a = order(ia), b = order(ib), c = order(ic);
  const Corner first = ia;
  if (b < a && b < c) {
    ia = ib, ib = ic, ic = first;
  } else if (c < a) {
    ia = ic, ic = ib, ib = first;
  }
}

/// The effects that change how a triangle is clipped. TriangleClipper is instantiated for these, so that pipelines and
/// shades share its code.
constexpr Effects clip_effects(Effects effects) {
  const Effects sides = shows_both_sides(effects) ? effect::two_sided : Effects{};
  return sides | (effects & (effect::orthographic | effect::depth_formats | effect::outlines));
}

template <Effects effects>
struct TriangleClipper {
  static_assert(without(effects, effect::two_sided) == without(clip_effects(effects), effect::two_sided));
  static constexpr bool kOrthographic = effects.has(effect::orthographic);

  /// Computes the corners in full width and their mesh indices. Colours and texture coordinates are set to 0.
  [[gnu::noinline]] static void begin(const Batch& batch, const Triangle& triangle, ClipPolygon& clipped,
                                      std::uint32_t (&indices)[3]) {
    clipped.count = 3;
    indices[0] = triangle.a, indices[1] = triangle.b, indices[2] = triangle.c;
    const auto by_position = [&batch](std::uint32_t index) {
      const Position& p = batch.mesh->positions[index];
      return std::int64_t{p.x} * (std::int64_t{1} << 32) + std::int64_t{p.y} * 65536 + p.z;
    };
    rotate_to_first(by_position, indices[0], indices[1], indices[2]);
    for (int i = 0; i < 3; ++i) set_vertex(batch, indices[i], clipped.vertices[i]);
  }

  /// Clips the triangle to a polygon. Returns false if no part of it faces the viewer.
  [[gnu::noinline]] static bool finish(const Batch& batch, ClipPolygon& clipped, RasterPolygon& polygon) {
    if constexpr (kOrthographic) {
      clip_orthographic(clipped, *batch.instance);
    } else {
      clip_perspective(clipped, *batch.instance);
    }
    for (int i = 0; i < clipped.count; ++i) polygon.append(projected(batch, clipped.vertices[i]));
    return polygon.face_front(effects.has(effect::two_sided) && batch.instance->double_sided);
  }

  /// Runs begin() and finish(), without colours and texture coordinates.
  [[gnu::noinline]] static bool clip(const Batch& batch, const Triangle& triangle, RasterPolygon& polygon) {
    ClipPolygon clipped;
    std::uint32_t indices[3];
    begin(batch, triangle, clipped, indices);
    return finish(batch, clipped, polygon);
  }

  /// True if the clipped polygon has no pixel in these rows, for a small part of what clipping takes. Sometimes false
  /// although it has none.
  [[gnu::noinline]] static bool misses_rows(const Batch& batch, const Triangle& triangle, const Rect& rows) {
    if constexpr (kOrthographic) return false;
    const CompiledInstance& instance = *batch.instance;
    if constexpr (effects.has(effect::outlines)) {
      if (is_outline(instance)) return false;  // its vertices move after the projection
    }
    // A visible point is at y / w * 2^exponent. It is above a row if y * 2^exponent - row * w < 0, a linear form, which
    // is negative on all of the triangle if it is at its vertices. Clipping moves y and w by less than 32 units of
    // kClipBits, and w at a plane of depth by less than 1; projection moves a point by less than a pixel.
    const int exponent = 30 - instance.shift_y;  // >= -1
    constexpr std::int32_t kPixel = 16;
    const std::int64_t top = rows.top * 16 - batch.origin.bias_y - kPixel;
    const std::int64_t bottom = rows.bottom * 16 - batch.origin.bias_y + kPixel;
    const std::int64_t moved = (std::int64_t{1} << std::max(0, exponent - 11)) + (1 << 16);  // rows are < 2^16
    bool above = true, below = true;
    for (const std::uint32_t index : {triangle.a, triangle.b, triangle.c}) {
      const Position& p = batch.mesh->positions[index];
      const std::int64_t w = instance.w.at(p);
      std::int64_t y = instance.y.at(p);
      y = exponent < 0 ? y >> 1 : y << exponent;
      above = above && y - top * w < -moved;
      below = below && y - bottom * w > moved;
    }
    return above || below;
  }

  /// Returns the distance along the viewing direction, in the instance's own scale.
  static std::int32_t distance_of(const Batch& batch, std::uint32_t index) {
    if constexpr (effects.has(effect::outlines)) {
      if (is_outline(*batch.instance)) return hull_vertex<kOrthographic>(*batch.instance, *batch.mesh, index).w;
    }
    return batch.instance->w.at(batch.mesh->positions[index]);
  }

 private:
  static void set_vertex(const Batch& batch, std::uint32_t index, ClipVertex& vertex) {
    const Position& p = batch.mesh->positions[index];
    const auto wide = [&p](const LinearForm& form) { return std::int64_t{form.at(p)} * (1 << kClipBits); };
    vertex = {};
    vertex.x = wide(batch.instance->x), vertex.y = wide(batch.instance->y), vertex.w = wide(batch.instance->w);
    if constexpr (effects.has(effect::outlines)) {
      if (is_outline(*batch.instance)) {
        const HullVertex moved = hull_vertex<kOrthographic>(*batch.instance, *batch.mesh, index);
        vertex.w = std::int64_t{moved.w} * (1 << kClipBits);
        vertex.u = moved.right, vertex.v = moved.down;
      }
    }
  }

  static RasterVertex projected(const Batch& batch, const ClipVertex& v) {
    WidePosition p = project_wide<kOrthographic>(*batch.instance, batch.origin, v);
    if constexpr (depth_format(effects) != DepthFormat::z16) {
      p.depth = project_wide_depth<kOrthographic, depth_format(effects)>(*batch.instance, batch.origin, v);
    }
    if constexpr (effects.has(effect::outlines)) {
      // Stops at the guard band, so that both neighbours move the vertex by the same amount.
      const auto moved = [](std::int32_t from, std::int32_t by) {
        constexpr std::int32_t kGuard = std::int32_t{1} << kGuardBits;
        return std::clamp(from + by, -kGuard, kGuard);
      };
      if (is_outline(*batch.instance)) return {moved(p.x, v.u), moved(p.y, v.v), p.depth, v.r, v.g, v.b, 0, 0};
    }
    return {p.x, p.y, p.depth, v.r, v.g, v.b, v.u, v.v};
  }
};

template <Effects effects>
using ClipperFor = TriangleClipper<clip_effects(effects)>;

}  // namespace zstrip::detail
