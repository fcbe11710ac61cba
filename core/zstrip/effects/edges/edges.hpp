// Edges of a mesh in the picture: finds the visible ones, their position, and how steep the depth of their surface is.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/geometry/project.hpp"
#include "zstrip/geometry/segment.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// An edge that is visible unless another surface hides it.
struct SeenEdge {
  WidePosition a, b;
  WidePosition third[2];  ///< for each drawn face, a point that is not on the edge
  int faces;              ///< number of drawn faces, 1 or 2
  bool crease;            ///< the faces lie on different sides of the edge
  bool narrow;            ///< all of these points are narrow
};

/// Returns twice the area of a triangle in 1/256 square pixels, positive if it is counter-clockwise. Narrow:
/// differences of 15 bits and a sign, products of 30, their sum of 31; else below 2^54.
template <class Int>
constexpr Int twice_area(const WidePosition& a, const WidePosition& b, const WidePosition& c) {
  return (Int{c.x} - a.x) * (Int{b.y} - a.y) - (Int{b.x} - a.x) * (Int{c.y} - a.y);
}

/// Projects an instance's vertices one by one. `clips`: a corner of an edge's faces may leave the narrow range or the
/// depth range.
template <bool orthographic, bool clips>
struct EdgeProjection {
  static constexpr bool kClips = clips;

  const CompiledInstance& instance;
  const Mesh& mesh;
  const RasterOrigin& origin;
  NarrowProjection<orthographic> narrow{instance, origin};

  SnappedVertex operator()(std::uint32_t vertex) const {
    const Position& p = mesh.positions[vertex];
    SnappedVertex snapped;
    if (!project_narrow<orthographic>(narrow, instance, origin, instance.x.at(p), instance.y.at(p), instance.w.at(p),
                                      snapped)) {
      return {kNotNarrow, 0, 0};
    }
    return snapped;
  }

  /// For a face that leaves the narrow range or the depth range: returns twice the area of its clipped polygon, and
  /// sets `third` to the polygon's corner that is farthest from the edge `ends`. Not inlined, so that its stack is free
  /// again afterwards.
  [[gnu::noinline]] std::int64_t clipped_face(const std::uint16_t (&corners)[3], const SnappedSegment& ends,
                                              WidePosition& third) const {
    ClipPolygon clipped;
    clipped.count = 3;
    for (int i = 0; i < 3; ++i) {
      const Position& p = mesh.positions[corners[i]];
      const auto wide = [&p](const LinearForm& form) { return std::int64_t{form.at(p)} * (1 << kClipBits); };
      clipped.vertices[i] = {wide(instance.x), wide(instance.y), wide(instance.w), 0, 0, 0, 0, 0};
    }
    if constexpr (orthographic) {
      clip_orthographic(clipped, instance);
    } else {
      clip_perspective(clipped, instance);
    }
    if (clipped.count == 0) return 0;
    std::int64_t area = 0, farthest = -1;
    WidePosition first{}, before{};
    for (int i = 0; i < clipped.count; ++i) {
      const auto corner = project_clipped<orthographic, DepthFormat::z16>(instance, origin, clipped.vertices[i]);
      if (i == 0) {
        first = corner;
      } else {
        area += twice_area<std::int64_t>(first, before, corner);
      }
      before = corner;
      const std::int64_t off = twice_area<std::int64_t>(ends.a, ends.b, corner);
      if (std::max(off, -off) > farthest) farthest = std::max(off, -off), third = corner;
    }
    return area;
  }
};

/// The faces of an edge that are drawn, from their areas in the picture; none if the edge is not shown. An edge is
/// shown if exactly one of its two faces faces the viewer, or if it is a crease between two such faces.
struct ShownFaces {
  bool left, right;

  template <class Int>
  constexpr ShownFaces(const Edge& edge, Int left_area, Int right_area, bool double_sided)
      : left(left_area > 0), right(right_area > 0) {
    if (edge.right == kNoFace) {
      left = left_area > 0 || (double_sided && left_area < 0);
      right = false;
      return;
    }
    if (left != right) {
      if (double_sided) left = left_area != 0, right = right_area != 0;
      return;
    }
    left = right = edge.a > edge.b && (left || (double_sided && left_area < 0 && right_area < 0));
  }
  constexpr bool any() const { return left || right; }
};

/// Sets the faces of `seen`; `third` has the points of the left and the right face. Returns true if the edge is shown.
template <class Int>
constexpr bool show(SeenEdge& seen, const Edge& edge, Int left_area, Int right_area, bool double_sided) {
  const ShownFaces shown(edge, left_area, right_area, double_sided);
  if (!shown.left) seen.third[0] = seen.third[1];
  seen.faces = shown.left && shown.right ? 2 : 1;
  seen.crease = seen.faces == 2 && (left_area > 0) == (right_area > 0);
  return shown.any();
}

/// Does the work of shows() and see() for an edge whose faces leave the narrow range or the depth range.
template <bool orthographic>
[[gnu::noinline]] bool see_clipped(const EdgeProjection<orthographic, true>& projection, const Edge& edge,
                                   SeenEdge& seen) {
  SnappedSegment ends;
  const auto& positions = projection.mesh.positions;
  if (!clip_segment<orthographic, DepthFormat::z16>(projection.instance, projection.origin, positions[edge.a],
                                                    positions[edge.b], false, ends)) {
    return false;
  }
  seen = {ends.a, ends.b, {}, 0, false, false};
  const std::int64_t left = projection.clipped_face({edge.a, edge.b, edge.left}, ends, seen.third[0]);
  const std::int64_t right =
      edge.right == kNoFace ? 0 : projection.clipped_face({edge.b, edge.a, edge.right}, ends, seen.third[1]);
  return show(seen, edge, left, right, projection.instance.double_sided);
}

