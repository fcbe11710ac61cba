// Kernel: draws textured triangles that are at most 16 pixels wide, instead of their spans. Each row is one run of
// texels, and all planes fit words of 32 bits.
//
// Vertices are as in medium_triangle.hpp. Every implementation writes the same bits as the span rasteriser. Only for
// the depth test of z16, without counting.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/pixels/medium_scan.hpp"
#include "zstrip/pixels/target.hpp"
#include "zstrip/pixels/textured_run_state.hpp"
#include "zstrip/pixels/textured_scan.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// The 64-bit planes of spans take most of the time of a small textured triangle. Left out with -Os.
inline constexpr bool kHasMediumTextured = !kForSize;

struct MediumTexture {
  const TexturedVertex* const (&vertices)[3];
  const Colour* const (&colours)[3];  ///< not read if texels are unlit; only the first one is read with flat light
  const Surface& surface;
};

/// Draws a triangle, or returns false and leaves it to its spans. `affine`: coordinates are not divided by w.
template <TexelLight lit, bool affine>
bool draw_medium_textured(const MediumTriangle& triangle, const MediumTexture& surface);

}  // namespace zstrip::detail
