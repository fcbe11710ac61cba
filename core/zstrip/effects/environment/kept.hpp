// The data that a frame keeps for environment maps.
#pragma once

#include "zstrip/effects/environment/effect.hpp"
#include "zstrip/effects/environment/environment.hpp"
#include "zstrip/state/frame_parts.hpp"

namespace zstrip::detail::environment {

/// The texture coordinates of mirroring instances lie after the colours of vertices.
struct FrameReflections {
  std::uint32_t first;  ///< offset in bytes from the vertices
  std::uint32_t unused;
};
static_assert(sizeof(FrameReflections) == Effect::kFrameBytes && sizeof(EyeForms) == Effect::kEyeFormsBytes);

// Returns the data of a frame with environment maps.
inline FrameReflections& reflections_of(const FrameState& frame) {
  return *effect_block(frame).at<Effect, FrameReflections>();
}
inline EyeForms& eye_forms_of(const FrameState& frame, std::size_t instance) {
  return effect_block(frame).at<Effect, EyeForms>(Effect::kFrameBytes)[instance];
}

/// Prepares the instances, before the strips. Mirroring instances get the shades of textured ones.
void prepare(FrameState& frame, const Camera& camera, Effects called_for);

}  // namespace zstrip::detail::environment
