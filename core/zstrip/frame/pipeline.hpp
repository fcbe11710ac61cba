// One pipeline for each set of effects: the entry points that the renderer needs.
#pragma once

#include <cstddef>
#include <span>

#include "zstrip/state/frame_state.hpp"

namespace zstrip {

/// A pipeline with effect::depth_ranges accepts only a RangedFrameState, one with a method only a MethodFrameState.
struct Pipeline {
  Status (*begin_frame)(detail::FrameState&, const Scene&, const Camera&, const View&, const Plan&,
                        std::span<std::byte> arena);
  Status (*draw_strip)(detail::FrameState&, std::uint16_t strip, std::span<std::byte> pixels);
  Status (*draw_over)(detail::FrameState&, const Rect& area, std::span<std::uint16_t> pixels,
                      std::span<std::uint16_t> depth);
};

/// Returns a pipeline that draws the same pixels as one with exactly `effects`. It may have more effects, but has the
/// same depth format, projection and method. One of effect::perspective_runs is ignored without textures or with an
/// orthographic projection. Effects that exclude each other, or are unknown, get a pipeline that refuses every frame
/// with Error::depth_effects; so does one of effect::perspective_runs together with a depth format or sub-ranges.
/// Methods that exclude each other, and culling with another depth format or sub-ranges, which only Renderer supports,
/// get Error::visibility. Links all pipelines: for hosts (library zstrip::core_any).
Pipeline pipeline_for(Effects effects);

}  // namespace zstrip
