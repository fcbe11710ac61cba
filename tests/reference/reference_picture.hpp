// What the reference shows at the centre of each pixel, and around it.
#pragma once

#include <array>
#include <vector>

#include "canvas.hpp"
#include "geometry.hpp"
#include "render/stage.hpp"
#include "result.hpp"

namespace zstrip::reference {

/// Pixels. Snapping to 1/16 moves a vertex by up to 1/32 on each axis, its arithmetic and OpenGL's own snapping (1/256)
/// by less.
inline constexpr float kReach = 1.0F / 16;
/// Depth codes. Each of two surfaces is within one code of its exact depth.
inline constexpr double kDepthTolerance = 2;

struct ReferencePicture {
  View view;
  Geometry geometry;
  std::array<Layers, 9> layers;  ///< within reach; the first at the centres
  std::vector<Samples> drifts;   ///< further along the row; for texels only

  const Samples& centres() const { return layers.front().nearest; }
};

/// `drift`, in pixels: texture coordinates are exact at every 16th pixel of a row and linear between. Both lie on the
/// same line of the texture, so that a pixel shows a texel which the exact picture shows a little further along the
/// row: by 4 q pixels where the distance changes by the fraction q (small) within 16 pixels. The most that the frame
/// calls for.
sim::Result<ReferencePicture> draw_reference(const sim::Staging& staging, const View& view, float drift);

}  // namespace zstrip::reference
