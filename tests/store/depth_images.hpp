// Depth images to measure compression with, of any scene, in the two formats.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "zstrip/scene/camera.hpp"
#include "zstrip/scene/scene.hpp"
#include "zstrip/scene/view.hpp"

namespace store_test {

/// Cells row by row; 0 is a cleared cell, greater is nearer.
struct DepthImage {
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
DepthImage draw_small_float(const zstrip::Scene& scene, const zstrip::Camera& camera, const zstrip::View& view);

/// What the renderer draws: 16 bits fitted to the scene's depth, cut to the same kind of rectangle.
DepthImage draw_fitted(const zstrip::Scene& scene, const zstrip::Camera& camera, const zstrip::View& view);

}  // namespace store_test
