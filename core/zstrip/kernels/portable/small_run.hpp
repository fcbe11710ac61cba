// Draws runs of small triangles in C++, one triangle at a time. This defines what a run must draw: the core uses runs
// only if the processor has an implementation that is faster than the assembler's loop, and tests compare that one with
// this one.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/portable/small_triangle.hpp"
#include "zstrip/pixels/small_scan.hpp"
#include "zstrip/pixels/target.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace zstrip::detail {

/// Values that the triangles of a meshlet share.
struct PortableSmallRun {
  const StripTarget& target;
  const SnappedVertex* vertices;
  const Colour* colours;
  std::uint32_t first_vertex;

  /// `vertices` and `colours` begin with mesh vertex `first_vertex`.
  PortableSmallRun(const StripTarget& strip, const SnappedVertex* first_of_vertices, const Colour* first_of_colours,
                   std::uint32_t first)
      : target(strip), vertices(first_of_vertices), colours(first_of_colours), first_vertex(first) {}
};

inline std::uint32_t draw_small_run_portable(const PortableSmallRun& run, const Triangle* triangles,
                                             std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    std::uint32_t a = triangles[i].a - run.first_vertex;
    std::uint32_t b = triangles[i].b - run.first_vertex;
    std::uint32_t c = triangles[i].c - run.first_vertex;
    const SnappedVertex &at_a = run.vertices[a], &at_b = run.vertices[b], &at_c = run.vertices[c];
    const std::int32_t area = (at_c.x - at_a.x) * (at_b.y - at_a.y) - (at_b.x - at_a.x) * (at_c.y - at_a.y);
    if (area <= 0) continue;
    const auto [min_x, max_x] = std::minmax<std::int32_t>({at_a.x, at_b.x, at_c.x});
    const auto [min_y, max_y] = std::minmax<std::int32_t>({at_a.y, at_b.y, at_c.y});
    const Rect box = Rect{min_x >> 4, min_y >> 4, max_x >> 4, max_y >> 4}.cut_to(run.target.area);
    if (box.empty()) continue;
    // The uppermost vertex comes first; if several are, the leftmost of them. Otherwise the order of indices would
    // change the rounding.
    const auto comes_before = [&run](std::uint32_t one, std::uint32_t other) {
      const SnappedVertex &v = run.vertices[one], &w = run.vertices[other];
      return v.y != w.y ? v.y < w.y : v.x < w.x;
    };
    while (comes_before(b, a) || comes_before(c, a)) {
      const std::uint32_t first = std::exchange(a, b);
      b = std::exchange(c, first);
    }
    const SnappedVertex &v0 = run.vertices[a], &v1 = run.vertices[b], &v2 = run.vertices[c];
    if (!is_small(max_x - min_x, max_y - min_y, v0, v1, v2)) return i;
    const Colour* const colours[3] = {run.colours + a, run.colours + b, run.colours + c};
    draw_small_triangle_portable<true, false>(run.target, v0, v1, v2, colours, 0, area, min_x >> 4, min_y >> 4, box);
  }
  return count;
}

}  // namespace zstrip::detail
