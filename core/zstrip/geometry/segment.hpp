// Projects a segment from its vertices to the picture, clipped and snapped like the corners of triangles.
#pragma once

#include "zstrip/geometry/clip.hpp"
#include "zstrip/geometry/instance.hpp"
#include "zstrip/geometry/project.hpp"

namespace zstrip::detail {

/// The ends of a segment, or a point twice, clipped and snapped like triangles. Depth as in project_depth.
struct SnappedSegment {
  WidePosition a, b;
};

template <bool orthographic, DepthFormat format>
WidePosition project_clipped(const CompiledInstance& instance, const RasterOrigin& origin, const ClipVertex& vertex) {
  WidePosition position = project_wide<orthographic>(instance, origin, vertex);
  if constexpr (format != DepthFormat::z16) {
    position.depth = project_wide_depth<orthographic, format>(instance, origin, vertex);
  }
  return position;
}

/// Clips a segment that leaves the narrow range or the depth range. Returns false if nothing is left. Not inlined, so
/// that its stack is free again while pixels are drawn.
template <bool orthographic, DepthFormat format>
[[gnu::noinline]] bool clip_segment(const CompiledInstance& instance, const RasterOrigin& origin, const Position& a,
                                    const Position& b, bool is_point, SnappedSegment& snapped) {
  const auto vertex = [&instance](const Position& p) {
    const auto wide = [&p](const LinearForm& form) { return std::int64_t{form.at(p)} * (1 << kClipBits); };
    return ClipVertex{wide(instance.x), wide(instance.y), wide(instance.w), 0, 0, 0, 0, 0};
  };
  ClipPolygon clipped;
  clipped.vertices[0] = vertex(a);
  clipped.vertices[1] = vertex(b);
  clipped.count = is_point ? 1 : 2;
  if constexpr (orthographic) {
    clip_orthographic(clipped, instance);
  } else {
    clip_perspective(clipped, instance);
  }
  if (clipped.count == 0) return false;
  snapped.a = project_clipped<orthographic, format>(instance, origin, clipped.vertices[0]);
  snapped.b =
      clipped.count == 1 ? snapped.a : project_clipped<orthographic, format>(instance, origin, clipped.vertices[1]);
  return true;
}

/// Returns false if the segment lies outside the clip volume.
template <bool orthographic, DepthFormat format>
bool snap_segment(const CompiledInstance& instance, const NarrowProjection<orthographic>& narrow,
                  const RasterOrigin& origin, const Position& a, const Position& b, bool is_point,
                  SnappedSegment& snapped) {
  const auto snaps = [&](const Position& p, WidePosition& position) {
    SnappedVertex vertex;
    if (!project_narrow<orthographic, format>(narrow, instance, origin, instance.x.at(p), instance.y.at(p),
                                              instance.w.at(p), vertex)) {
      return false;
    }
    position = {vertex.x, vertex.y, vertex.depth};
    return true;
  };
  if (!snaps(a, snapped.a) || !snaps(b, snapped.b)) {
    return clip_segment<orthographic, format>(instance, origin, a, b, is_point, snapped);
  }
  return true;
}

}  // namespace zstrip::detail
