// Transforms a meshlet's vertices in C++, for every processor, projection and depth format.
#pragma once

#include <cstdint>

#include "zstrip/effects.hpp"
#include "zstrip/geometry/instance.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/depth_format.hpp"

namespace zstrip::detail {

template <Effects effects>
bool transform_vertices_portable(const CompiledInstance& instance, const Mesh& mesh, const RasterOrigin& origin,
                                 std::uint32_t first, std::uint32_t count, SnappedVertex* vertices) {
  constexpr bool kOrthographic = effects.has(effect::orthographic);
  constexpr DepthFormat kFormat = depth_format(effects);
  const LinearForm fx = instance.x;
  const LinearForm fy = instance.y;
  const LinearForm fw = instance.w;
  const NarrowProjection<kOrthographic> narrow(instance, origin);
  const Position* positions = mesh.positions.data() + first;
  bool all_narrow = true;
  int normalisation = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Position p = positions[i];
    if (!project_narrow<kOrthographic, kFormat>(narrow, instance, origin, fx.at(p), fy.at(p), fw.at(p), vertices[i],
                                                normalisation)) {
      vertices[i] = {kNotNarrow, 0, 0};
      all_narrow = false;
    }
  }
  return all_narrow;
}

}  // namespace zstrip::detail
