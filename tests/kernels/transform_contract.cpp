// Vertices of random instances: of the sizes that compile_instance makes, and of any size with coefficients at the
// edges of what an implementation takes. Positions reach the ends of their range; vertices lie just on the near plane,
// on the far one, behind, beyond and beside the narrow range.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "contracts.hpp"
#include "random.hpp"
#include "zstrip/geometry/instance.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/transform.hpp"

namespace zstrip::kernels_test {
namespace {

using namespace detail;

constexpr std::uint32_t kVertices = 40;
using Vertices = std::array<SnappedVertex, kVertices + 1>;  // one more, which must stay

Position position(Random& random) {
  const auto coordinate = [&random] {
    const std::int32_t kind = random.below(8);
    return static_cast<std::int16_t>(kind == 0 ? INT16_MIN : kind == 1 ? INT16_MAX : random.within(32768));
  };
  return {coordinate(), coordinate(), coordinate()};
}

LinearForm form(Random& random, std::int32_t coefficient, std::int32_t offset) {
  return {random.within(coefficient), random.within(coefficient), random.within(coefficient), offset};
}

CompiledInstance usual_instance(Random& random) {
  CompiledInstance instance{};
  instance.x = form(random, 1 << 28, random.within(1 << 28));
  instance.y = form(random, 1 << 28, random.within(1 << 28));
  instance.w = form(random, 1 << 27, (1 << 28) + random.below(1 << 28));
  instance.shift_x = 16 + random.below(5);
  instance.shift_y = instance.shift_x - 1;
  instance.w_near = (1U << 26) + random.word() % (1U << 27);
  instance.w_range = (1U << 28) + random.word() % (1U << 27);
  instance.depth_scale = random.word() | (1U << 31);
  instance.depth_shift = static_cast<std::uint8_t>(random.below(3));
  return instance;
}

/// Of all coefficients of a form one at most is at an edge, or sums overflow.
LinearForm any_form(Random& random, std::int32_t offset) {
  constexpr std::int32_t kEdges[] = {0,
                                     1,
                                     -1,
                                     0x7FFF,
                                     0x8000,
                                     -0x8000,
                                     0x7FFF7FFF,
                                     0x7FFF8000,
                                     std::numeric_limits<std::int32_t>::max(),
                                     std::numeric_limits<std::int32_t>::min()};
  const auto coefficient = [&random] { return static_cast<std::int32_t>(random.word()) >> random.between(2, 30); };
  LinearForm result{coefficient(), coefficient(), coefficient(), offset};
  const std::int32_t edge = random.between(0, 40);
  std::int32_t* const at[] = {&result.x, &result.y, &result.z};
  if (edge < 30) *at[edge % 3] = kEdges[edge / 3];
  return result;
}

CompiledInstance any_instance(Random& random) {
  CompiledInstance instance{};
  instance.x = any_form(random, static_cast<std::int32_t>(random.word()) >> 3);
  instance.y = any_form(random, static_cast<std::int32_t>(random.word()) >> 3);
  instance.w = any_form(random, 1 << 29);
  instance.w_near = 1 << 20;
  instance.w_range = 0x7FFFFFFF - (1 << 20);
  instance.shift_x = random.between(14, 22);
  instance.shift_y = random.between(14, 22);
  instance.depth_scale = random.word();
  instance.depth_shift = 3;
  return instance;
}

bool same_vertex(const SnappedVertex& a, const SnappedVertex& b) {
  return a.x == b.x && a.y == b.y && a.depth == b.depth;
}

/// Whether the implementations agree; `vertices` are theirs.
template <Effects effects>
bool agree(const CompiledInstance& instance, const Mesh& mesh, const RasterOrigin& origin, std::uint32_t first,
           std::uint32_t count, Vertices& vertices) {
  Vertices own;
  vertices.fill({0x1234, 0x5678, 0x9ABCDEF0});
  own = vertices;
  const bool all = transform_vertices_portable<effects>(instance, mesh, origin, first, count, vertices.data());
  const bool all_too = transform_vertices<effects>(instance, mesh, origin, first, count, own.data());
  return all == all_too && std::equal(vertices.begin(), vertices.end(), own.begin(), same_vertex);
}

}  // namespace

Outcome compare_transforms(std::uint32_t cases) {
  Random random(1);
  Outcome outcome;
  std::uint32_t narrow = 0, wide = 0;
  for (std::uint32_t number = 0; number < cases; ++number) {
    std::array<Position, kVertices> positions;
    for (Position& p : positions) p = position(random);
    const bool usual = number % 2 == 0;
    CompiledInstance instance = usual ? usual_instance(random) : any_instance(random);
    if (usual) {
      // The last vertex just on the far plane, or on the near one.
      const auto w = static_cast<std::uint32_t>(instance.w.at(positions[kVertices - 1]));
      if (number % 3 == 0 && w > instance.w_near) instance.w_range = w - instance.w_near;
      if (number % 3 == 1 && w > 1U << 26) instance.w_near = w;
    }
    instance.depth_normalisation = static_cast<std::uint8_t>(usual ? std::countl_zero(instance.w_near) : 31);
    const RasterOrigin origin{usual ? kCentreBias : 7, usual ? kCentreBias + 8 : 15, random.word()};
    Mesh mesh{};
    mesh.positions = positions;
    const std::uint32_t first = number % 7, count = number % 8 == 7 ? number / 8 % 8 : kVertices - first;
    Vertices vertices;
    if (!agree<Effects{}>(instance, mesh, origin, first, count, vertices)) {
      outcome.differs("vertices", number);
      return outcome;
    }
    for (std::uint32_t i = 0; i < count; ++i) ++(vertices[i].x == kNotNarrow ? wide : narrow);
  }
  outcome.compared = std::min(narrow, wide);
  return outcome;
}

}  // namespace zstrip::kernels_test
