// The lists of strips: what is listed is what divisions give, entry by entry, until the memory is full.
// Then whole pictures, strip by strip from their lists, against one that is drawn at once: strips in order, twice, left
// out and out of order, with much and with little memory behind the lists.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "contracts.hpp"
#include "meshlet.hpp"
#include "pictures.hpp"
#include "random.hpp"
#include "zstrip/geometry/bins.hpp"
#include "zstrip/geometry/extent.hpp"
#include "zstrip/kernels/list_faces.hpp"
#include "zstrip/raster/assemble.hpp"

namespace zstrip::kernels_test {
namespace {

using namespace detail;

constexpr std::uint16_t kBatches = 3;

alignas(8) std::array<std::byte, 16384> own_lists, portable_lists;

/// Whole rows of a picture that a meshlet lies in, or beside.
struct Rows {
  View view;
  Plan plan;
  Rect area;  ///< of the picture, in raster pixels
  StripGrid grid;

  Rows(std::int32_t width, std::int32_t height, std::int32_t strip_rows)
      : view{static_cast<std::uint16_t>(width), static_cast<std::uint16_t>(height)},
        plan{.strip_rows = static_cast<std::uint16_t>(strip_rows),
             .strip_columns = static_cast<std::uint16_t>(width),
             .strips = static_cast<std::uint16_t>((height + strip_rows - 1) / strip_rows)},
        area{-(width >> 1), -(height >> 1), width - (width >> 1), height - (height >> 1)},
        grid(plan, view, {0, 0, width, height}) {}

  std::uint32_t bytes(std::int32_t chunks) const {
    return plan.strips * kBinBytes + static_cast<std::uint32_t>(chunks) * kBinChunkBytes;
  }
  StripGrid::VertexRows of_vertices() const { return grid.vertex_rows(plan.strip_rows); }
};

/// list_faces with divisions, strip by strip.
bool list_by_division(Bins& bins, const Rows& rows, std::uint16_t batch, const Meshlet& meshlet, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const Triangle& triangle = meshlet.triangles[i];
    const auto vertex = [&](std::uint16_t index) { return meshlet.vertices[index - Meshlet::kFirstVertex]; };
    const SnappedVertex a = vertex(triangle.a), b = vertex(triangle.b), c = vertex(triangle.c);
    if (Assembler<kPortable>::Narrow::narrow_area(a, b, c) <= 0) continue;
    const std::int32_t first = (std::min({a.y, b.y, c.y}) >> 4) - rows.area.top;
    const std::int32_t last = (std::max({a.y, b.y, c.y}) >> 4) - rows.area.top - 1;
    const std::int32_t end = rows.plan.strips * rows.plan.strip_rows;
    if (last < 0 || first >= end) continue;
    std::int32_t strip = std::max<std::int32_t>(first, 0) / rows.plan.strip_rows;
    do {
      if (!bins.add(static_cast<std::uint32_t>(strip), batch, static_cast<std::uint16_t>(i))) return false;
    } while (++strip <= std::min(last, end - 1) / rows.plan.strip_rows);
  }
  return true;
}

/// Lists the meshlet in each of the batches; the later ones have less of it. False if the memory is full.
template <class List>
bool list_all(const List& list) {
  for (std::uint16_t batch = 0; batch < kBatches; ++batch) {
    if (!list(batch, static_cast<std::uint32_t>(Meshlet::kTriangles) / (batch + 1U))) return false;
  }
  return true;
}

Batch batch_of(const Meshlet& meshlet, const CompiledInstance& instance) {
  static constexpr Mesh kMesh{};
  return {.instance = &instance,
          .mesh = &kMesh,
          .vertices = meshlet.vertices.data(),
          .colours = meshlet.colours.data(),
          .first_vertex = Meshlet::kFirstVertex,
          .origin = {},
          .surface = {}};
}

void draw_strip(const Bins& bins, const Rows& rows, std::int32_t strip, const Batch& batch, const Meshlet& meshlet,
                StripTarget target) {
  const std::int32_t first = strip * rows.plan.strip_rows;
  target.depth += first * target.depth_stride;
  target.colour += first * target.colour_stride;
  target.area.bottom = std::min(target.area.bottom, target.area.top + first + rows.plan.strip_rows);
  target.area.top += first;
  Assembler<kOwn>::begin_listed(bins, target.area);
  for (BinReader list(bins, static_cast<std::uint32_t>(strip)); list.next_batch();) {
    Assembler<kOwn>::draw_listed(target, batch, meshlet.triangles, list, true);
  }
}

}  // namespace

