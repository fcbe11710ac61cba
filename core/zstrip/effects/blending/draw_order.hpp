// The order in which instances are drawn if some are blended.
#pragma once

#include <span>

#include "zstrip/effects/blending/effect.hpp"
#include "zstrip/geometry/distance.hpp"
#include "zstrip/state/frame_parts.hpp"

namespace zstrip::detail::blending {

struct DrawOrder {
  Distance distance;  ///< distance of the middle of its box from the camera's plane
  std::uint32_t instance, unused;
};
static_assert(sizeof(DrawOrder) == Effect::kPlaceBytes);

inline std::span<DrawOrder> order_of(const FrameState& frame) {
  const EffectBlock block = effect_block(frame);
  return {block.at<Effect, DrawOrder>(), block.instances()};
}

inline std::uint32_t instance_at(const FrameState& frame, std::uint32_t place) {
  return effect_block(frame).has(effect::blending) ? order_of(frame)[place].instance : place;
}

}  // namespace zstrip::detail::blending
