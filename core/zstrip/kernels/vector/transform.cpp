// A vertex at a time: its three linear forms in one vector.
#include "zstrip/kernels/vector/transform.hpp"

#include "zstrip/kernels/vector/vector.hpp"

#if ZSTRIP_HAS_VECTORS

namespace zstrip::detail {

using namespace vectors;
bool transform_vertices_vector(const CompiledInstance& instance, const RasterOrigin& origin, const Position* positions,
                               std::uint32_t count, SnappedVertex* vertices) {
  const NarrowProjection<false> narrow(instance, origin);
  const LinearForms forms(instance.w, instance.x, instance.y);
  bool all_narrow = true;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Words at = forms.at(positions[i]);
    const auto w = static_cast<std::int32_t>(at[0]), x = static_cast<std::int32_t>(at[1]),
               y = static_cast<std::int32_t>(at[2]);
    if (!project_narrow<false>(narrow, instance, origin, x, y, w, vertices[i])) {
      vertices[i] = {kNotNarrow, 0, 0};
      all_narrow = false;
    }
  }
  return all_narrow;
}

}  // namespace zstrip::detail

#endif
