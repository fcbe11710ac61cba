// Prepares a frame's data for instances with an environment map.
#pragma once

#include "zstrip/effects/environment/kept.hpp"
#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::environment {

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::environment;

  template <Effects effects>
  static Status check(const FrameRequest& request) {
    const SceneCounts& counts = request.counts;
    const std::uint64_t vertices = request.plan.mode == Mode::binned ? counts.vertices : counts.largest_meshlet;
    const std::uint64_t needed = vertices * bytes_per_vertex(request.called_for, counts);
    if (request.plan.vertex_bytes >= needed) return {};
    return too_small(Purpose::vertices, needed, request.plan.vertex_bytes);
  }
  template <Effects effects>
  static Status prepare(FrameState& frame, const FrameRequest& request) {
    if (!request.called_for.has(effect::environment)) return {};
    environment::prepare(frame, request.camera, request.called_for);
    return {};
  }
};

}  // namespace zstrip::detail::environment
