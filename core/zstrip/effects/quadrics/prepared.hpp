// Prepares the quadrics of a frame, before its strips.
#pragma once

#include "zstrip/effects/quadrics/quadric.hpp"
#include "zstrip/state/frame_parts.hpp"

namespace zstrip::detail::quadrics {

/// Compiles the quadrics for the frame's current depth mapping.
Status prepare(FrameState& frame, const Scene& scene, const Camera& camera);
/// Returns the compiled quadrics, which lie after the instances in their part of the arena.
inline CompiledQuadric* compiled(const FrameState& frame, const Scene& scene) {
  auto* const first = reinterpret_cast<std::byte*>(frame.instances);
  return reinterpret_cast<CompiledQuadric*>(first + scene.instances.size() * kInstanceBytes);
}

}  // namespace zstrip::detail::quadrics
