// The memory of a static layer, in addition to the arena: a pool for depth, one for colour, and the dirty tiles.
#pragma once

#include <cstdint>

#include "zstrip/store/store_bytes.hpp"
#include "zstrip/view.hpp"

namespace zstrip {

/// Bytes of each part of StaticLayer::Memory. All 0: no static layer.
struct LayerBytes {
  std::uint32_t depth = 0, colour = 0, dirty = 0;

  constexpr std::uint64_t sum() const { return std::uint64_t{depth} + colour + dirty; }
};

/// Returns the bytes with pools of these sizes, which `zstrip plan` measures for a scene.
constexpr LayerBytes layer_bytes(const View& view, std::uint32_t depth_pool, std::uint32_t colour_pool) {
  return {depth_pool, colour_pool, 4 * dirty_tile_words(view.width, view.height)};
}

/// Returns the bytes with which every background fits, whatever it shows.
constexpr LayerBytes layer_bytes_worst(const View& view) {
  const std::uint32_t pool = store_bytes_worst(view.width, view.height);
  return layer_bytes(view, pool, pool);
}

}  // namespace zstrip
