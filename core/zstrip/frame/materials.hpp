// What the raster stage gets of an instance's material: surface, depth settings, fragment settings.
#pragma once

#include <type_traits>

#include "zstrip/frame/access.hpp"
#include "zstrip/frame/effect_block.hpp"
#include "zstrip/raster/target.hpp"

namespace zstrip {

struct Frame::Access::Materials {
  static detail::Surface surface_of(const Frame& frame, const detail::CompiledInstance& instance) {
    return {detail::rgb565(instance.base), texture_of(frame, instance.material), frame.fit_.offset};
  }

  static detail::TextureView texture_of(const Frame& frame, std::uint16_t material) {
    const std::uint16_t index = frame.scene_->materials[material].texture;
    if (index == kNoTexture) return {nullptr, 0, 0};
    const Texture& texture = frame.scene_->textures[index];
    return {texture.texels.data(), texture.log2_width, texture.log2_height};
  }

  template <Effects effects>
  static detail::DepthSettings depth_settings(const Frame& frame, std::uint16_t index) {
    constexpr DepthFormat kFormat = depth_format(effects);
    const Material& material = frame.scene_->materials[index];
    detail::DepthSettings settings;
    settings.test = material.depth_test;
    settings.write = material.depth_write;
    settings.bias = material.depth_bias;
    settings.slope_bias = material.depth_slope_bias;
    settings.bias_clamp = material.depth_bias_clamp;
    settings.largest = largest_depth_code(kFormat);
    if constexpr (kFormat == DepthFormat::w16) settings.linear = detail::linear_mapping(frame.fit_);
    if constexpr (effects.has(effect::depth_ranges)) {
      const std::uint32_t cleared = static_cast<const FrameWithDepthRanges&>(frame).cleared_code_;
      settings.smallest = cleared + 1;
      settings.largest = cleared + detail::kDepthRangeCodes - 2;
    }
    return settings;
  }

  template <Effects effects>
  static detail::FragmentSettings fragment_settings(const Frame& frame, const detail::CompiledInstance& instance) {
    detail::FragmentSettings settings;
    settings.textured = detail::without_fragments(instance.shade) >= detail::Shade::textured;
    const Material& material = frame.scene_->materials[instance.material];
    const Finish finish = finish_of(*frame.scene_, material);
    settings.alpha = material.colour.a;
    if (finish.alpha_mode == AlphaMode::mask) settings.cutoff = finish.alpha_cutoff;
    settings.blends = finish.alpha_mode == AlphaMode::blend;
    settings.bilinear = is_bilinear(finish.filter);
    settings.has_texture_alpha = settings.textured && finish.alpha_mode != AlphaMode::opaque &&
                                 frame.scene_->textures[material.texture].format == TextureFormat::rgb565_alpha;
    if constexpr (effects.has(effect::fog)) {
      if (frame.scene_->fog != nullptr) settings.fog = &effect_block(frame).fog();
      settings.depth_offset =
          effects.has(effect::orthographic) ? std::int64_t{frame.origin_.depth_offset} : frame.fit_.offset;
    }
    return settings;
  }

  /// Only with effect::texture_palettes or mipmaps.
  template <Effects effects>
  static detail::TexelStorage texel_storage(const Frame& frame, const detail::CompiledInstance& instance) {
    const Scene& scene = *frame.scene_;
    const Material& material = scene.materials[instance.material];
    const detail::Shade shade = detail::without_fragments(instance.shade);
    if (shade < detail::Shade::textured) return {};
    const Texture& texture = scene.textures[material.texture];
    if (!has_palette(texture.format) && texture.smaller_levels == 0) return {};
    const bool dithered = effects.has(effect::dithered_colours) && shade == detail::Shade::textured_gouraud &&
                          dithers_colours(frame.view_);
    const Effects others = without(effect::fragments, effect::texture_palettes | effect::mipmaps);
    const bool lit = effects.has(effect::pixel_shading) && detail::has_lit_fragments(instance.shade);
    const bool only_effect = scene.fog == nullptr && !dithered && !lit &&
                             !effects_of_finish(scene, material, instance.lit, true).any(others);
    return {texture.format, texture.smaller_levels, only_effect};
  }

  /// Only with effect::pixel_shading.
  template <Effects effects>
  static detail::PixelLightSettings pixel_light_settings(const Frame& frame, const detail::CompiledInstance& instance) {
    const Scene& scene = *frame.scene_;
    const Material& material = scene.materials[instance.material];
    detail::PixelLightSettings settings{.instance = &instance, .scene = &scene};
    if (!detail::has_lit_fragments(instance.shade)) return settings;
    settings.finish = finish_of(scene, material);
    settings.colour = material.colour;
    if constexpr (effects.any(effect::local_light)) {
      if (effects_of_finish(scene, material, true, false).any(effect::local_light)) {
        const detail::EffectBlock block = effect_block(frame);
        settings.lights = &block.lights();
        settings.shading = &block.shading(static_cast<std::size_t>(&instance - frame.instances_));
      }
    }
    return settings;
  }

  /// Calls draw(target), with what the method and the depth effects of this material add to it.
  template <Effects effects, class Draw>
  static void with_depth(Frame& frame, const detail::StripTarget& target, std::uint16_t material, const Draw& draw) {
    if constexpr (effects.methods != 0) {
      detail::MethodState& state = static_cast<FrameWithMethod&>(frame).state_;
      draw(detail::StripTargetWithMethod{{target, depth_settings<effects>(frame, material)}, &state});
    } else if constexpr (std::is_same_v<detail::TargetFor<detail::depth_mode(effects)>, detail::StripTarget>) {
      draw(target);
    } else {
      draw(detail::StripTargetWithDepth{target, depth_settings<effects>(frame, material)});
    }
  }

  /// Calls draw(target), with what the method, the depth effects of this instance's material and its fragments add.
  template <Effects effects, class Draw>
  static void with_settings(Frame& frame, const detail::StripTarget& target, const detail::CompiledInstance& instance,
                            const Draw& draw) {
    with_depth<effects>(frame, target, instance.material,
                        [&](const auto& complete) { with_fragments<effects>(frame, complete, instance, draw); });
  }

  template <Effects effects, class Target, class Draw>
  static void with_fragments(const Frame& frame, const Target& target, const detail::CompiledInstance& instance,
                             const Draw& draw) {
    if constexpr (effects.any(effect::dithered_colours | effect::texture_palettes | effect::mipmaps |
                              effect::pixel_shading)) {
      detail::TargetOf<effects> complete{{target, fragment_settings<effects>(frame, instance)}, {}, {}, {}};
      if constexpr (effects.has(effect::dithered_colours)) {
        complete.dithered = dithers_colours(frame.view_);
      }
      if constexpr (effects.any(effect::texture_palettes | effect::mipmaps)) {
        complete.storage = texel_storage<effects>(frame, instance);
      }
      if constexpr (effects.has(effect::pixel_shading)) {
        complete.light = pixel_light_settings<effects>(frame, instance);
      }
      draw(complete);
    } else if constexpr (effects.any(effect::fragments)) {
      draw(detail::TargetOf<effects>{target, fragment_settings<effects>(frame, instance)});
    } else {
      draw(target);
    }
  }
};

}  // namespace zstrip
