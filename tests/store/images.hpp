// Images to measure compression with: depth in two formats and colour, of any scene.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace store_test {

/// Cells or pixels row by row. Of depth 0 is a cleared cell, greater is nearer.
struct Image {
  std::uint16_t width = 0, height = 0;
  std::vector<std::uint16_t> cells;
};

/// The small float 3.13 of near / w (0.32): three bits of exponent above 13 of mantissa, exponent 0 denormal.
constexpr std::uint16_t small_float(std::uint32_t near_over_w) {
  if (near_over_w < (1U << 25)) return static_cast<std::uint16_t>(near_over_w >> 12);
  const auto exponent = static_cast<std::uint32_t>(std::bit_width(near_over_w)) - 25U;
  return static_cast<std::uint16_t>(exponent << 13 | (near_over_w >> (11 + exponent) & 0x1FFFU));
}

/// The scene in double precision, clipped at the camera's near plane, over the smallest rectangle that holds all that
/// is covered; vertices are snapped as the renderer snaps them. Perspective cameras only.
Image draw_small_float(const zstrip::Scene& scene, const zstrip::Camera& camera, const zstrip::View& view);

/// What the renderer draws, cut to the rectangle of what it covered: depth of 16 bits fitted to the scene's;
Image draw_fitted(const zstrip::Scene& scene, const zstrip::Camera& camera, const zstrip::View& view);
/// and its RGB565.
Image draw_colour(const zstrip::Scene& scene, const zstrip::Camera& camera, const zstrip::View& view);

}  // namespace store_test
