// Computes the rectangle and the depth range that a frame's scene can fill, from bounding boxes alone.
#pragma once

#include "zstrip/camera.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace zstrip::detail {

/// Returns the distances of all instances that reach into the camera's depth range; kNoReach if none does.
DistanceRange reach_of(const Scene& scene, const Camera& camera);

/// Returns a fit to `reach` in front of the camera, or to the camera's fixed range; near == 0 for kNoReach.
DepthFit fit_to(const DistanceRange& reach, const Camera& camera);

/// Returns the picture pixels that the instance's bounding box can cover, cut to the view.
Rect bounds_of(const CompiledInstance& instance, const RasterOrigin& origin, const View& view, bool orthographic);

/// Returns bounds_of, extended by `border` pixels.
Rect bounds_with_border(const CompiledInstance& instance, std::int32_t border, const RasterOrigin& origin,
                        const View& view, bool orthographic);

/// The picture pixels that a meshlet's bounding sphere can cover, cut to the view, and the nearest depth code.
struct SphereBounds {
  Rect box;
  std::uint32_t nearest;
};
/// For z16 only. A null `meshlet` means the instance's whole box.
SphereBounds sphere_bounds(const CompiledInstance& instance, const Mesh& mesh, const Meshlet* meshlet,
                           const RasterOrigin& origin, const View& view, bool orthographic);

}  // namespace zstrip::detail
