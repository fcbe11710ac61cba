// Renderers without clipping: refuses a frame if the box of an instance might need clipping.
#pragma once

#include "zstrip/effects/stage.hpp"
#include "zstrip/geometry/project.hpp"

namespace zstrip::detail::unclipped {

/// True if project_narrow accepts every position, with any reciprocal. Its limits for x, y and w are linear in the
/// position, so that testing the corners of the box is enough.
template <bool orthographic>
bool is_box_narrow(const CompiledInstance& instance, const RasterOrigin& origin);

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::unclipped;

  template <Effects effects>
  static Status prepare_geometry(FrameState& frame, const Scene& scene, const FrameRequest&) {
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
      const CompiledInstance& instance = frame.instances[i];
      if (instance.visible && !is_box_narrow<effects.has(effect::orthographic)>(instance, frame.origin)) {
        return {.error = Error::clipping, .needed = static_cast<std::uint32_t>(i)};
      }
    }
    return {};
  }
};

}  // namespace zstrip::detail::unclipped
