// Finds the triangles of a meshlet that face the viewer, for the stages before drawing: extents, bins, sorting.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "zstrip/raster/assemble.hpp"
#include "zstrip/raster/raster_effects.hpp"

namespace zstrip::detail {

/// The raster pixels that a triangle of narrow vertices can cover, computed on demand: bins of rows never use columns.
struct NarrowPixels {
  const SnappedVertex &a, &b, &c;

  std::int32_t top() const { return least(a.y, b.y, c.y) >> 4; }
  std::int32_t bottom() const { return greatest(a.y, b.y, c.y) >> 4; }
  /// Returns the pixels; the rectangle may be empty.
  Rect box() const { return {least(a.x, b.x, c.x) >> 4, top(), greatest(a.x, b.x, c.x) >> 4, bottom()}; }

 private:
  // These compare whole words because halfwords would be extended for every comparison.
  static std::int32_t least(std::int32_t i, std::int32_t j, std::int32_t k) { return std::min(std::min(i, j), k); }
  static std::int32_t greatest(std::int32_t i, std::int32_t j, std::int32_t k) { return std::max(std::max(i, j), k); }
};

/// The rows of a strip, for triangles of narrow vertices.
class NarrowRows {
 public:
  explicit NarrowRows(const Rect& area) : first_((area.top + 1) * 16), end_(area.bottom * 16) {}
  /// True if NarrowPixels has no row of these. Signs decide, without a maximum or minimum.
  bool miss(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& c) const {
    const std::int32_t all_above = (a.y - first_) & (b.y - first_) & (c.y - first_);  // negative if it is so
    const std::int32_t one_above_end = (a.y - end_) | (b.y - end_) | (c.y - end_);
    return (one_above_end & ~all_above) >= 0;
  }

 private:
  std::int32_t first_, end_;  // sub-pixels
};
/// Takes the place of NarrowRows where all rows count.
struct AllRows {
  static bool miss(const SnappedVertex&, const SnappedVertex&, const SnappedVertex&) { return false; }
};

struct ClippedPixels {
  Rect pixels;

  std::int32_t top() const { return pixels.top; }
  std::int32_t bottom() const { return pixels.bottom; }
  Rect box() const { return pixels; }
};

/// Draws the triangles of a renderer with these effects.
template <Effects effects>
using AssemblerFor = Assembler<raster_effects(effects)>;

template <Effects effects>
struct Facing {
  using Assembler = AssemblerFor<effects>;

  /// Calls visit(index, pixels) for each triangle that faces the viewer, until visit returns false; returns false then.
  /// `pixels` is a NarrowPixels or a ClippedPixels. `all_narrow`: no vertex of the batch needs the clipping path.
  /// Narrow triangles that miss `rows` are left out first of all, as most do in strips of few rows.
  template <class Visit, class Rows = AllRows>
  static bool for_each(const BatchOf<effects>& batch, std::span<const Triangle> triangles, bool all_narrow,
                       const Visit& visit, const Rows& rows = {}) {
    const auto in_order = [](const Triangle& triangle) -> const Triangle& { return triangle; };
    if constexpr (effects.has(effect::outlines)) {
      if (is_outline(*batch.instance)) {
        const auto turned = [](const Triangle& triangle) { return turned_round(triangle); };
        return for_each<false>(batch, triangles, turned, rows, visit);
      }
    }
    if constexpr (!Assembler::kUnclipped) {
      if (!all_narrow) return for_each<false>(batch, triangles, in_order, rows, visit);
    }
    return for_each<true>(batch, triangles, in_order, rows, visit);
  }

 private:
  template <bool all_narrow, class Turn, class Rows, class Visit>
  static bool for_each(const BatchOf<effects>& batch, std::span<const Triangle> triangles, const Turn& turn,
                       const Rows& rows, const Visit& visit) {
    // The address of the mesh's vertex 0, although the cache holds only a run of vertices.
    const std::uintptr_t vertices =
        reinterpret_cast<std::uintptr_t>(batch.vertices) - batch.first_vertex * sizeof(SnappedVertex);
    const auto vertex = [vertices](std::uint32_t index) -> const SnappedVertex& {
      return *reinterpret_cast<const SnappedVertex*>(  // NOLINT(performance-no-int-to-ptr)
          vertices + index * sizeof(SnappedVertex));
    };
    const bool double_sided = Assembler::Narrow::shows_both_sides(batch);
    std::uint32_t i = 0;
    for (const Triangle& listed : triangles) {
      const Triangle& triangle = turn(listed);
      const std::uint32_t index = i++;
      const SnappedVertex& a = vertex(triangle.a);
      const SnappedVertex& b = vertex(triangle.b);
      const SnappedVertex& c = vertex(triangle.c);
      if constexpr (!all_narrow) {
        if (!Assembler::Narrow::is_narrow(a, b, c)) {
          RasterPolygon polygon;
          if (ClipperFor<effects>::clip(batch, triangle, polygon) && !visit(index, ClippedPixels{polygon.box()})) {
            return false;
          }
          continue;
        }
      }
      if (rows.miss(a, b, c)) continue;
      const std::int32_t area = Assembler::Narrow::narrow_area(a, b, c);
      if (area <= 0 && (area == 0 || !double_sided)) continue;
      if (!visit(index, NarrowPixels{a, b, c})) return false;
    }
    return true;
  }
};

}  // namespace zstrip::detail
