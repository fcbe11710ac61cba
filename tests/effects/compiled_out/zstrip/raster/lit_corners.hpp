// Declared, not there: what code without light at pixels may know of it.
#pragma once

#include "zstrip/raster/fragment_settings.hpp"
#include "zstrip/raster/span_triangle.hpp"

namespace zstrip::detail {

struct LitCorner {};
struct LitSurface : Surface {
  LitCorner corners[3];
};
template <Effects effects>
using FragmentSurface = Surface;
template <Effects effects>
LitCorner lit_corner(const Mesh& mesh, std::uint32_t vertex, const PixelLightSettings& settings);
template <class Vertex>
void set_corner(Vertex& vertex, int corner);
void take_corners(RasterVertex (&vertices)[3], const LitCorner (&of)[3], const RasterVertex (&colours)[3],
                  LitSurface& surface);

}  // namespace zstrip::detail
