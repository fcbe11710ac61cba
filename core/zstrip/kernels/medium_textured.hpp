// Kernel: textured triangles of at most 16 pixels between their sides, instead of their spans. Each row is one run of
// texels, and all planes fit words of 32 bits.
//
// Vertices are as those of medium_triangle.hpp. An implementation writes what the span rasteriser writes, bit by bit.
// With the depth test of z16 and nothing to count.
#pragma once

#include <cstdint>

#include "zstrip/kernels/medium_scan.hpp"
#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/textured_run_state.hpp"
#include "zstrip/raster/target.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// Planes of 64 bits, as spans have them, are what a small textured triangle takes longest for. Not for the least
/// flash.
inline constexpr bool kHasMediumTextured = !kForSize;

/// Values of a vertex for texels.
struct TexturedVertex {
  std::uint32_t depth;  ///< 16.16 codes
  std::int32_t u, v;    ///< texels, 16.16
};

/// The texture of a medium triangle, and its light.
struct MediumTexture {
  const TexturedVertex* const (&vertices)[3];
  const Colour* const (&colours)[3];  ///< not read where nothing lights the texels; of the first where light is flat
  const Surface& surface;
};

/// Draws a triangle, or returns false: it is left to its spans. `affine`: nothing is divided by w.
template <TexelLight lit, bool affine>
bool draw_medium_textured(const MediumTriangle& triangle, const MediumTexture& surface);

}  // namespace zstrip::detail
