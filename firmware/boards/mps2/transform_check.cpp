// 40,000 random vertices by assembly and by C++; see assembly_checks.hpp.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "cortex_m/console.hpp"
#include "mps2/assembly_checks.hpp"
#include "zstrip/kernels/transform.hpp"

namespace zstrip::board {
namespace {

using namespace zstrip::detail;

constexpr std::uint32_t kVertices = 40;

std::int32_t within(Random& random, std::int32_t limit) { return random.below(2 * limit) - limit; }

LinearForm form(Random& random, std::int32_t coefficient, std::int32_t offset) {
  return {within(random, coefficient), within(random, coefficient), within(random, coefficient), offset};
}

/// Numbers of the sizes that compile_instance makes: most vertices are narrow, some are behind the near plane, beyond
/// the far one or beside the narrow range.
CompiledInstance instance_of(Random& random) {
  CompiledInstance instance{};
  instance.x = form(random, 1 << 28, within(random, 1 << 28));
  instance.y = form(random, 1 << 28, within(random, 1 << 28));
  instance.w = form(random, 1 << 27, (1 << 28) + random.below(1 << 28));
  instance.shift_x = 16 + random.below(5);
  instance.shift_y = instance.shift_x - 1;
  instance.w_near = (1U << 26) + random.next() % (1U << 27);
  instance.w_range = (1U << 28) + random.next() % (1U << 27);
  instance.depth_scale = random.next() | (1U << 31);
  instance.depth_shift = static_cast<std::uint8_t>(random.below(3));
  return instance;
}

bool same(const SnappedVertex& a, const SnappedVertex& b) { return a.x == b.x && a.y == b.y && a.depth == b.depth; }

/// How many vertices are narrow; nothing where assembly and C++ differ.
template <Effects effects>
std::optional<std::uint32_t> narrow_vertices(const CompiledInstance& instance, const Mesh& mesh,
                                             const RasterOrigin& origin, std::uint32_t first, std::uint32_t count) {
  std::array<SnappedVertex, kVertices> portable{}, assembled{};
  const bool all = transform_vertices_portable<effects>(instance, mesh, origin, first, count, portable.data());
  const bool all_too =
      transform_vertices_in_assembly<reciprocal_kind(effects)>(instance, mesh, origin, first, count, assembled.data());
  if (all != all_too || !std::equal(portable.begin(), portable.end(), assembled.begin(), same)) return std::nullopt;
  std::uint32_t narrow = 0;
  for (std::uint32_t i = 0; i < count; ++i) narrow += portable[i].x == kNotNarrow ? 0U : 1U;
  return narrow;
}

}  // namespace

int check_transform() {
  if constexpr (!kHasThumb) {
    print("self-test: no assembly\n");
    return 0;
  } else {
    Random random;
    std::uint32_t narrow = 0, wide = 0;
    for (std::uint32_t number = 0; number < 1000; ++number) {
      std::array<Position, kVertices> positions;
      for (Position& p : positions) {
        p = {static_cast<std::int16_t>(within(random, 32767)), static_cast<std::int16_t>(within(random, 32767)),
             static_cast<std::int16_t>(within(random, 32767))};
      }
      CompiledInstance instance = instance_of(random);
      // One vertex just on the far plane, or on the near one.
      const auto w = static_cast<std::uint32_t>(instance.w.at(positions[kVertices - 1]));
      if (number % 3 == 0 && w > instance.w_near) instance.w_range = w - instance.w_near;
      if (number % 3 == 1 && w > 1U << 26) instance.w_near = w;
      instance.depth_normalisation = static_cast<std::uint8_t>(std::countl_zero(instance.w_near));
      const RasterOrigin origin{kCentreBias, kCentreBias + 8, random.next()};
      Mesh mesh{};
      mesh.positions = positions;
      const std::uint32_t first = number % 7, count = kVertices - first;
      const std::optional<std::uint32_t> found = narrow_vertices<Effects{}>(instance, mesh, origin, first, count);
      if (!found || !narrow_vertices<effect::coarse_reciprocal>(instance, mesh, origin, first, count) ||
          !narrow_vertices<effect::table_reciprocal>(instance, mesh, origin, first, count)) {
        print("self-test: vertices of instance ");
        print_decimal(number);
        print(" differ\n");
        return 1;
      }
      narrow += *found;
      wide += count - *found;
    }
    print("self-test: ");
    print_decimal(std::min(narrow, wide));
    print(" vertices, narrow and not, are equal\n");
    return 0;
  }
}

}  // namespace zstrip::board
