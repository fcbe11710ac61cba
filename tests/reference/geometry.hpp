// From the quantised scene to clip space and colours, in double: docs/conventions.md written down a second time, with
// nothing of the renderer but the scene's data types.
#pragma once

#include <cstdint>
#include <vector>

#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace zstrip::reference {

/// One corner of one triangle; nothing is shared, so that flat triangles carry one colour three times.
struct Corner {
  float x, y, z, w;  ///< clip space with y down the picture; z/w = 1 at the near end of the depth range, -1 at the far
  float r, g, b;     ///< 0..255; of an unlit texture white
  float u, v;        ///< 1.0 is the whole texture
  std::uint32_t triangle;  ///< 1 + number of the triangle in drawing order
};

/// Corners that are drawn with the same state.
struct Batch {
  std::uint32_t first_corner = 0;
  std::uint32_t corners = 0;
  std::uint16_t texture = kNoTexture;
  bool double_sided = false;
};

struct Geometry {
  std::vector<Corner> corners;  ///< three for each triangle, cut at the near end of the depth range: w > 0
  std::vector<Batch> batches;   ///< one for each instance, in drawing order
};

/// The scene must be valid. Depth is fitted to the instances' bounding boxes inside the camera's near and far planes.
Geometry geometry_of(const Scene& scene, const Camera& camera, const View& view);

}  // namespace zstrip::reference
