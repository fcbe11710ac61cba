// Quadrics of a frame, as they are prepared before its strips.
#pragma once

#include "zstrip/effects/quadrics/quadric.hpp"
#include "zstrip/stages/frame_parts.hpp"

namespace zstrip::detail::quadrics {

/// Compiles the quadrics, for the depth mapping that the frame has now.
Status prepare(FrameState& frame, const Scene& scene, const Camera& camera);
/// Behind the instances, in their part of the arena.
inline CompiledQuadric* compiled(const FrameState& frame, const Scene& scene) {
  auto* const first = reinterpret_cast<std::byte*>(frame.instances);
  return reinterpret_cast<CompiledQuadric*>(first + scene.instances.size() * kInstanceBytes);
}

}  // namespace zstrip::detail::quadrics
