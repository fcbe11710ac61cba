// Shadows. Before a frame, the stages that draw the picture draw the map from the light. After a strip, its shadowed
// pixels are drawn again without the light: their cells are cleared, and no cell without shadow lets a fragment pass.
// Strips without shadowed pixels are drawn once.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/effects/edges/saved_depth.hpp"
#include "zstrip/effects/quadrics/quadric_stage.hpp"
#include "zstrip/effects/shadows/map_frame.hpp"
#include "zstrip/effects/stage.hpp"
#include "zstrip/stages/raster_stage.hpp"
#include "zstrip/visibility/traits.hpp"

namespace zstrip::detail::shadows {

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::shadows;
  static constexpr bool kChangesScene = true;

  template <Effects effects>
  static Status check(const FrameRequest& request) {
    return request.called_for.has(effect::shadows) ? check_memory(request) : Status{};
  }

  template <Effects effects>
  static Status check_over(const FrameState& frame) {
    return frame.scene->shadow == nullptr ? Status{} : Status{.error = Error::shadow};
  }

  /// Draws the map, with rotated billboards and without hulls, and puts the light last.
  template <Effects effects>
  static Status change_scene(FrameState& frame, Scene& drawn, const FrameRequest& request, const Camera&) {
    if (!request.called_for.has(effect::shadows)) return {};
    frame.has_special_depth = true;
    ShadowState& state = begin_state(frame, request.scene);
    if constexpr (effects.has(effect::edges)) {
      // The groups of edges follow the pool; see end_of_pool.
      if (request.called_for.has(effect::edges)) {
        const std::size_t groups = std::size_t{request.counts.edge_groups} * edges::Effect::kGroupBytes;
        state.pool = state.pool.first(state.pool.size() - groups);
      }
    }
    drawn.lights = state.scene.lights;
    LightReach reach(drawn.lights.back());
    for (const Instance& instance : drawn.instances) {
      if (casts(drawn, instance)) {
        reach.extend(
            [&](const Camera& axis) { return distance_range(drawn.meshes[instance.mesh], instance.transform, axis); });
      }
    }
    if constexpr (effects.has(effect::quadrics)) {
      for (const Quadric& quadric : drawn.quadrics) {
        reach.extend([&](const Camera& axis) { return distance_range(quadric, axis); });
      }
    }
    state.empty = reach.empty();
    if (state.empty) return {};
    Scene casters = drawn;
    casters.outlines = {};
    return draw_map<kCasting<effects>>(frame, casters, reach, state);
  }

  template <Effects effects>
  static void keep_scene(FrameState& frame, const FrameRequest& request) {
    if (request.called_for.has(effect::shadows)) frame.scene = &state_of(frame).scene;
  }

  template <Effects effects>
  static Status prepare(FrameState& frame, const FrameRequest& request) {
    if (!request.called_for.has(effect::shadows)) return {};
    return prepare_place(frame, request.camera, request.called_for, depth_of_code<depth_format(effects)>(1));
  }

  /// `target` was drawn with all lights.
  template <Effects effects>
  static Status finish(FrameState& frame, const StripTarget& target, const StripImage& image) {
    if (target.area.empty() || !effect_block(frame).has(effect::shadows)) return {};
    ShadowState& state = state_of(frame);
    if (state.empty) return {};
    if constexpr (effects.has(effect::edges)) {
      // Edges are blended by the codes of what was drawn.
      const bool keeps = !effects.any(kMayPassAgain) || !effect_block(frame).has(kMayPassAgain);
      if (keeps) return shade<effects, true>(frame, target, state, image.strip);
      if (edges::has_apron<effects>(frame)) {
        const edges::SavedDepth saved(frame, target, image);
        const Status status = shade<effects, false>(frame, target, state, image.strip);
        saved.restore();
        return status;
      }
    }
    return shade<effects, false>(frame, target, state, image.strip);
  }

 private:
  /// Draws the shadowed pixels again. With `keeps_codes` the z-buffer then holds the codes that it holds now; no
  /// material may let a fragment pass twice. Inlined, as most renderers have one call.
  template <Effects effects, bool keeps_codes>
  [[gnu::always_inline]] static Status shade(FrameState& frame, const StripTarget& target, ShadowState& state,
                                             std::uint16_t strip) {
    Status status{};
    const Rect shadowed = find<effects, keeps_codes>(target, state, status);
    if (!status || shadowed.empty()) return status;
    using Cell = DepthCell<depth_format(effects)>;
    // Bounds of depth begin again from the changed cells.
    StripTarget part = target;
    if constexpr (methods::keeps_bounds(effects)) {
      auto& with_bounds = static_cast<MethodFrameState&>(frame);
      with_bounds.state.bounds.begin(with_bounds.depth_bounds, target.area, target.depth);
    } else {
      part = part_of<Cell>(target, shadowed);
    }
    [[maybe_unused]] const Statistics counted = frame.statistics;
    Colour* const lit = frame.colours;
    if (frame.mode == Mode::binned) frame.colours = state.colours_in_shadow;
    // No memory to carry triangles to the next strip: those triangles need all lights.
    const Bins bins = frame.bins;
    frame.bins = bins.without_spare();
    leave_light<effects>(frame, -1);
    draw_scene<effects>(frame, part, strip);
    leave_light<effects>(frame, 1);
    frame.bins = bins;
    frame.colours = lit;
    if constexpr (effects.has(effect::statistics)) {
      const Statistics all = frame.statistics;
      frame.statistics = counted;
      frame.statistics.work = all.work;
      frame.statistics.work[WorkKind::meshlets_again] += count(*frame.scene).meshlets;
      count_again(frame, all, counted);
    }
    return {};
  }

