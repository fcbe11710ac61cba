// Transforms the vertices of a meshlet into the post-transform cache, each once.
#pragma once

#include "zstrip/geometry/light.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/sse2/transform.hpp"
#include "zstrip/kernels/thumb1/transform.hpp"
#include "zstrip/kernels/thumb2/transform.hpp"

namespace zstrip::detail {

/// Writes `count` vertices from `first` on. Returns whether all of them are narrow, so that the loop over the
/// triangles need not ask.
template <Effects effects>
bool transform_vertices_portable(const CompiledInstance& instance, const Mesh& mesh, const RasterOrigin& origin,
                                 std::uint32_t first, std::uint32_t count, SnappedVertex* vertices) {
  constexpr bool kOrthographic = effects.has(effect::orthographic);
  constexpr DepthFormat kFormat = depth_format(effects);
  constexpr ReciprocalOf kReciprocal = reciprocal_kind(effects);
  const LinearForm fx = instance.x;
  const LinearForm fy = instance.y;
  const LinearForm fw = instance.w;
  const NarrowProjection<kOrthographic> narrow(instance, origin);
  const Position* positions = mesh.positions.data() + first;
  bool all_narrow = true;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Position p = positions[i];
    if (!project_narrow<kOrthographic, kFormat, kReciprocal>(narrow, instance, origin, fx.at(p), fy.at(p), fw.at(p),
                                                             vertices[i])) {
      vertices[i] = {kNotNarrow, 0, 0};
      all_narrow = false;
    }
  }
  return all_narrow;
}

/// Cannot be inlined: the rasterisers need the stack that it takes.
template <ReciprocalOf kind>
[[gnu::noinline]] bool transform_vertices_in_assembly(const CompiledInstance& instance, const Mesh& mesh,
                                                      const RasterOrigin& origin, std::uint32_t first,
                                                      std::uint32_t count, SnappedVertex* vertices) {
  const Position* const positions = mesh.positions.data() + first;
  if constexpr (kHasThumb1) {
    return transform_vertices_thumb1<kind>(HalvedTransform(instance, origin), positions, count, vertices);
  } else {
    return transform_vertices_thumb2<kind>(NarrowTransform(instance, origin), positions, count, vertices);
  }
}

/// The same.
template <Effects effects>
bool transform_vertices(const CompiledInstance& instance, const Mesh& mesh, const RasterOrigin& origin,
                        std::uint32_t first, std::uint32_t count, SnappedVertex* vertices) {
  if constexpr (kHasThumb && !effects.has(effect::orthographic) && depth_format(effects) == DepthFormat::z16) {
    if (count == 0) return true;
    return transform_vertices_in_assembly<reciprocal_kind(effects)>(instance, mesh, origin, first, count, vertices);
  } else {
    if constexpr (kHasSse2 && !effects.any(effect::orthographic | effect::short_reciprocals) &&
                  depth_format(effects) == DepthFormat::z16) {
      if (fits_sse2(instance.w) && fits_sse2(instance.x) && fits_sse2(instance.y)) {
        return transform_vertices_sse2(instance, origin, mesh.positions.data() + first, count, vertices);
      }
    }
    return transform_vertices_portable<effects>(instance, mesh, origin, first, count, vertices);
  }
}

/// Whether a colour is copied as one word: without (Cortex-M0) a loop of copies is slower than the general one.
inline constexpr bool kCopiesColours = kHasThumb2 || kHasSse2;

template <Effects effects>
void shade_vertices(const CompiledInstance& instance, const Mesh& mesh, std::uint32_t first, std::uint32_t count,
                    Colour* colours) {
  if constexpr (kCopiesColours && effects.has(effect::vertex_colours)) {
    if (!(effects.has(effect::lighting) && instance.lit) && instance.coloured &&
        instance.base == Colour{255, 255, 255, 255}) {
      const Colour* const own = mesh.colours.data() + first;
      for (std::uint32_t i = 0; i < count; ++i) colours[i] = own[i];
      return;
    }
  }
  for (std::uint32_t i = 0; i < count; ++i) colours[i] = vertex_colour<effects>(instance, mesh, first + i);
}

}  // namespace zstrip::detail
