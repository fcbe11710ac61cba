// Triangles too thin for samples: is one of them near a pixel's centre?
#pragma once

#include <cstdint>
#include <vector>

#include "geometry.hpp"

namespace zstrip::reference {

/// Three corners on the screen, in pixels from the picture's upper left corner.
struct ScreenTriangle {
  double x[3], y[3];
  double nearest;         ///< code of its nearest corner
  const Corner* corners;  ///< three
  bool textured;
};

/// The triangles whose side within a pixel the renderer may take for the front: facing it, double-sided, or so thin
/// that snapping can turn them round. `geometry` must outlive the result.
std::vector<ScreenTriangle> on_screen(const Geometry& geometry, const View& view);

/// Distance of a point from a triangle, 0 inside.
double distance(const ScreenTriangle& triangle, double x, double y);

}  // namespace zstrip::reference
