// What effects compute once a frame: drawing order of what blends, lights in mesh units, the curve of fog.
#pragma once

#include <span>

#include "zstrip/effects/outlines/outline.hpp"
#include "zstrip/frame/access.hpp"
#include "zstrip/frame/effect_block.hpp"

namespace zstrip {

struct Frame::Access::EffectStage {
  template <Effects effects>
  static void prepare(Frame& frame, const Camera& camera, [[maybe_unused]] Effects called_for) {
    [[maybe_unused]] const detail::EffectBlock block = effect_block(frame);
    if constexpr (detail::effect_bytes(effects, 1) != 0) block.lay_out(called_for);
    if constexpr (effects.has(effect::outlines) && effects.has(method::culling)) {
      // Of a hull only the far side, also where front and back of all else are drawn.
      for (detail::CompiledInstance& instance : std::span(frame.instances_, frame.scene_->instances.size())) {
        if (detail::is_outline(instance)) instance.double_sided = false;
      }
    }
    if constexpr (effects.has(effect::blending)) {
      if (block.has(effect::blending)) prepare_order(frame, camera);
    }
    if constexpr (effects.any(effect::local_light)) {
      if (block.has(effect::local_light)) prepare_local_light(frame, camera);
    }
    if constexpr (effects.has(effect::environment)) {
      if (block.has(effect::environment)) prepare_reflections(frame, camera, called_for);
    }
    if constexpr (effects.any(effect::fragments)) prepare_fragments<effects>(frame);
    if constexpr (effects.has(effect::pixel_shading)) prepare_pixel_shading(frame);
  }

  /// Opaque instances in the scene's order, then those that blend, from far to near.
  static void prepare_order(const Frame& frame, const Camera& camera) {
    const Scene& scene = *frame.scene_;
    const std::span<detail::DrawOrder> order = effect_block(frame).order();
    const auto blends = [&scene](const Instance& instance) {
      return is_blended(scene, scene.materials[instance.material]);
    };
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
      if (!blends(scene.instances[i])) order[count++] = {0, i, 0};
    }
    const std::size_t first = count;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
      const Instance& instance = scene.instances[i];
      if (!blends(instance)) continue;
      const detail::DistanceRange range =
          detail::distance_range(scene.meshes[instance.mesh], instance.transform, camera);
      const Distance middle = range.nearest / 2 + range.farthest / 2;
      std::size_t place = count++;
      for (; place > first && order[place - 1].distance < middle; --place) order[place] = order[place - 1];
      order[place] = {middle, i, 0};
    }
  }

  static void prepare_local_light(const Frame& frame, const Camera& camera) {
    const Scene& scene = *frame.scene_;
    const detail::EffectBlock block = effect_block(frame);
    block.lights() = detail::frame_lights(scene, camera);
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
      const Instance& instance = scene.instances[i];
      block.shading(i) = detail::instance_shading(scene.meshes[instance.mesh], instance.transform, camera);
    }
  }

  static void prepare_reflections(Frame& frame, const Camera& camera, Effects called_for);
  static void prepare_pixel_shading(Frame& frame);

  /// Which instances are drawn by fill_fragments.
  template <Effects effects>
  static void prepare_fragments(Frame& frame) {
    const Scene& scene = *frame.scene_;
    constexpr bool kOrthographic = effects.has(effect::orthographic);
    if constexpr (effects.has(effect::fog)) {
      if (scene.fog != nullptr && frame.fit_.near != 0) {
        effect_block(frame).fog() = detail::fog_curve(
            *scene.fog, detail::distance_scale(frame.fit_, kOrthographic, detail::depth_span(effects)));
      }
    }
    for (detail::CompiledInstance& instance : std::span(frame.instances_, scene.instances.size())) {
      if (!instance.visible) continue;
      const Effects finish = effects_of_finish(scene, scene.materials[instance.material], instance.lit,
                                               instance.shade >= detail::Shade::textured);
      if (scene.fog != nullptr || finish.any(effect::fragments)) {
        instance.shade = detail::with_fragments(instance.shade);
      }
      if constexpr (effects.has(effect::dithered_colours)) {
        const bool varies =
            instance.shade == detail::Shade::gouraud || instance.shade == detail::Shade::textured_gouraud;
        if (varies && dithers_colours(frame.view_)) {
          instance.shade = detail::with_fragments(instance.shade);
        }
      }
    }
  }
};

}  // namespace zstrip
