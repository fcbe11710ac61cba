// How different two pictures look to the eye.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace zstrip::sim {

/// How different two pictures look: CIELAB after what the eye does not resolve at 67 pixels a degree is smoothed away;
/// for each pixel |dL| + |dab|, 0 .. about 200. 1 is just noticeable.
std::vector<float> perceived_difference(std::uint32_t width, std::uint32_t height,
                                        std::span<const std::array<float, 3>> a,
                                        std::span<const std::array<float, 3>> b);

}  // namespace zstrip::sim
