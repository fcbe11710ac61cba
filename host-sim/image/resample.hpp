// Brings a picture to the sides that a texture can have.
#pragma once

#include <bit>

#include "image/rgb_image.hpp"

namespace zstrip::sim {

inline constexpr std::uint32_t kMaxTextureSide = 2048;

/// Of a power of two.
constexpr int log2_of(std::uint32_t side) { return std::countr_zero(side); }

/// Sides become the next power of two, at most kMaxTextureSide; bilinear, repeating beyond the borders.
/// Larger pictures are halved by averaging first, so that no texel is skipped. Sides >= 1.
RgbImage resample_to_power_of_two(RgbImage image);

/// Averages pairs along one or both axes; an odd last row or column is averaged with itself.
RgbImage halve(const RgbImage& from, bool halve_x, bool halve_y);

}  // namespace zstrip::sim
