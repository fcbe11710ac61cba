// The place of a frame's shadow.
#pragma once

#include <cstddef>
#include <span>

#include "zstrip/effects/shadows/shadow_map.hpp"
#include "zstrip/state/frame_parts.hpp"

namespace zstrip::detail::shadows {

inline ShadowState& state_of(const FrameState& frame) { return *effect_block(frame).at<Effect, ShadowState>(); }

/// Returns the end of the memory that the map may use.
inline std::byte* end_of_pool(const FrameState& frame) {
  const std::span<std::byte> pool = state_of(frame).pool;
  return pool.data() + pool.size();
}

}  // namespace zstrip::detail::shadows
