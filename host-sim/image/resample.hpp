// Brings a picture to the sides that a texture can have.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "image/rgb_image.hpp"

namespace zstrip::sim {

inline constexpr std::uint32_t kMaxTextureSide = 2048;
/// A picture of no more texels may be a palette: meshes take the colour at the centre of a texel.
inline constexpr std::size_t kMaxPaletteTexels = 4096;

/// Of a power of two.
constexpr int log2_of(std::uint32_t side) { return std::countr_zero(side); }

/// Sides become the next power of two, at most kMaxTextureSide; bilinear, repeating beyond the borders. What may be a
/// palette is not interpolated: the centre of each of its texels keeps its colour. Pictures with longer sides are
/// halved by averaging first, so that no texel is skipped. Sides >= 1.
RgbImage resample_to_power_of_two(RgbImage image);

/// Averages pairs along one or both axes; an odd last row or column is averaged with itself.
RgbImage halve(const RgbImage& from, bool halve_x, bool halve_y);

}  // namespace zstrip::sim
