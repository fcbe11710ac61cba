// A set of lines prepared for one frame.
#pragma once

#include <cstddef>
#include <span>

#include "zstrip/geometry/distance.hpp"
#include "zstrip/geometry/instance.hpp"

namespace zstrip::detail {

struct CompiledLines {
  CompiledInstance instance;  ///< as for an instance of its mesh; the shading is ignored
  Rect box;                   ///< raster pixels that it can cover, cut to the view
};
static_assert(sizeof(CompiledLines) <= kLineSetBytes);

/// Returns the compiled sets, which lie after the quadrics in the instances' part of the arena.
inline std::span<CompiledLines> compiled_lines(CompiledInstance* instances, const Scene& scene) {
  auto* const first = reinterpret_cast<std::byte*>(instances);
  return {reinterpret_cast<CompiledLines*>(first + scene.instances.size() * kInstanceBytes +
                                           scene.quadrics.size() * kQuadricBytes),
          scene.lines.size()};
}

}  // namespace zstrip::detail
