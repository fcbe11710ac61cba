// The rectangle and the depth range that a frame's scene can fill, from bounding boxes alone.
#pragma once

#include "zstrip/geometry/project.hpp"
#include "zstrip/scene/camera.hpp"
#include "zstrip/scene/scene.hpp"
#include "zstrip/scene/view.hpp"

namespace zstrip::detail {

/// Fitted to all instances that reach into the camera's depth range, or that range itself if the camera says so;
/// near == 0 if there is no such instance.
DepthFit fit_to_scene(const Scene& scene, const Camera& camera);

/// Picture pixels that the instance's bounding box can cover, cut to the view.
Rect bounds_of(const CompiledInstance& instance, const RasterOrigin& origin, const View& view, bool orthographic);

/// What a meshlet's bounding sphere can cover: pixels as bounds_of gives them, and the nearest depth code.
struct SphereBounds {
  Rect box;
  std::uint32_t nearest;
};
/// z16 only. `meshlet` null: of the instance's whole box.
SphereBounds sphere_bounds(const CompiledInstance& instance, const Mesh& mesh, const Meshlet* meshlet,
                           const RasterOrigin& origin, const View& view, bool orthographic);

}  // namespace zstrip::detail
