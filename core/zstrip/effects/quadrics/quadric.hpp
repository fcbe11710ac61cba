// A sphere or ellipsoid prepared for one frame. Along the ray of a pixel, depth is a linear function of the pixel plus
// the root of a quadratic one: docs/numerics.md derives both.
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/geometry/instance.hpp"
#include "zstrip/geometry/project.hpp"

namespace zstrip::detail {

/// A vector that is start + columns * step_x + rows * step_y + root_part * root, of any length.
struct DirectionPlane {
  std::int32_t start[3], step_x[3], step_y[3];  ///< sums stay below 2^29
  std::int32_t root_part[3];                    ///< below 2^15; multiplies the root >> CompiledQuadric::direction_shift
};

struct CompiledQuadric {
  // Radicand and linear part are polynomials of the pixel's distance to the anchor, in the depth units of project_depth
  // (1/2^32 of all codes). Modulo 2^64.
  std::uint64_t radicand, radicand_x, radicand_y, radicand_xx, radicand_xy, radicand_yy;  ///< times 2^(-2 root_shift)
  std::uint64_t linear, linear_x, linear_y;
  std::int64_t nearest, farthest;   ///< linear part plus or minus root, at the ends of the depth range
  DirectionPlane normal;            ///< in world space
  DirectionPlane surface;           ///< in the unit sphere's space; only if textured
  Rect box;                         ///< raster pixels that the quadric can cover, cut to the view
  std::int32_t anchor_x, anchor_y;  ///< a raster pixel of the box
  std::int32_t root_shift;          ///< a root of the radicand times 2^this is depth
  std::int32_t direction_shift;     ///< a root in units of depth >> this is below 2^15
  ObjectLight lights[kMaxLights];   ///< in world space
  Colour ambient, base;             ///< light times material; the material's colour
  std::uint16_t material;
  std::uint8_t light_count;
  bool lit, textured, visible;
  bool cut;           ///< the quadric reaches beyond the depth range: its depth needs 64 bits and a test
  bool shows_inside;  ///< for a cut quadric: the far side is drawn where the near side is cut away
};
static_assert(sizeof(CompiledQuadric) <= kQuadricBytes);

void extend(DistanceRange& reach, std::span<const Quadric> quadrics, const Camera& camera);

/// Returns the distances that the quadric spans along the viewing direction. They may be behind the camera.
DistanceRange distance_range(const Quadric& quadric, const Camera& camera);

/// `fit` and `origin` are the frame's, in any format. Returns Error::quadric if the transform has no inverse.
Status compile_quadric(CompiledQuadric& compiled, const Scene& scene, const Quadric& quadric, const Camera& camera,
                       const View& view, const DepthFit& fit, const RasterOrigin& origin);

}  // namespace zstrip::detail
