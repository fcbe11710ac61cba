// Computes the colours of a meshlet's vertices, each once, next to the post-transform cache.
#pragma once

#include <cstdint>

#include "zstrip/effects.hpp"
#include "zstrip/geometry/instance.hpp"
#include "zstrip/geometry/light.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// True if neither light nor tint changes the colours of the instance's mesh, so that they are read from the mesh.
template <Effects effects>
bool has_colours_of_mesh(const CompiledInstance& instance) {
  if constexpr (!effects.has(effect::vertex_colours)) return false;
  return !(effects.has(effect::lighting) && instance.lit) && instance.coloured &&
         instance.base == Colour{255, 255, 255, 255};
}

template <Effects effects>
void shade_vertices(const CompiledInstance& instance, const Mesh& mesh, std::uint32_t first, std::uint32_t count,
                    Colour* colours) {
  for (std::uint32_t i = 0; i < count; ++i) colours[i] = vertex_colour<effects>(instance, mesh, first + i);
}

}  // namespace zstrip::detail