Outcome compare_lists(std::uint32_t cases) {
  Random random(5);
  Outcome outcome;
  for (std::uint32_t number = 0; number < cases; ++number) {
    const Meshlet meshlet(random, number);
    const std::int32_t height = number % 9 == 0 ? 4096 : random.between(1, 2000);
    const Rows rows(320, height, random.between((height + 511) / 512, number % 7 == 0 ? height : (height + 3) / 4));
    const std::uint32_t bytes = rows.bytes(random.below(number % 5 == 0 ? 12 : 300));
    own_lists.fill(std::byte{});
    portable_lists.fill(std::byte{});
    Bins own(own_lists.data(), bytes, rows.plan.strips), portable(portable_lists.data(), bytes, rows.plan.strips);
    const bool own_has_room = list_all([&](std::uint16_t batch, std::uint32_t count) {
      FaceLists faces(own, rows.of_vertices(), batch, meshlet.vertices.data(), Meshlet::kFirstVertex);
      return list_faces(faces, meshlet.triangles.data(), count);
    });
    const bool has_room = list_all([&](std::uint16_t batch, std::uint32_t count) {
      return list_by_division(portable, rows, batch, meshlet, count);
    });
    if (own_has_room != has_room || own_lists != portable_lists ||
        own.has_newest(kBatches - 1) != portable.has_newest(kBatches - 1)) {
      outcome.differs("a list", number);
      return outcome;
    }
    for (std::uint32_t strip = 0; strip < rows.plan.strips; ++strip) {
      for (BinReader list(own, strip); list.next_batch();) {
        for (auto run = list.next_run(); !run.empty(); run = list.next_run()) {
          outcome.compared += static_cast<std::uint32_t>(run.size());
        }
      }
    }
  }
  return outcome;
}

Outcome compare_strips(std::uint32_t cases) {
  Random random(6);
  Outcome outcome;
  Statistics statistics{};
  for (std::uint32_t number = 0; number < cases; ++number) {
    Meshlet meshlet(random, number);
    const Pictures pictures(random, meshlet.width, meshlet.height, meshlet.code());
    const Rows rows(meshlet.width, meshlet.height, random.between(1, number % 3 == 0 ? 3 : meshlet.height));
    // The picture stands in the middle of all rows.
    for (SnappedVertex& vertex : meshlet.vertices) {
      vertex.x = static_cast<std::int16_t>(vertex.x + (rows.area.left - meshlet.left) * 16);
      vertex.y = static_cast<std::int16_t>(vertex.y + (rows.area.top - meshlet.top) * 16);
    }
    CompiledInstance instance{};
    instance.shade = Shade::gouraud;
    instance.coloured = true;
    const Batch batch = batch_of(meshlet, instance);
    const StripTarget whole = pictures.portable.target(rows.area.left, rows.area.top, &statistics);
    Assembler<kPortable>::draw(whole, batch, meshlet.triangles, true);

    Bins bins(own_lists.data(), rows.bytes(random.between(200, 240)), rows.plan.strips);
    FaceLists faces(bins, rows.of_vertices(), 0, meshlet.vertices.data(), Meshlet::kFirstVertex);
    if (!list_faces(faces, meshlet.triangles.data(), static_cast<std::uint32_t>(Meshlet::kTriangles))) {
      outcome.differs("the room of a picture", number);
      return outcome;
    }
    const StripTarget target = pictures.own.target(rows.area.left, rows.area.top, nullptr);
    if (number % 4 == 0) {
      for (int i = 0; i < 6; ++i) draw_strip(bins, rows, random.below(rows.plan.strips), batch, meshlet, target);
    }
    for (std::int32_t strip = 0; strip < rows.plan.strips; ++strip) {
      const int times = number % 3 == 0 ? random.between(1, 2) : 1;
      for (int i = 0; i < times; ++i) draw_strip(bins, rows, strip, batch, meshlet, target);
    }
    if (!pictures.equal()) {
      outcome.differs("a picture", number);
      return outcome;
    }
  }
  outcome.compared = statistics.drawn;
  return outcome;
}

}  // namespace zstrip::kernels_test
