// Outlines: instances of a hull whose vertices are moved outwards, and of which only the far side is drawn.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/camera.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace zstrip::detail {

/// The value of CompiledInstance::light_count that marks an outline. An outline has no lights. Instead, lights[0], [1]
/// and [2] hold the directions to the picture's right, down and away from the viewer in object space, 1.14, with the
/// length of a unit normal; lights[3].x and .y hold the width to the right and down in 1/16 raster pixels; lights[3].z
/// << lights[3].r is the distance that a normal's length moves away, in 1/2^30 of the distance, or in steps of w if
/// orthographic.
inline constexpr std::uint8_t kOutlineLights = kMaxLights + 1;

constexpr bool is_outline(const CompiledInstance& instance) { return instance.light_count == kOutlineLights; }

/// Returns the triangle with its back as its front, so that faces which face away are drawn.
constexpr Triangle turned_round(const Triangle& triangle) { return {triangle.a, triangle.c, triangle.b}; }

struct HullVertex {
  std::int32_t right, down;  ///< added to its raster coordinates, 1/16 pixels; below 2^12 for any normal
  std::int32_t w;            ///< distance, in the scale of the instance's form; below 2^30
};

template <bool orthographic>
inline HullVertex hull_vertex(const CompiledInstance& instance, const Mesh& mesh, std::uint32_t index) {
  constexpr std::int32_t kOne = 1 << 14;
  const Normal& n = mesh.normals[index];
  // Below 2^14.9, because three components may be 128: the sum of two squares is below 2^30.5.
  const auto along = [&n](const ObjectLight& axis) { return (n.x * axis.x + n.y * axis.y + n.z * axis.z) >> 7; };
  const std::int32_t right = along(instance.lights[0]), down = along(instance.lights[1]);
  // A silhouette's normal is shorter in the picture if it is seen from the side. The vertex is then moved less in
  // space, so that the outline keeps its width. The root of the square is one step of Newton's method from 1.
  const std::int32_t square = (right * right + down * down) >> 14;
  const std::int32_t share = square < kOne ? (kOne + square) >> 1 : kOne;
  const auto [width_x, width_y, reach, shift] = [&instance] {
    const ObjectLight& l = instance.lights[3];
    struct Moves {
      std::int32_t width_x, width_y, reach, shift;
    };
    return Moves{l.x, l.y, l.z, l.r};
  }();
  const std::int32_t away = ((along(instance.lights[2]) * share) >> 14) * reach >> (14 - shift);
  const std::int32_t w = instance.w.at(mesh.positions[index]);
  std::int64_t moved = std::int64_t{w} + away;
  if constexpr (!orthographic) moved = w + ((std::int64_t{w} * away) >> 30);
  const auto on_screen = [&](std::int32_t component, std::int32_t width) {
    std::int32_t part = (component * share) >> 14;
    if constexpr (!orthographic) part -= (part * (away >> 16)) >> 14;  // parts that move away become smaller
    return (part * width + kOne / 2) >> 14;
  };
  HullVertex vertex{on_screen(right, width_x), on_screen(down, width_y), 0};
  constexpr std::int64_t kMax = (std::int64_t{1} << 30) - 1;
  vertex.w = static_cast<std::int32_t>(std::clamp(moved, -kMax, kMax));
  return vertex;
}

/// Does the same as transform_vertices for a hull.
template <bool orthographic, DepthFormat format>
[[gnu::noinline]] bool transform_hull(const CompiledInstance& instance, const Mesh& mesh, const RasterOrigin& origin,
                                      std::uint32_t first, std::uint32_t count, SnappedVertex* vertices) {
  const NarrowProjection<orthographic> narrow(instance, origin);
  bool all_narrow = true;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Position& p = mesh.positions[first + i];
    const HullVertex moved = hull_vertex<orthographic>(instance, mesh, first + i);
    SnappedVertex vertex{};
    bool is_narrow = project_narrow<orthographic, format>(narrow, instance, origin, instance.x.at(p), instance.y.at(p),
                                                          moved.w, vertex);
    const std::int32_t x = vertex.x + moved.right, y = vertex.y + moved.down;
    is_narrow = is_narrow && x >= -kNarrowLimit && x < kNarrowLimit && y >= -kNarrowLimit && y < kNarrowLimit;
    vertices[i] = is_narrow ? SnappedVertex{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), vertex.depth}
                            : SnappedVertex{kNotNarrow, 0, 0};
    all_narrow = all_narrow && is_narrow;
  }
  return all_narrow;
}

/// Returns the distances of a box, extended by the hull of an outline `width` (1/16 pixels) wide.
DistanceRange with_outline(const DistanceRange& range, std::uint16_t width, const Camera& camera, const View& view);

/// Makes an outline of its compiled hull. `view` is the picture of samples if pixels have several.
void make_outline(CompiledInstance& hull, const Outline& outline, const Transform& transform, const Camera& camera,
                  const View& view, const DepthFit& fit);

}  // namespace zstrip::detail
