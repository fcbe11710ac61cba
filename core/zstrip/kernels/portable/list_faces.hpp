// Adds front faces to the lists of their strips, in C++.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/geometry/bins.hpp"
#include "zstrip/geometry/extent.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// Values that the triangles of a meshlet share. The assembly depends on the order of the members.
struct FaceLists {
  std::int32_t for_top, for_bottom;  ///< are added to y: StripGrid::VertexRows::centre_y, and centre_y minus a pixel
  std::uint32_t inverse;
  std::int32_t strips;
  BinList* lists;
  std::uint16_t* slots;
  std::uint32_t batch;
  Bins* bins;
  std::uintptr_t vertices;  ///< the address of the mesh's vertex 0, although the cache holds only a run of vertices
  std::uint32_t last = 0;   ///< the last triangle; used by the assembly
  std::int32_t end;

  FaceLists(Bins& in, const StripGrid::VertexRows& rows, std::uint16_t number, const SnappedVertex* first_of_vertices,
            std::uint32_t first_vertex)
      : for_top(rows.centre_y),
        for_bottom(rows.centre_y - 16),
        inverse(rows.inverse),
        strips(rows.strips),
        lists(in.lists()),
        slots(in.slots()),
        batch(number),
        bins(&in),
        vertices(reinterpret_cast<std::uintptr_t>(first_of_vertices) - first_vertex * sizeof(SnappedVertex)),
        end(rows.end) {}
};

inline bool list_faces_portable(FaceLists& faces, const Triangle* triangles, std::uint32_t count) {
  Bins bins = *faces.bins;  // the members of a copy can stay in registers
  const std::uintptr_t vertices = faces.vertices;
  const auto vertex = [vertices](std::uint32_t index) -> const SnappedVertex& {
    return *reinterpret_cast<const SnappedVertex*>(  // NOLINT(performance-no-int-to-ptr)
        vertices + index * sizeof(SnappedVertex));
  };
  const std::int32_t for_top = faces.for_top, for_bottom = faces.for_bottom, end = faces.end;
  // Multiplies halves, which suffices because y has 16 bits: some processors have no long product.
  const std::uint32_t inverse_high = faces.inverse >> 16, inverse_low = faces.inverse & 0xFFFF;
  const auto strip_at = [inverse_high, inverse_low](std::int32_t y) {
    const auto positive = static_cast<std::uint32_t>(y);
    return (positive * inverse_high + (positive * inverse_low >> 16)) >> 16;
  };
  const auto batch = static_cast<std::uint16_t>(faces.batch);
  bool has_room = true;
  for (std::uint32_t i = 0; i < count && has_room; ++i) {
    const SnappedVertex& a = vertex(triangles[i].a);
    const SnappedVertex& b = vertex(triangles[i].b);
    const SnappedVertex& c = vertex(triangles[i].c);
    const std::int32_t a_y = a.y, b_y = b.y, c_y = c.y;
    if ((c.x - a.x) * (b_y - a_y) <= (b.x - a.x) * (c_y - a_y)) continue;
    std::int32_t top = std::min(std::min(a_y, b_y), c_y) + for_top;
    std::int32_t bottom = std::max(std::max(a_y, b_y), c_y) + for_bottom;
    if (top < 0 || bottom < 0 || top >= end || bottom >= end) {
      if (bottom < 0 || top >= end) continue;
      if (top < 0) top = 0;
      if (bottom >= end) bottom = end - 1;
    }
    std::uint32_t strip = strip_at(top);
    const std::uint32_t last = strip_at(bottom);
    do {
      has_room = bins.add(strip, batch, static_cast<std::uint16_t>(i));
    } while (has_room && ++strip <= last);
  }
  *faces.bins = bins;
  return has_room;
}

}  // namespace zstrip::detail
