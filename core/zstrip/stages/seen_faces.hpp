// Lights only the vertices of front faces that a strip shows: on average these are less than half of a meshlet's, and
// light takes more than the rest of a vertex.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "zstrip/base/processor.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/geometry/meshlet_range.hpp"
#include "zstrip/pixels/target.hpp"
#include "zstrip/plan/record_bytes.hpp"
#include "zstrip/raster/facing.hpp"

namespace zstrip::detail {

/// True if only light reads the normals of vertices: with outlines or light at pixels it would be up to 2 KB more code
/// for nothing. Pipelines that count have all effects, and light as a board's program for the scene does. For size only
/// skins are lit so: half a kilobyte of code less.
constexpr bool lights_seen_vertices(Effects effects) {
  return has_vertex_colours(effects) &&
         (effects.has(effect::statistics) || !effects.any(effect::outlines | effect::pixel_shading)) &&
         (!kForSize || effects.has(effect::skins));
}

/// Meshlets with more vertices are lit as a whole; so are meshlets that need clipping.
inline constexpr std::uint32_t kMaxSeenVertices = 256;

template <Effects effects>
bool lights_seen_vertices(const BatchOf<effects>& batch, const MeshletRange& range, bool all_narrow) {
  bool shaded = batch.instance->lit;
  if constexpr (effects.has(effect::environment)) shaded = shaded || batch.reflections != nullptr;
  return (all_narrow || AssemblerFor<effects>::kUnclipped) && shaded && range.vertex_count <= kMaxSeenVertices;
}

/// The vertices of a meshlet that are lit, and those that still have to be.
class SeenVertices {
 public:
  void want(std::uint32_t place) { wanted_[place / 32] |= std::uint32_t{1} << place % 32; }

  /// Calls light(place, count) for the runs of wanted vertices that are not yet lit.
  template <class Light>
  void light_wanted(const Light& light) {
    for (std::uint32_t word = 0; word < kMaxSeenVertices / 32; ++word) {
      std::uint32_t dark = wanted_[word] & ~lit_[word];
      lit_[word] |= dark;
      for (std::uint32_t place = word * 32; dark != 0;) {
        const int skipped = std::countr_zero(dark);
        dark >>= skipped;
        place += static_cast<std::uint32_t>(skipped);
        const int count = std::countr_one(dark);
        light(place, static_cast<std::uint32_t>(count));
        if (count == 32) break;
        dark >>= count;
        place += static_cast<std::uint32_t>(count);
      }
    }
  }

 private:
  std::array<std::uint32_t, kMaxSeenVertices / 32> wanted_{}, lit_{};
};

/// Calls light(place, count) for the vertices of front faces that may have pixels in the rows of `area`, once for each
/// vertex, counted from the meshlet's first one; and draw(triangles) for these faces, in order, a few at a time, whose
/// vertices are lit by then. No vertex may need the clipping path.
template <Effects effects, class Light, class Draw>
void for_seen_faces(const BatchOf<effects>& batch, const MeshletRange& range, const Rect& area, const Light& light,
                    const Draw& draw) {
  SeenVertices vertices;
  std::array<Triangle, 16> seen;  // on the stack
  std::size_t count = 0;
  const auto draw_seen = [&] {
    vertices.light_wanted(light);
    draw(std::span<const Triangle>(seen.data(), count));
    count = 0;
  };
  const auto visit = [&](std::uint32_t index, const auto& covered) {
    // A triangle without a pixel between its columns is rare here; a later test drops it.
    if (covered.top() == covered.bottom()) return true;
    const Triangle& triangle = range.triangles[index];
    vertices.want(triangle.a - range.first_vertex);
    vertices.want(triangle.b - range.first_vertex);
    vertices.want(triangle.c - range.first_vertex);
    Triangle& next = seen[count++];
    next.a = triangle.a, next.b = triangle.b, next.c = triangle.c;  // GCC would call memcpy to copy the whole struct
    if (count == seen.size()) draw_seen();
    return true;
  };
  Facing<effects>::for_each(batch, range.triangles, true, visit, NarrowRows(area));
  if (count != 0) draw_seen();
}

}  // namespace zstrip::detail
