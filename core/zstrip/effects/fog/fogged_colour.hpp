// Fog at a single pixel, for quadrics and lines, which have no spans.
#pragma once

#include <cstdint>

#include "zstrip/effects/fog/fog.hpp"
#include "zstrip/pixels/colour.hpp"

namespace zstrip::detail {

/// `depth` is in 1/2^32 of all codes, `depth_offset` is that of distance_at. With a threshold the pixel is dithered.
template <bool orthographic, class... Threshold>
std::uint16_t fogged_colour(const FogCurve& fog, const FragmentColour& colour, std::uint32_t depth,
                            std::int64_t depth_offset, Threshold... threshold) {
  const Fixed distance = distance_at<orthographic>(fog.distance, depth, depth_offset);
  const auto share = static_cast<std::uint32_t>(visibility(fog, distance) + 128) >> 8;
  const Colour& other = fog.colour;
  const std::uint32_t r = mixed(colour.r, other.r, share), g = mixed(colour.g, other.g, share),
                      b = mixed(colour.b, other.b, share);
  if constexpr (sizeof...(threshold) != 0) return dithered_rgb565(r, g, b, threshold...);
  return rgb565(r << 16, g << 16, b << 16);
}

}  // namespace zstrip::detail
