// What the fragments of an instance need beyond its vertices, and the strip that carries it to the span loop.
#pragma once

#include <type_traits>

#include "zstrip/raster/depth_rule.hpp"
#include "zstrip/raster/fog.hpp"
#include "zstrip/scene/effects.hpp"

namespace zstrip::detail {

/// Once for each meshlet.
struct FragmentSettings {
  std::uint8_t alpha = 255;  ///< the material's
  std::uint8_t cutoff = 0;   ///< least alpha that is drawn
  bool blends = false;
  bool bilinear = false;
  bool has_texture_alpha = false;
  bool textured = false;
  const FogCurve* fog = nullptr;  ///< only with effect::fog
  std::int64_t depth_offset = 0;  ///< of FogPlane
};

/// A strip with these settings, for effects that have any.
template <class Target>
struct TargetWithFragments : Target {
  FragmentSettings fragments;
};

template <Effects effects>
struct TargetOfEffects {
  static constexpr DepthMode kDepth = depth_mode(effects);
  using WithDepth = TargetFor<kDepth>;
  using Type = std::conditional_t<effects.any(effect::fragments), TargetWithFragments<WithDepth>, WithDepth>;
};
/// The strip as the rasterisers of these effects take it.
template <Effects effects>
using TargetOf = typename TargetOfEffects<effects>::Type;

}  // namespace zstrip::detail
