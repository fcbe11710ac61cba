// A vertex as the span rasteriser takes it.
#pragma once

#include "zstrip/pixels/colour.hpp"
#include "zstrip/pixels/plane.hpp"

namespace zstrip::kernels_test {

inline detail::RasterVertex raster_vertex(const detail::SnappedVertex& v, const Colour& colour) {
  return {.x = v.x,
          .y = v.y,
          .depth = v.depth,
          .r = detail::channel_start(colour.r),
          .g = detail::channel_start(colour.g),
          .b = detail::channel_start(colour.b),
          .u = 0,
          .v = 0};
}

}  // namespace zstrip::kernels_test