/// Returns true if an edge is shown; all its corners are narrow. `right` is null for an edge with one face.
inline bool shows(const Edge& edge, const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& left,
                  const SnappedVertex* right, bool double_sided) {
  const std::int32_t dx = b.x - a.x, dy = b.y - a.y;
  const auto area_to = [&](const SnappedVertex& c) { return (c.x - a.x) * dy - dx * (c.y - a.y); };
  return ShownFaces(edge, area_to(left), right == nullptr ? 0 : -area_to(*right), double_sided).any();
}

/// Returns the first edge from `edge` on that may be shown. Skipped edges have two faces with all corners among the
/// `count` narrow vertices from `first` on, and are not shown. Most edges are skipped, so that this loop only searches.
[[gnu::noinline]] inline const Edge* next_that_may_show(const Edge* edge, const Edge* end,
                                                        const SnappedVertex* vertices, std::uint32_t first,
                                                        std::uint32_t count) {
  for (; edge != end; ++edge) {
    const std::uint32_t a = edge->a - first, b = edge->b - first;
    const std::uint32_t left = edge->left - first, right = edge->right - first;
    if (a >= count || b >= count || left >= count || right >= count) return edge;
    const std::int32_t ax = vertices[a].x, ay = vertices[a].y;
    const std::int32_t dx = vertices[b].x - ax, dy = vertices[b].y - ay;
    const std::int32_t of_left = (vertices[left].x - ax) * dy - (vertices[left].y - ay) * dx;
    const std::int32_t of_right = (vertices[right].y - ay) * dx - (vertices[right].x - ax) * dy;
    // The sign bit is set if exactly one of the two is positive.
    if ((-of_left ^ -of_right) < 0 || a > b) return edge;
  }
  return edge;
}

/// Computes how a shown edge is seen; its ends are already projected. Returns false if it is completely clipped.
template <class Projection>
bool see(const Projection& projection, const Edge& edge, const SnappedVertex& end_a, const SnappedVertex& end_b,
         SeenEdge& seen) {
  const auto wide = [](const SnappedVertex& v) { return WidePosition{v.x, v.y, v.depth}; };
  const auto is_wide = [](const auto& corner) { return Projection::kClips && corner.x == kNotNarrow; };
  const auto clipped = [&] {
    if constexpr (Projection::kClips) return see_clipped(projection, edge, seen);
    return false;
  };
  if (is_wide(end_a) || is_wide(end_b)) return clipped();
  seen = {wide(end_a), wide(end_b), {wide(projection(edge.left))}, 1, false, true};
  const auto& [left, right] = seen.third;
  if (is_wide(left)) return clipped();
  const std::int32_t left_area = twice_area<std::int32_t>(seen.a, seen.b, left);
  const bool double_sided = projection.instance.double_sided;
  // If the edge is not a crease and only its left face is drawn, the right face is not needed.
  if (edge.right == kNoFace || (left_area > 0 && edge.a < edge.b && !double_sided)) return true;
  seen.third[1] = wide(projection(edge.right));
  if (is_wide(right)) return clipped();
  return show(seen, edge, left_area, -twice_area<std::int32_t>(seen.a, seen.b, right), double_sided);
}

/// Returns how many codes the depth of a face with the corner c changes in one pixel across the longer axis of the edge
/// a to b. For a face narrower than a quarter of a pixel it returns the change over the face.
template <class Int>
std::uint32_t fall_of(const WidePosition& a, const WidePosition& b, const WidePosition& c) {
  // Depths are in units of eight codes, for 32 bits: 13 bits of depth times 15 of length, the sum within 2^30.
  constexpr int kCodeBits = 3;
  const auto depth = [](const WidePosition& p) { return static_cast<std::int32_t>(p.depth >> (16 + kCodeBits)); };
  const Int dx = Int{b.x} - a.x, dy = Int{b.y} - a.y;
  const bool columns = std::max(dx, -dx) >= std::max(dy, -dy);
  const Int length = columns ? dx : dy;
  const Int along = columns ? Int{c.x} - a.x : Int{c.y} - a.y;
  const Int fall = (depth(c) - depth(a)) * length - (depth(b) - depth(a)) * along;
  const Int area = twice_area<Int>(a, b, c);
  const Int quarter = 4 * std::max(length, -length);
  const Int width = std::max(std::max(area, -area), quarter) >> 4;
  const Int codes = std::max(fall, -fall) / std::max(width, Int{1});
  return static_cast<std::uint32_t>(std::min(codes, Int{0xFFFF >> kCodeBits})) << kCodeBits;
}

/// Returns how many codes a cell within a pixel of the edge may differ from the edge's depth and still belong to its
/// surface: the change of the steeper face over a pixel, plus all roundings.
template <class Int>
std::uint32_t tolerance_of(const SeenEdge& seen) {
  std::uint32_t fall = fall_of<Int>(seen.a, seen.b, seen.third[0]);
  if (seen.faces == 2) fall = std::max(fall, fall_of<Int>(seen.a, seen.b, seen.third[1]));
  return fall + 12;
}

}  // namespace zstrip::detail
