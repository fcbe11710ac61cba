// Settings for the fragments of an instance beyond its vertices, and the strip that carries them to the span loop.
#pragma once

#include <cstdint>
#include <type_traits>

#include "zstrip/base/bayer.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/effects/fog/fog.hpp"
#include "zstrip/raster/depth_rule.hpp"

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

/// In place of a member whose effect is missing.
struct Absent {};
template <Effects effects, Effects needed, class Member>
using MemberIf = std::conditional_t<effects.has(needed), Member, Absent>;

/// How the texels of an instance are kept.
struct TexelStorage {
  TextureFormat format = TextureFormat::rgb565;
  std::uint8_t smaller_levels = 0;
  bool only_effect = false;  ///< all else of its fragments is as without effects
};

struct CompiledInstance;
struct InstanceShading;
struct FrameLights;

/// The light on the pixels of an instance; read only where it has_lit_fragments.
struct PixelLightSettings {
  const CompiledInstance* instance = nullptr;
  const Scene* scene = nullptr;
  const FrameLights* lights = nullptr;
  const InstanceShading* shading = nullptr;  ///< null where the instance has no local light
  Finish finish{};
  Colour colour{};  ///< the material's
};

/// With what dithering, palettes or mipmaps, and lit fragments add, any of which a renderer may have where the picture
/// or an instance has not.
template <class Target, bool dithering, bool stored, bool lit>
struct TargetWithColours : Target {
  [[no_unique_address]] std::conditional_t<dithering, bool, Absent> dithered;
  [[no_unique_address]] std::conditional_t<stored, TexelStorage, Absent> storage;
  [[no_unique_address]] std::conditional_t<lit, PixelLightSettings, Absent> light;
};

template <Effects effects>
struct TargetOfEffects {
  static constexpr DepthMode kDepth = depth_mode(effects);
  using WithDepth = TargetFor<kDepth>;
  using WithFragments = TargetWithFragments<WithDepth>;
  static constexpr bool kDithers = effects.has(effect::dithered_colours);
  static constexpr bool kStores = effects.any(effect::texture_palettes | effect::mipmaps);
  static constexpr bool kLights = effects.has(effect::pixel_shading);
  using Drawn = std::conditional_t<kDithers || kStores || kLights,
                                   TargetWithColours<WithFragments, kDithers, kStores, kLights>, WithFragments>;
  using Type = std::conditional_t<effects.any(effect::fragments), Drawn, WithDepth>;
};
/// The strip as the rasterisers of these effects take it.
template <Effects effects>
using TargetOf = typename TargetOfEffects<effects>::Type;

/// Where the pixel that columns and rows count from lies in the picture, as far as a threshold needs it.
struct DitherAnchor {
  std::int32_t column = 0, row = 0;
  bool dithered = false;

  std::uint32_t threshold(std::int32_t columns, std::int32_t rows) const {
    return kBayer[(row + rows) & 7][(column + columns) & 7];
  }
};

}  // namespace zstrip::detail
