// What effects keep from begin_frame to the strips: the last part of the arena, which only plans with such effects
// have.
#pragma once

#include "zstrip/frame/frame.hpp"
#include "zstrip/raster/fragment_settings.hpp"

namespace zstrip::detail {

/// Parts whose effects are missing are not planned: see effect_bytes.
template <Effects effects>
class EffectBlock {
 public:
  static constexpr bool kExists = effect_bytes(effects, 1) != 0;

  /// `memory`: of effect_bytes(), aligned to kArenaAlignment.
  explicit EffectBlock(std::byte* memory) : memory_(memory) {}

  FogCurve& fog() const { return *reinterpret_cast<FogCurve*>(memory_); }

 private:
  static_assert(sizeof(FogCurve) == kFogBytes);
  std::byte* memory_;
};

}  // namespace zstrip::detail
