// The data that a frame keeps of environment maps.
#pragma once

#include "zstrip/effects/environment/effect.hpp"
#include "zstrip/effects/environment/environment.hpp"
#include "zstrip/stages/frame_parts.hpp"

namespace zstrip::detail::environment {

/// Texture coordinates of what mirrors lie behind the colours of vertices.
struct FrameReflections {
  std::uint32_t first;  ///< bytes from the vertices
  std::uint32_t unused;
};
static_assert(sizeof(FrameReflections) == Effect::kFrameBytes && sizeof(EyeForms) == Effect::kEyeFormsBytes);

// Returns the data of a frame in which something has an environment map.
inline FrameReflections& reflections_of(const FrameState& frame) {
  return *effect_block(frame).at<Effect, FrameReflections>();
}
inline EyeForms& eye_forms_of(const FrameState& frame, std::size_t instance) {
  return effect_block(frame).at<Effect, EyeForms>(Effect::kFrameBytes)[instance];
}

/// Before the strips. Instances that mirror get the shades of textured ones.
void prepare(FrameState& frame, const Camera& camera, Effects called_for);

}  // namespace zstrip::detail::environment
