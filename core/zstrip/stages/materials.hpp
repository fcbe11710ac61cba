// Prepares an instance's material for the raster stage: surface, depth settings, fragment settings.
#pragma once

#include <algorithm>
#include <type_traits>

#include "zstrip/effects/fog/curve_of.hpp"
#include "zstrip/effects/local_light/kept.hpp"
#include "zstrip/pixels/colour.hpp"
#include "zstrip/pixels/target.hpp"
#include "zstrip/raster/fragment_settings.hpp"
#include "zstrip/state/frame_parts.hpp"

namespace zstrip::detail {

struct Materials {
  static Surface surface_of(const FrameState& frame, const CompiledInstance& instance) {
    const TextureView texture = texture_of(frame, instance.material);
    // Differences of coordinates have 16 bits and a sign.
    const bool has_far_coordinates =
        std::max(texture.log2_width, texture.log2_height) > frame.scene->meshes[instance.mesh].texcoord_bits - 2;
    return {rgb565(instance.base), texture, frame.fit.offset, has_far_coordinates};
  }

  static TextureView texture_of(const FrameState& frame, std::uint16_t material) {
    const std::uint16_t index = frame.scene->materials[material].texture;
    if (index == kNoTexture) return {nullptr, 0, 0};
    const Texture& texture = frame.scene->textures[index];
    return {texture.texels.data(), texture.log2_width, texture.log2_height};
  }

  template <Effects effects>
  static DepthSettings depth_settings(const FrameState& frame, std::uint16_t index) {
    const Material& material = frame.scene->materials[index];
    DepthSettings settings;
    settings.test = material.depth_test;
    settings.write = material.depth_write;
    settings.bias = material.depth_bias;
    settings.slope_bias = material.depth_slope_bias;
    settings.bias_clamp = material.depth_bias_clamp;
    settings.largest = largest_depth_code(depth_format(effects));
    if constexpr (effects.has(effect::depth_ranges)) {
      const std::uint32_t cleared = static_cast<const RangedFrameState&>(frame).cleared_code;
      settings.smallest = cleared + 1;
      settings.largest = cleared + kDepthRangeCodes - 2;
    }
    return settings;
  }

  template <Effects effects>
  static FragmentSettings fragment_settings(const FrameState& frame, const CompiledInstance& instance) {
    FragmentSettings settings;
    settings.textured = without_fragments(instance.shade) >= Shade::textured;
    const Material& material = frame.scene->materials[instance.material];
    const Finish finish = finish_of(*frame.scene, material);
    settings.alpha = material.colour.a;
    if (finish.alpha_mode == AlphaMode::mask) settings.cutoff = finish.alpha_cutoff;
    settings.blends = finish.alpha_mode == AlphaMode::blend;
    settings.bilinear = is_bilinear(finish.filter);
    settings.has_texture_alpha = settings.textured && finish.alpha_mode != AlphaMode::opaque &&
                                 frame.scene->textures[material.texture].format == TextureFormat::rgb565_alpha;
    if constexpr (effects.has(effect::fog)) {
      if (frame.scene->fog != nullptr) settings.fog = fog::curve_of(frame);
      settings.depth_offset =
          effects.has(effect::orthographic) ? std::int64_t{frame.origin.depth_offset} : frame.fit.offset;
    }
    return settings;
  }

  /// Used only with effect::texture_palettes or mipmaps.
  template <Effects effects>
  static TexelStorage texel_storage(const FrameState& frame, const CompiledInstance& instance) {
    const Scene& scene = *frame.scene;
    const Material& material = scene.materials[instance.material];
    const Shade shade = without_fragments(instance.shade);
    if (shade < Shade::textured) return {};
    const Texture& texture = scene.textures[material.texture];
    if (!has_palette(texture.format) && texture.smaller_levels == 0) return {};
    const bool dithered =
        effects.has(effect::dithered_colours) && shade == Shade::textured_gouraud && dithers_colours(frame.view);
    const Effects others = without(effect::fragments, effect::texture_palettes | effect::mipmaps);
    const bool lit = effects.has(effect::pixel_shading) && has_lit_fragments(instance.shade);
    const bool only_effect = scene.fog == nullptr && !dithered && !lit &&
                             !effects_of_finish(scene, material, instance.lit, true).any(others);
    return {texture.format, texture.smaller_levels, only_effect};
  }

  template <Effects effects>
  static PixelLightSettings pixel_light_settings(const FrameState& frame, const CompiledInstance& instance) {
    const Scene& scene = *frame.scene;
    const Material& material = scene.materials[instance.material];
    PixelLightSettings settings{.instance = &instance, .scene = &scene};
    if (!has_lit_fragments(instance.shade)) return settings;
    settings.finish = finish_of(scene, material);
    settings.colour = material.colour;
    if constexpr (effects.any(effect::local_light)) {
      if (effects_of_finish(scene, material, true, false).any(effect::local_light)) {
        settings.lights = &local_light::lights_of(frame);
        settings.shading = &local_light::shading_of(frame, static_cast<std::size_t>(&instance - frame.instances));
      }
    }
    return settings;
  }

  /// Returns the target with the data of the method and of the material's depth effects: `target` itself if there are
  /// none.
  template <Effects effects>
  static decltype(auto) depth_target(FrameState& frame, const StripTarget& target, std::uint16_t material) {
    if constexpr (effects.methods != 0) {
      MethodState& state = static_cast<MethodFrameState&>(frame).state;
      return StripTargetWithMethod{{target, depth_settings<effects>(frame, material)}, &state};
    } else if constexpr (std::is_same_v<TargetFor<depth_mode(effects)>, StripTarget>) {
      return (target);
    } else {
      return StripTargetWithDepth{target, depth_settings<effects>(frame, material)};
    }
  }

  /// Returns the target with the data of the method, of the material's depth effects, and of the instance's fragments:
  /// `target` itself if there are none.
  template <Effects effects>
  static decltype(auto) instance_target(FrameState& frame, const StripTarget& target,
                                        const CompiledInstance& instance) {
    decltype(auto) with_depth = depth_target<effects>(frame, target, instance.material);
    if constexpr (effects.any(effect::dithered_colours | effect::texture_palettes | effect::mipmaps |
                              effect::pixel_shading)) {
      TargetOf<effects> complete{{with_depth, fragment_settings<effects>(frame, instance)}, {}, {}, {}};
      if constexpr (effects.has(effect::dithered_colours)) {
        complete.dithered = dithers_colours(frame.view);
      }
      if constexpr (effects.any(effect::texture_palettes | effect::mipmaps)) {
        complete.storage = texel_storage<effects>(frame, instance);
      }
      if constexpr (effects.has(effect::pixel_shading)) {
        complete.light = pixel_light_settings<effects>(frame, instance);
      }
      return complete;
    } else if constexpr (effects.any(effect::fragments)) {
      return TargetOf<effects>{with_depth, fragment_settings<effects>(frame, instance)};
    } else {
      return with_depth;
    }
  }
};

}  // namespace zstrip::detail
