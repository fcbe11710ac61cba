// Draws the lines of a frame: prepared once, drawn into each strip before the triangles.
#pragma once

#include <span>

#include "zstrip/effects/fog/curve_of.hpp"
#include "zstrip/effects/lines/line_fill.hpp"
#include "zstrip/effects/lines/prepared.hpp"
#include "zstrip/effects/stage.hpp"
#include "zstrip/stages/materials.hpp"

namespace zstrip::detail::lines {

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::lines;

  template <Effects effects>
  static void extend_reach(const FrameState&, const Scene& scene, const FrameRequest& request, DistanceRange& reach) {
    extend(reach, scene, request.camera);
  }
  template <Effects effects>
  static Status prepare_geometry(FrameState& frame, const Scene& scene, const FrameRequest& request) {
    return lines::prepare(frame, scene, request.camera);
  }

  template <Effects effects>
  static void change_mapping(const FrameState& frame, const Scene& scene, const DepthMapping& mapping) {
    for (CompiledLines& lines : compiled_lines(frame.instances, scene)) {
      DepthFit fit = frame.fit;
      RasterOrigin origin = frame.origin;
      change_depth_mapping(mapping, effects.has(effect::orthographic), fit, origin, {&lines.instance, 1});
    }
  }
  template <Effects effects>
  static void draw_surfaces(FrameState& frame, const StripTarget& target, std::uint16_t) {
    const Scene& scene = *frame.scene;
    const std::span<const CompiledLines> all = compiled_lines(frame.instances, scene);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!all[i].instance.visible) continue;
      const LineSet& lines = scene.lines[i];
      LineShade<effects> shade;
      if constexpr (effects.has(effect::fog)) {
        if (scene.fog != nullptr) shade.fog = fog::curve_of(frame);
        shade.depth_offset =
            effects.has(effect::orthographic) ? std::int64_t{frame.origin.depth_offset} : frame.fit.offset;
      }
      if constexpr (effects.has(effect::dithered_colours)) {
        shade.dither = {-target.view_left, -target.view_top, dithers_colours(frame.view)};
      }
      if constexpr (effects.has(effect::supersampled)) {
        shade.grid = {static_cast<std::int32_t>(sample_columns(frame.view)),
                      static_cast<std::int32_t>(sample_rows(frame.view))};
      }
      LineFill<effects>::draw(Materials::depth_target<effects>(frame, target, lines.material), all[i], lines,
                              scene.meshes[lines.mesh], frame.origin, shade);
    }
  }
};

}  // namespace zstrip::detail::lines
