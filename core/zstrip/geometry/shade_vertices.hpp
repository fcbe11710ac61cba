// Colours of a meshlet's vertices beside the post-transform cache, each once.
#pragma once

#include <cstdint>

#include "zstrip/effects.hpp"
#include "zstrip/geometry/instance.hpp"
#include "zstrip/geometry/light.hpp"
#include "zstrip/kernels/processor.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// Whether a colour is copied as one word: without (Cortex-M0) a loop of copies is slower than the general one.
inline constexpr bool kCopiesColours = kHasThumb2 || kHasVectors;

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
