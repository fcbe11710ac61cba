// Shadows: before a frame the map, drawn from the light by the stages that draw the picture; after a strip what its
// shadowed pixels look like without the light. A strip is drawn once with all lights, and where the map says that some
// of its pixels are in shadow, once more without that one: all others then have a depth nearer than any.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/effects/shadows/light_view.hpp"
#include "zstrip/frame/bounds.hpp"
#include "zstrip/frame/raster_stage.hpp"

namespace zstrip {

struct Frame::Access::Shadows {
  /// Draws the map of `drawn`, whose billboards are turned and which has no hulls yet, and puts the light last.
  /// `scene`: the caller's.
  template <Effects effects>
  static Status begin_frame(Frame& frame, const Scene& scene, Scene& drawn, Effects called_for) {
    if (!called_for.has(effect::shadows)) return {};
    frame.has_special_depth_ = true;
    detail::ShadowState& state = begin(frame, scene, called_for);
    drawn.lights = state.scene.lights;
    detail::LightReach reach(drawn.lights.back());
    for (const Instance& instance : drawn.instances) {
      if (casts(drawn, instance)) {
        reach.extend([&](const Camera& axis) {
          return detail::distance_range(drawn.meshes[instance.mesh], instance.transform, axis);
        });
      }
    }
    if constexpr (effects.has(effect::quadrics)) {
      for (const Quadric& quadric : drawn.quadrics) {
        reach.extend([&](const Camera& axis) { return detail::distance_range(quadric, axis); });
      }
    }
    state.empty = reach.empty();
    if (state.empty) return {};
    Scene casters = drawn;
    casters.outlines = {};
    return draw_map<kCasting<effects>>(frame, casters, reach, state);
  }

  /// Of a frame that is otherwise prepared.
  template <Effects effects>
  static Status prepare(Frame& frame, const Camera& camera, Effects called_for) {
    if (!called_for.has(effect::shadows)) return {};
    return prepare_place(frame, camera, called_for, detail::depth_of_code<depth_format(effects)>(1));
  }

  /// `target` has been drawn with all lights.
  template <Effects effects>
  static Status draw(Frame& frame, const detail::StripTarget& target, std::uint16_t strip) {
    if (target.area.empty() || !effect_block(frame).has(effect::shadows)) return {};
    detail::ShadowState& state = effect_block(frame).shadows();
    if (state.empty) return {};
    Status status{};
    const Rect shadowed = find<effects>(target, state, status);
    if (!status || shadowed.empty()) return status;
    using Cell = detail::DepthCell<depth_format(effects)>;
    // Bounds of depth begin again, of the cells that they know.
    detail::StripTarget part = target;
    if constexpr (effects.any(method::bounded)) {
      auto& with_bounds = static_cast<FrameWithMethod&>(frame);
      with_bounds.state_.bounds.begin(with_bounds.depth_bounds_, target.area, target.depth);
    } else {
      part = detail::part_of<Cell>(target, shadowed);
    }
    const Statistics counted = frame.statistics_;
    Colour* const lit = frame.colours_;
    if (frame.mode_ == Mode::binned) frame.colours_ = state.colours_in_shadow;
    leave_light<effects>(frame, -1);
    Raster::draw_surfaces<effects>(frame, part, strip);
    leave_light<effects>(frame, 1);
    frame.colours_ = lit;
    frame.statistics_ = counted;
    return {};
  }

 private:
  /// The pipeline of a map: both faces, farther by the bias.
  template <Effects effects>
  static constexpr Effects kCasting = effect::orthographic | effect::depth_state | (effects & effect::quadrics);

  static bool casts(const Scene& scene, const Instance& instance) {
    const Material& material = scene.materials[instance.material];
    return casts_shadow(scene.meshes[instance.mesh].shadow) && material.depth_write && !is_blended(scene, material);
  }

  /// The state, with the scene's lights in its order.
  static detail::ShadowState& begin(Frame& frame, const Scene& scene, Effects called_for);
  /// Instances of `light`, a frame of its own in the memory of `frame`, and its strips.
  static Status prepare_map(Frame& light, const Frame& frame, const Scene& casters, const detail::LightReach& reach,
                            detail::ShadowState& state);
  static Status prepare_place(Frame& frame, const Camera& camera, Effects called_for, std::uint32_t least);
  /// Its z-buffer, cleared.
  static detail::StripTarget map_strip(Frame& light, std::uint16_t strip);
  static Status keep_strip(const Frame& light, std::uint16_t strip, detail::ShadowState& state);

