// Draws single medium triangles.
#include "zstrip/kernels/vector/medium_blocks.hpp"

#if ZSTRIP_HAS_VECTORS

namespace zstrip::detail {

using namespace vectors;

namespace {

Boxes around(const MediumTriangle& t) { return {place_of(t.v0), place_of(t.v1), place_of(t.v2)}; }

}  // namespace

bool draw_medium_flat_vector(const MediumTriangle& triangle, std::uint16_t colour) {
  return draw_medium_in_blocks<false>(triangle, around(triangle), nullptr, colour);
}

bool draw_medium_gouraud_vector(const MediumTriangle& triangle, const Colour* const (&colours)[3]) {
  return draw_medium_in_blocks<true>(triangle, around(triangle), colours, 0);
}

}  // namespace zstrip::detail

#endif
