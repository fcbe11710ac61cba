// Resamples a picture to sides that a texture can have.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "image/rgb_image.hpp"

namespace zstrip::sim {

inline constexpr std::uint32_t kMaxTextureSide = 2048;
/// A picture with at most so many texels can be a palette, where meshes use the colour at the centre of a texel.
inline constexpr std::size_t kMaxPaletteTexels = 4096;

/// Returns the logarithm of a power of two.
constexpr int log2_of(std::uint32_t side) { return std::countr_zero(side); }

/// Makes the sides the next power of two, at most kMaxTextureSide; bilinear, repeated at the borders. A picture that
/// can be a palette is not interpolated: the centre of each of its texels keeps its colour. Pictures with longer sides
/// are first halved by averaging, so that no texel is skipped. Sides >= 1.
RgbImage resample_to_power_of_two(RgbImage image);

/// Averages pairs along one or both axes; an odd last row or column is averaged with itself.
RgbImage halve(const RgbImage& from, bool halve_x, bool halve_y);

}  // namespace zstrip::sim
