// The stages of effects, in the order in which each hook calls them.
#pragma once

#include "zstrip/effects/billboards/billboard_stage.hpp"
#include "zstrip/effects/blending/blending_stage.hpp"
#include "zstrip/effects/csg/csg_stage.hpp"
#include "zstrip/effects/dithering/dithering_stage.hpp"
#include "zstrip/effects/edges/edge_stage.hpp"
#include "zstrip/effects/environment/environment_stage.hpp"
#include "zstrip/effects/fog/fog_stage.hpp"
#include "zstrip/effects/fragments/fragment_stage.hpp"
#include "zstrip/effects/lines/line_stage.hpp"
#include "zstrip/effects/local_light/local_light_stage.hpp"
#include "zstrip/effects/outlines/outline_stage.hpp"
#include "zstrip/effects/overlay/overlay_stage.hpp"
#include "zstrip/effects/pixel_shading/pixel_shading_stage.hpp"
#include "zstrip/effects/quadrics/quadric_stage.hpp"
#include "zstrip/effects/samples/sample_stage.hpp"
#include "zstrip/effects/shadows/shadow_stage.hpp"
#include "zstrip/effects/skins/skin_stage.hpp"
#include "zstrip/effects/unclipped/unclipped_stage.hpp"

namespace zstrip::detail {

template <class... Stages>
struct StageList {
  static constexpr Effects kEffects = (Stages::kEffects | ...);

  /// Calls visit(stage) for the stages that a renderer with `effects` has. Visitors take stages by reference: by value,
  /// GCC tells every user on Arm that such parameters were passed differently before GCC 7.
  template <Effects effects, class Visit>
  [[gnu::always_inline]] static void for_each([[maybe_unused]] const Visit& visit) {
    (call<effects, Stages>(visit), ...);
  }
  template <Effects effects, class Visit>
  [[gnu::always_inline]] static Status until_error([[maybe_unused]] const Visit& visit) {
    if constexpr (!effects.any(kEffects)) return {};
    Status status{};
    (call_unless_failed<effects, Stages>(visit, status) && ...);
    return status;
  }
  template <Effects effects>
  static constexpr bool any_changes_scene() {
    return ((effects.any(Stages::kEffects) && Stages::kChangesScene) || ...);
  }

 private:
  template <Effects effects, class Stage, class Visit>
  [[gnu::always_inline]] static void call([[maybe_unused]] const Visit& visit) {
    if constexpr (effects.any(Stage::kEffects)) visit(Stage{});
  }
  template <Effects effects, class Stage, class Visit>
  [[gnu::always_inline]] static bool call_unless_failed([[maybe_unused]] const Visit& visit,
                                                        [[maybe_unused]] Status& status) {
    if constexpr (effects.any(Stage::kEffects)) {
      status = visit(Stage{});
      return static_cast<bool>(status);
    }
    return true;
  }
};

// The reasons for this order: rotated billboards cast shadows, hulls do not. Blended instances are drawn last; their
// order comes before CSG, which counts first meshlets in it. Environment maps must count as textures when instances
// with fragments are found, and pixel light is added to these. CSG regards the z-buffer's contents as its own, so that
// it is drawn before other surfaces. Edges are blended, or samples averaged, before the overlay, and the overlay comes
// before dithering.
using Stages = StageList<billboards::Stage, shadows::Stage, outlines::Stage, blending::Stage, local_light::Stage,
                         environment::Stage, fog::Stage, fragments::Stage, pixel_shading::Stage, csg::Stage,
                         quadrics::Stage, lines::Stage, edges::Stage, samples::Stage, overlay::Stage, unclipped::Stage,
                         skins::Stage, dithering::Stage>;

}  // namespace zstrip::detail
