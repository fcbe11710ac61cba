// The transforms of instances in front of a camera, with rotated billboards, for tools without a renderer.
#pragma once

#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Returns the instance's transform, or that of a billboard as docs/conventions.md rotates it: computed in floating
/// point, then rounded to 16.16. `scene` must be valid.
Transform standing(const Scene& scene, const Instance& instance, const Camera& camera);

}  // namespace zstrip::sim
