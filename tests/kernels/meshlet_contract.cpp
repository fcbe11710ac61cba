// Whole meshlets by the assembler, in order and by lists: once with counting, which is portable.
#include <cstddef>
#include <cstdint>
#include <span>

#include "contracts.hpp"
#include "meshlet.hpp"
#include "pictures.hpp"
#include "random.hpp"
#include "zstrip/geometry/bins.hpp"
#include "zstrip/raster/assemble.hpp"

namespace zstrip::kernels_test {
namespace {

using namespace detail;

/// Flat ones without colours have that of their surface.
template <Effects effects>
void draw(const Meshlet& meshlet, const CompiledInstance& instance, const StripTarget& target, bool all_narrow) {
  constexpr Mesh kMesh{};
  const Batch batch{.instance = &instance,
                    .mesh = &kMesh,
                    .vertices = meshlet.vertices.data(),
                    .colours = instance.coloured ? meshlet.colours.data() : nullptr,
                    .first_vertex = Meshlet::kFirstVertex,
                    .origin = {},
                    .surface = {.flat_colour = 0x1234, .texture = {}, .depth_offset = 0}};
  const std::span<const Triangle> triangles(meshlet.triangles), half = triangles.first(Meshlet::kTriangles / 2);
  Assembler<effects>::draw(target, batch, half, all_narrow);
  // In one list what faces the viewer, in the other one anything, as if vertices were not narrow.
  alignas(8) std::byte memory[2 * kBinBytes + 16 * kBinChunkBytes];
  Bins bins(memory, sizeof memory, 2);
  for (const std::uint16_t index : meshlet.listed) {
    const bool shows = instance.double_sided || Assembler<effects>::Narrow::area_of(batch, triangles[index]) > 0;
    bins.add(shows ? 0 : 1, 0, index);
  }
  for (std::uint32_t strip = 0; strip < 2; ++strip) {
    Assembler<effects>::begin_listed(bins, target.area);
    for (BinReader list(bins, strip); list.next_batch();) {
      Assembler<effects>::draw_listed(target, batch, triangles, list, strip == 0);
    }
  }
}

}  // namespace

Outcome compare_meshlets(std::uint32_t cases) {
  Random random(4);
  Outcome outcome;
  Statistics statistics{};
  for (std::uint32_t number = 0; number < cases; ++number) {
    const Meshlet meshlet(random, number);
    const Pictures pictures(random, meshlet.width, meshlet.height, meshlet.code());
    CompiledInstance instance{};
    instance.shade = number / 12 % 3 == 2 ? Shade::flat : Shade::gouraud;
    instance.coloured = instance.shade != Shade::flat || number % 2 == 0;
    instance.double_sided = number / 5 % 5 == 0;
    const bool all_narrow = number % 7 != 0;
    draw<kPortable>(meshlet, instance, pictures.portable.target(meshlet.left, meshlet.top, &statistics), all_narrow);
    draw<kOwn>(meshlet, instance, pictures.own.target(meshlet.left, meshlet.top, nullptr), all_narrow);
    if (!pictures.equal()) {
      outcome.differs("a meshlet", number);
      return outcome;
    }
  }
  outcome.compared = statistics.drawn;
  return outcome;
}

}  // namespace zstrip::kernels_test
