// The settings of an instance's fragments, and the strip types that carry them to the span loop.
#pragma once

#include <cstdint>
#include <type_traits>

#include "zstrip/base/bayer.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/effects/fog/fog.hpp"
#include "zstrip/pixels/depth_rule.hpp"

namespace zstrip::detail {

/// Set once for each meshlet.
struct FragmentSettings {
  std::uint8_t alpha = 255;
  std::uint8_t cutoff = 0;  ///< fragments with a smaller alpha are not drawn
  bool blends = false;
  bool bilinear = false;
  bool has_texture_alpha = false;
  bool textured = false;
  const FogCurve* fog = nullptr;  ///< only with effect::fog
  std::int64_t depth_offset = 0;  ///< FogPlane's offset
};

/// The strip with these settings, for effects that have them.
template <class Target>
struct TargetWithFragments : Target {
  FragmentSettings fragments;
};

/// Takes the place of a member whose effect is missing.
struct Absent {};
template <Effects effects, Effects needed, class Member>
using MemberIf = std::conditional_t<effects.has(needed), Member, Absent>;

struct TexelStorage {
  TextureFormat format = TextureFormat::rgb565;
  std::uint8_t smaller_levels = 0;
  bool only_effect = false;  ///< fragments have no other effect than this storage
};

struct CompiledInstance;
struct InstanceShading;
struct FrameLights;

/// The light on the pixels of an instance; read only if has_lit_fragments.
struct PixelLightSettings {
  const CompiledInstance* instance = nullptr;
  const Scene* scene = nullptr;
  const FrameLights* lights = nullptr;
  const InstanceShading* shading = nullptr;  ///< null if the instance has no local light
  Finish finish{};
  Colour colour{};
};

/// Adds the settings of dithering, palettes or mipmaps, and lit fragments. The renderer has these effects; the picture
/// or an instance may not use them.
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
template <Effects effects>
using TargetOf = typename TargetOfEffects<effects>::Type;

/// The position in the picture of the anchor from which columns and rows are counted; only its lowest bits are needed.
struct DitherAnchor {
  std::int32_t column = 0, row = 0;
  bool dithered = false;

  std::uint32_t threshold(std::int32_t columns, std::int32_t rows) const {
    return kBayer[(row + rows) & 7][(column + columns) & 7];
  }
};

}  // namespace zstrip::detail
