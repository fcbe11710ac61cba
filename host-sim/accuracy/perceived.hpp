// The difference between two pictures as the eye sees it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace zstrip::sim {

/// Returns the perceived difference of each pixel: CIELAB is smoothed to what the eye resolves at 67 pixels a degree,
/// then
/// dL| + |dab| is taken, 0..about 200. 1 is just noticeable.
std::vector<float> perceived_difference(std::uint32_t width, std::uint32_t height,
                                        std::span<const std::array<float, 3>> a,
                                        std::span<const std::array<float, 3>> b);

}  // namespace zstrip::sim