  template <Effects casting>
  static Status draw_map(const Frame& frame, const Scene& casters, const detail::LightReach& reach,
                         detail::ShadowState& state) {
    Frame light;
    if (const Status status = prepare_map(light, frame, casters, reach, state); !status) return status;
    if constexpr (casting.has(effect::quadrics)) {
      if (const Status status = prepare_quadrics(light, casters, state.camera); !status) return status;
    }
    divide(light, casters, light.view_);
    light.scene_ = &casters;
    if (light.extents_ != nullptr) Geometry::survey<casting>(light);
    detail::DepthSettings settings;
    settings.bias = -std::int32_t{casters.shadow->bias};
    settings.slope_bias = -casters.shadow->slope_bias;
    for (std::uint16_t strip = 0; strip < light.plan_.strips; ++strip) {
      const detail::StripTarget target = map_strip(light, strip);
      if (!target.area.empty()) draw_casters<casting>(light, {target, settings}, strip);
      if (const Status status = keep_strip(light, strip, state); !status) return status;
    }
    return {};
  }

  template <Effects casting>
  static void draw_casters(Frame& light, const detail::StripTargetWithDepth& target, std::uint16_t strip) {
    if constexpr (casting.has(effect::quadrics)) {
      // Of what is closed the far side: it shadows all that the near one does, and that one never itself.
      detail::StripTargetWithDepth unbiased{target, {}};
      const detail::CompiledQuadric* const quadrics = quadrics_of(light, *light.scene_);
      for (std::size_t i = 0; i < light.scene_->quadrics.size(); ++i) {
        if (!quadrics[i].visible) continue;
        detail::QuadricFill<casting, detail::QuadricSide::far>::draw(
            unbiased, quadrics[i], light.origin_.depth_offset,
            [](std::int32_t, std::int32_t, std::int32_t, std::uint32_t) { return std::uint16_t{0}; });
      }
    }
    Geometry::for_each_meshlet<casting>(
        light, [&](std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet) {
          if (light.extents_ != nullptr && !light.grid_.touches(light.extents_[number], strip, 0)) return;
          const Geometry::MeshletRange range =
              Geometry::meshlet_range(light.scene_->meshes[light.instances_[instance].mesh], meshlet);
          const auto batch = Geometry::batch_for<casting>(light, instance, range.first_vertex, 0);
          const bool all_narrow = Geometry::transform<casting>(light, batch, range, 0);
          Assembler<casting>::draw(target, batch, range.triangles, all_narrow);
        });
  }

  /// Sets cells of shadowed pixels to "nothing drawn" and all others to a code nearer than any; the pixels that hold
  /// all shadowed ones.
  template <Effects effects>
  static Rect find(const detail::StripTarget& target, detail::ShadowState& state, Status& status) {
    constexpr DepthFormat kFormat = depth_format(effects);
    using Cell = detail::DepthCell<kFormat>;
    const Rect& area = target.area;
    Rect shadowed{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
    // Blocks, which lie in few tiles of the map.
    constexpr std::int32_t kBlock = 8;
    for (std::int32_t left = area.left; left < area.right; left += kBlock) {
      const std::int32_t right = std::min(left + kBlock, area.right);
      for (std::int32_t y = area.top; y < area.bottom; ++y) {
        Cell* cell = target.template depth_row<Cell>(y) + (left - area.left);
        for (std::int32_t x = left; x < right; ++x, ++cell) {
          const std::uint32_t code = *cell;
          *cell = static_cast<Cell>(-1);
          if (code == 0) continue;
          const detail::MapPoint at = state.place.template at<effects.has(effect::orthographic), kFormat>(
              x, y, detail::depth_of_code<kFormat>(code));
          if (!state.hides(at, status)) continue;
          *cell = 0;
          shadowed = {std::min(shadowed.left, x), std::min(shadowed.top, y), std::max(shadowed.right, x + 1),
                      std::max(shadowed.bottom, y + 1)};
        }
      }
    }
    return shadowed;
  }

  /// -1: everything that receives is without the light; 1: as before.
  template <Effects effects>
  static void leave_light(Frame& frame, int by) {
    const Scene& scene = *frame.scene_;
    for (detail::CompiledInstance& instance : std::span(frame.instances_, scene.instances.size())) {
      if (instance.visible) detail::leave_shadowing_light(instance, scene.meshes[instance.mesh], by);
    }
    if constexpr (effects.has(effect::quadrics)) {
      for (detail::CompiledQuadric& quadric : std::span(quadrics_of(frame, scene), scene.quadrics.size())) {
        if (quadric.visible && quadric.lit) quadric.light_count = static_cast<std::uint8_t>(quadric.light_count + by);
      }
    }
  }
};

}  // namespace zstrip
