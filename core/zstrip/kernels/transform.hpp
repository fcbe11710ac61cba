// Kernel: transforms the vertices of a meshlet into the post-transform cache, each once.
//
// Positions have 16 bits a coordinate; the instance's linear forms are 32-bit words, of whose products the upper word
// is used. Results are 12.4 raster coordinates and 16.16 depth codes, or kNotNarrow and 0. No sum of a form overflows.
// Every implementation writes the same bits as portable/transform.hpp. Assembly and vectors support perspective and
// z16; vectors need at least four vertices, and an instance for which fits_vector is true.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/geometry/instance.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/mve/transform.hpp"
#include "zstrip/kernels/portable/transform.hpp"
#include "zstrip/kernels/thumb1/transform.hpp"
#include "zstrip/kernels/thumb2/transform.hpp"
#include "zstrip/kernels/vector/transform.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/depth_format.hpp"

namespace zstrip::detail {

/// Not inlined, so that its stack is free again for the rasterisers.
[[gnu::noinline]] inline bool transform_vertices_in_assembly(const CompiledInstance& instance, const Mesh& mesh,
                                                             const RasterOrigin& origin, std::uint32_t first,
                                                             std::uint32_t count, SnappedVertex* vertices) {
  const Position* const positions = mesh.positions.data() + first;
  if constexpr (kHasMve) {
    if (count >= kMveVertices) return transform_vertices_mve(instance, origin, positions, count, vertices);
  }
  if constexpr (kHasThumb1) {
    return transform_vertices_thumb1(HalvedTransform(instance, origin), positions, count, vertices);
  } else {
    return transform_vertices_thumb2(NarrowTransform(instance, origin), positions, count, vertices);
  }
}

/// Writes `count` vertices from `first` on. Returns true if all are narrow, so that triangles need no test.
template <Effects effects>
bool transform_vertices(const CompiledInstance& instance, const Mesh& mesh, const RasterOrigin& origin,
                        std::uint32_t first, std::uint32_t count, SnappedVertex* vertices) {
  if constexpr (kHasThumb && !effects.has(effect::orthographic) && depth_format(effects) == DepthFormat::z16) {
    if (count == 0) return true;
    return transform_vertices_in_assembly(instance, mesh, origin, first, count, vertices);
  } else {
    if constexpr (kHasVectors && !effects.has(effect::orthographic) && depth_format(effects) == DepthFormat::z16) {
      if (count >= kVectorVertices && fits_vector(instance)) {
        return transform_vertices_vector(instance, origin, mesh.positions.data() + first, count, vertices);
      }
    }
    return transform_vertices_portable<effects>(instance, mesh, origin, first, count, vertices);
  }
}

}  // namespace zstrip::detail
