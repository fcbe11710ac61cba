// The default finish, for materials that need one because of the format of their texture.
#pragma once

#include <span>
#include <vector>

#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Gives the default finish to those of `materials` that have none and whose texture `needs_finish` selects. Adds it to
/// `finishes` if there are such materials; there must be room for one more.
template <class NeedsFinish>
void add_plain_finish(std::span<Material> materials, std::span<const Texture> textures, std::vector<Finish>& finishes,
                      const NeedsFinish& needs_finish) {
  const std::size_t index = finishes.size();
  for (Material& material : materials) {
    if (material.finish != kNoFinish || material.texture >= textures.size()) continue;
    if (!needs_finish(material)) continue;
    material.finish = static_cast<std::uint8_t>(index);
    finishes.resize(index + 1);
  }
}

}  // namespace zstrip::sim
