// Edges of a mesh in the picture: which of them show, where they lie, and how steeply their surface falls away.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/geometry/project.hpp"
#include "zstrip/geometry/segment.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// An edge that shows unless something hides it.
struct SeenEdge {
  WidePosition a, b;
  WidePosition third[2];  ///< of each face that is drawn a point off the edge
  int faces;              ///< how many are: 1 or 2
  bool crease;            ///< one lies on each side
  bool narrow;            ///< all of these points are
};

/// Twice the area of a triangle in 1/16 pixels squared, positive if it is counter-clockwise. Narrow: differences of 15
/// bits and a sign, products of 30, their sum of 31; else below 2^54.
template <class Int>
constexpr Int twice_area(const WidePosition& a, const WidePosition& b, const WidePosition& c) {
  return (Int{c.x} - a.x) * (Int{b.y} - a.y) - (Int{b.x} - a.x) * (Int{c.y} - a.y);
}

/// An instance's way to the picture, vertex by vertex.
template <bool orthographic>
struct EdgeProjection {
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

  /// For a face that leaves the narrow range or the depth range: twice the area of what is left of it, and in `third`
  /// its corner that lies farthest from the edge `ends`. Not inlined: its part of the stack is free again then.
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

/// Which faces of an edge are drawn, by their areas in the picture; none where the edge does not show. Shown is what
/// only one of two faces that face the viewer ends at, and a crease between two.
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

/// `third`: of the left face and of the right one.
template <class Int>
constexpr bool show(SeenEdge& seen, const Edge& edge, Int left_area, Int right_area, bool double_sided) {
  const ShownFaces shown(edge, left_area, right_area, double_sided);
  if (!shown.left) seen.third[0] = seen.third[1];
  seen.faces = shown.left && shown.right ? 2 : 1;
  seen.crease = seen.faces == 2 && (left_area > 0) == (right_area > 0);
  return shown.any();
}

/// As shows() and see(), of an edge whose faces leave the narrow range or the depth range.
template <bool orthographic>
[[gnu::noinline]] bool see_clipped(const EdgeProjection<orthographic>& projection, const Edge& edge, SeenEdge& seen) {
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

/// Returns true if an edge shows, by its corners, all of them narrow. `right`: of an edge with two faces.
inline bool shows(const Edge& edge, const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& left,
                  const SnappedVertex* right, bool double_sided) {
  const std::int32_t dx = b.x - a.x, dy = b.y - a.y;
  const auto area_to = [&](const SnappedVertex& c) { return (c.x - a.x) * dy - dx * (c.y - a.y); };
  return ShownFaces(edge, area_to(left), right == nullptr ? 0 : -area_to(*right), double_sided).any();
}

/// The first edge from `edge` on that may show: the others have two faces, all corners among the `count` vertices from
/// `first` on, all of these narrow, and do not show. Most edges do not: a loop that only looks for them.
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
    // True if just one of them is positive, by the sign of their negatives.
    if ((-of_left ^ -of_right) < 0 || a > b) return edge;
  }
  return edge;
}

/// How an edge shows that does, with its ends as they were projected. False if nothing of it is left.
template <bool orthographic>
bool see(const EdgeProjection<orthographic>& projection, const Edge& edge, const SnappedVertex& end_a,
         const SnappedVertex& end_b, SeenEdge& seen) {
  const auto wide = [](const SnappedVertex& v) { return WidePosition{v.x, v.y, v.depth}; };
  if (end_a.x == kNotNarrow || end_b.x == kNotNarrow) return see_clipped(projection, edge, seen);
  seen = {wide(end_a), wide(end_b), {wide(projection(edge.left))}, 1, false, true};
  const auto& [left, right] = seen.third;
  if (left.x == kNotNarrow) return see_clipped(projection, edge, seen);
  const std::int32_t left_area = twice_area<std::int32_t>(seen.a, seen.b, left);
  const bool double_sided = projection.instance.double_sided;
  // If the edge is no crease and only its left face is drawn, the right face is not needed.
  if (edge.right == kNoFace || (left_area > 0 && edge.a < edge.b && !double_sided)) return true;
  seen.third[1] = wide(projection(edge.right));
  if (right.x == kNotNarrow) return see_clipped(projection, edge, seen);
  return show(seen, edge, left_area, -twice_area<std::int32_t>(seen.a, seen.b, right), double_sided);
}

/// How many codes a face with the corner c falls in a pixel across the longer axis of the edge a to b; where it is
/// narrower than a quarter of that, in as much.
template <class Int>
std::uint32_t fall_of(const WidePosition& a, const WidePosition& b, const WidePosition& c) {
  // Depths are taken in eight codes, so that 32 bits are enough: 13 of depth times 15 of length, the sum within 2^30.
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

/// How many codes a cell within a pixel of the edge may lie off the edge's own depth and still be of its surface: what
/// the steeper of its faces falls there, and what all roundings are.
template <class Int>
std::uint32_t tolerance_of(const SeenEdge& seen) {
  std::uint32_t fall = fall_of<Int>(seen.a, seen.b, seen.third[0]);
  if (seen.faces == 2) fall = std::max(fall, fall_of<Int>(seen.a, seen.b, seen.third[1]));
  return fall + 12;
}

}  // namespace zstrip::detail