  /// Adds the work of drawing again between `before` and `after`.
  static void count_again(FrameState& frame, const Statistics& after, const Statistics& before) {
    auto& work = frame.statistics.work;
    work[WorkKind::vertices_again] += after.vertices - before.vertices;
    work[WorkKind::triangles_again] += after.covering - before.covering;
    work[WorkKind::fragments_again] += after.fragments - before.fragments;
  }

  /// The effects of the map's pipeline: both faces are drawn, and the bias moves them away.
  template <Effects effects>
  static constexpr Effects kCasting = effect::orthographic | effect::depth_state |
                                      (effects & (effect::quadrics | effect::skins | effect::statistics));

  template <Effects casting>
  static Status draw_map(FrameState& frame, const Scene& casters, const LightReach& reach, ShadowState& state) {
    FrameState light;
    if (const Status status = prepare_map(light, frame, casters, reach, state); !status) return status;
    if constexpr (casting.has(effect::quadrics)) {
      if (const Status status = quadrics::prepare(light, casters, state.camera); !status) return status;
    }
    divide(light, count(casters), light.view);
    light.scene = &casters;
    if (light.extents != nullptr) GeometryStage::survey<casting>(light);
    DepthSettings settings;
    settings.bias = -std::int32_t{casters.shadow->bias};
    settings.slope_bias = -casters.shadow->slope_bias;
    for (std::uint16_t strip = 0; strip < light.plan.strips; ++strip) {
      const StripTarget target = map_strip(light, strip);
      if (!target.area.empty()) draw_casters<casting>(light, {target, settings}, strip);
      if (const Status status = keep_strip(light, strip, state); !status) return status;
    }
    if constexpr (casting.has(effect::statistics)) {
      count_again(frame, light.statistics, {});
      frame.statistics.work[WorkKind::cells_of_shadow_map] += std::uint32_t{light.view.width} * light.view.height;
    }
    return {};
  }

  template <Effects casting>
  static void draw_casters(FrameState& light, const StripTargetWithDepth& target, std::uint16_t strip) {
    if constexpr (casting.has(effect::quadrics)) {
      // Closed shapes draw their far side: it shadows everything that the near side does, and never itself.
      StripTargetWithDepth unbiased{target, {}};
      const CompiledQuadric* const quadrics = quadrics::compiled(light, *light.scene);
      for (std::size_t i = 0; i < light.scene->quadrics.size(); ++i) {
        if (!quadrics[i].visible) continue;
        QuadricFill<casting, QuadricSide::far>::draw(
            unbiased, quadrics[i], light.origin.depth_offset,
            [](std::int32_t, std::int32_t, std::int32_t, std::uint32_t) { return std::uint16_t{0}; });
      }
    }
    GeometryStage::for_each_meshlet<casting>(
        light, [&](std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet) {
          if (light.extents != nullptr && !light.grid.touches(light.extents[number], light.grid.place_of(strip)))
            return;
          const MeshletRange range = meshlet_range(light.scene->meshes[light.instances[instance].mesh], meshlet);
          const auto batch = GeometryStage::batch_for<casting>(light, instance, range.first_vertex, 0);
          const bool all_narrow = GeometryStage::transform<casting>(light, batch, range, 0);
          AssemblerFor<casting>::draw(target, batch, range.triangles, all_narrow);
        });
  }

  /// Sets the cells of shadowed pixels to 0 and, unless their codes are kept, all other cells to the nearest code.
  /// Returns a rectangle that contains all shadowed pixels.
  template <Effects effects, bool keeps_codes>
  static Rect find(const StripTarget& target, ShadowState& state, Status& status) {
    constexpr DepthFormat kFormat = depth_format(effects);
    using Cell = DepthCell<kFormat>;
    const Rect& area = target.area;
    Rect shadowed{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
    // In blocks, because these touch few tiles of the map.
    constexpr std::int32_t kBlock = 8;
    for (std::int32_t left = area.left; left < area.right; left += kBlock) {
      const std::int32_t right = std::min(left + kBlock, area.right);
      for (std::int32_t y = area.top; y < area.bottom; ++y) {
        Cell* cell = target.template depth_row<Cell>(y) + (left - area.left);
        const MapRow row(state.place, y);
        MapPoint<effects.has(effect::orthographic), kFormat> at(row);
        std::int32_t first = INT32_MAX, last = INT32_MIN;
        for (std::int32_t x = left; x < right; ++x, ++cell) {
          const std::uint32_t code = *cell;
          if constexpr (!keeps_codes) *cell = static_cast<Cell>(-1);
          if (code == 0) continue;
          if constexpr (effects.has(effect::statistics)) ++target.statistics->work[WorkKind::shadow_samples];
          at.move_to(x, code);
          if (!state.hides(at, status)) continue;
          *cell = 0;
          first = std::min(first, x), last = x;
        }
        if (first <= last) {
          shadowed = {std::min(shadowed.left, first), std::min(shadowed.top, y), std::max(shadowed.right, last + 1),
                      std::max(shadowed.bottom, y + 1)};
        }
      }
    }
    return shadowed;
  }

  /// With `by` -1, removes the light from all receivers; with 1, restores it.
  template <Effects effects>
  static void leave_light(FrameState& frame, int by) {
    const Scene& scene = *frame.scene;
    for (CompiledInstance& instance : std::span(frame.instances, scene.instances.size())) {
      if (instance.visible) leave_shadowing_light(instance, scene.meshes[instance.mesh], by);
    }
    if constexpr (effects.has(effect::quadrics)) {
      for (CompiledQuadric& quadric : std::span(quadrics::compiled(frame, scene), scene.quadrics.size())) {
        if (quadric.visible && quadric.lit) quadric.light_count = static_cast<std::uint8_t>(quadric.light_count + by);
      }
    }
  }
};

}  // namespace zstrip::detail::shadows
