// LDR-FLIP: the difference that is seen when one flips between two pictures in one place (Andersson, Nilsson,
// Akenine-Moeller, Oskarsson, Astrom, Fairchild: "FLIP: A Difference Evaluator for Alternating Images", HPG 2020).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace zstrip::sim {

/// 67: a monitor of 3840 pixels on 0.7 m seen from 0.7 m; also a good guess for a panel of 0.1 mm a pixel in the hand.
inline constexpr double kPixelsPerDegree = 67;

/// Returns 0 (equal) to 1 for each pixel. Colours are sRGB, 0..255. Symmetric in the two pictures.
std::vector<float> flip(std::uint32_t width, std::uint32_t height, std::span<const std::array<float, 3>> a,
                        std::span<const std::array<float, 3>> b, double pixels_per_degree = kPixelsPerDegree);

}  // namespace zstrip::sim
