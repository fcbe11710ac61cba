// One pipeline per effect set: the entry points that the renderer needs.
#pragma once

#include <cstddef>
#include <span>

#include "zstrip/stages/frame_state.hpp"

namespace zstrip {

/// A pipeline with effect::depth_ranges takes a RangedFrameState only, one with a method a MethodFrameState.
struct Pipeline {
  Status (*begin_frame)(detail::FrameState&, const Scene&, const Camera&, const View&, const Plan&,
                        std::span<std::byte> arena);
  Status (*draw_strip)(detail::FrameState&, std::uint16_t strip, std::span<std::byte> pixels);
  Status (*draw_over)(detail::FrameState&, const Rect& area, std::span<std::uint16_t> pixels,
                      std::span<std::uint16_t> depth);
};

/// A pipeline that draws the same as one with exactly `effects`: it may have more of them, but no other depth format,
/// projection and method. One of effect::perspective_runs is left out where nothing is textured or the projection is
/// orthographic. Effects that do not agree, or are unknown, get one that refuses every frame with Error::depth_effects;
/// so does one of effect::perspective_runs beside a depth format or sub-ranges. Methods that do not agree, and culling
/// with another depth format or sub-ranges, which is left to Renderer, get Error::visibility. Links all pipelines: for
/// hosts (library zstrip::core_any).
Pipeline pipeline_for(Effects effects);

}  // namespace zstrip
