// Where instances stand before a camera, billboards turned to it, for tools without a renderer.
#pragma once

#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// The instance's transform, or that of a billboard as docs/conventions.md turns it: found in floating point, then
/// rounded to 16.16. `scene` is valid.
Transform standing(const Scene& scene, const Instance& instance, const Camera& camera);

}  // namespace zstrip::sim
