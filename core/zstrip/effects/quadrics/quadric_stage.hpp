// Draws the quadrics of a frame: prepared once, drawn into each strip before lines and triangles.
#pragma once

#include "zstrip/effects/fog/curve_of.hpp"
#include "zstrip/effects/quadrics/prepared.hpp"
#include "zstrip/effects/quadrics/quadric_fill.hpp"
#include "zstrip/effects/quadrics/quadric_shade.hpp"
#include "zstrip/effects/stage.hpp"
#include "zstrip/stages/materials.hpp"

namespace zstrip::detail::quadrics {

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::quadrics;

  template <Effects effects>
  static void extend_reach(const FrameState&, const Scene& scene, const FrameRequest& request, DistanceRange& reach) {
    extend(reach, scene.quadrics, request.camera);
  }
  template <Effects effects>
  static Status prepare_surfaces(FrameState& frame, const Scene& scene, const FrameRequest& request) {
    return quadrics::prepare(frame, scene, request.camera);
  }

  template <Effects effects>
  static void draw_surfaces(FrameState& frame, const StripTarget& target, std::uint16_t) {
    constexpr bool kOrthographic = effects.has(effect::orthographic);
    const std::int64_t offset = kOrthographic ? std::int64_t{frame.origin.depth_offset} : -frame.fit.offset;
    const CompiledQuadric* const quadrics = compiled(frame, *frame.scene);
    for (std::size_t i = 0; i < frame.scene->quadrics.size(); ++i) {
      const CompiledQuadric& quadric = quadrics[i];
      if (!quadric.visible) continue;
      QuadricShade<effects> shade{quadric, Materials::texture_of(frame, quadric.material)};
      if constexpr (effects.has(effect::fog)) {
        if (frame.scene->fog != nullptr) shade.fog = fog::curve_of(frame);
        shade.depth_offset = kOrthographic ? offset : -offset;
      }
      if constexpr (effects.has(effect::dithered_colours)) {
        shade.dither = {quadric.anchor_x - target.view_left, quadric.anchor_y - target.view_top,
                        dithers_colours(frame.view)};
      }
      QuadricFill<effects>::draw(Materials::depth_target<effects>(frame, target, quadric.material), quadric, offset,
                                 shade);
    }
  }
};

}  // namespace zstrip::detail::quadrics
