// What effects keep from begin_frame to the strips: the last part of the arena, which only plans with such effects
// have.
#pragma once

#include <span>

#include "zstrip/frame/frame.hpp"
#include "zstrip/geometry/local_light.hpp"
#include "zstrip/raster/fragment_settings.hpp"

namespace zstrip::detail {

/// An instance in the order of drawing.
struct DrawOrder {
  Distance distance;  ///< of the middle of its box from the camera's plane
  std::uint32_t instance, unused;
};
static_assert(sizeof(DrawOrder) == kDrawOrderBytes);

/// Parts whose effects are missing are not planned, and must not be asked for: see effect_bytes.
template <Effects effects>
class EffectBlock {
 public:
  static constexpr bool kExists = effect_bytes(effects, 1) != 0;

  /// `memory`: of effect_bytes(), aligned to kArenaAlignment.
  EffectBlock(std::byte* memory, std::size_t instances) : memory_(memory), instances_(instances) {}

  FogCurve& fog() const { return *reinterpret_cast<FogCurve*>(memory_); }
  std::span<DrawOrder> order() const { return {reinterpret_cast<DrawOrder*>(memory_ + kOrderAt), instances_}; }
  FrameLights& lights() const { return *reinterpret_cast<FrameLights*>(memory_ + lights_at()); }
  InstanceShading& shading(std::size_t instance) const {
    return reinterpret_cast<InstanceShading*>(memory_ + lights_at() + kFrameLightsBytes)[instance];
  }

 private:
  static_assert(sizeof(FogCurve) == kFogBytes && kFogBytes % kArenaAlignment == 0);
  static constexpr std::size_t kOrderAt = effects.has(effect::fog) ? kFogBytes : 0;
  std::size_t lights_at() const {
    return kOrderAt + (effects.has(effect::blending) ? instances_ * kDrawOrderBytes : 0);
  }

  std::byte* memory_;
  std::size_t instances_;
};

}  // namespace zstrip::detail
