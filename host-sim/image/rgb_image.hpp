// A picture in memory: 8 bits a channel, row-major, the first row on top.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace zstrip::sim {

struct RgbImage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> rgb;      ///< 3 * width * height
  std::vector<std::uint8_t> alpha{};  ///< width * height; empty: all pixels are opaque

  const std::uint8_t* pixel(std::uint32_t x, std::uint32_t y) const {
    return rgb.data() + 3 * (std::size_t{y} * width + x);
  }
  std::uint8_t alpha_at(std::uint32_t x, std::uint32_t y) const { return alpha[std::size_t{y} * width + x]; }
};

}  // namespace zstrip::sim
