// Pictures of random pixels in the formats of panels, and what is to be seen of them on the glass: turned and mirrored
// as a picture, not by way of addresses.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "image/rgb_image.hpp"
#include "zstrip_hal/display.hpp"
#include "zstrip_hal/orientation.hpp"

namespace zstrip::panels {

struct Picture {
  std::uint16_t width = 0, height = 0;
  std::vector<std::array<std::uint8_t, 3>> pixels;  ///< as they are seen, 8 bits a channel

  std::array<std::uint8_t, 3>& at(unsigned x, unsigned y) { return pixels[std::size_t{y} * width + x]; }
  const std::array<std::uint8_t, 3>& at(unsigned x, unsigned y) const { return pixels[std::size_t{y} * width + x]; }
};

Picture black(std::uint16_t width, std::uint16_t height);
/// Of the colours that `format` has.
Picture noise(std::uint16_t width, std::uint16_t height, hal::DisplayFormat format, std::mt19937& random);
/// Rows of a rectangle as a display takes them.
std::vector<std::byte> bytes_of(const Picture& picture, const hal::Area& area, hal::DisplayFormat format);
/// `from`'s rectangle into `to`, which has its size.
void copy(const Picture& from, const hal::Area& area, Picture& to);
/// As it lies on the upright glass.
Picture on_glass(const Picture& picture, const hal::Orientation& orientation);
Picture picture_of(const sim::RgbImage& image);

/// The first pixel that differs, in words; empty if there is none.
std::string difference(const Picture& seen, const Picture& expected);

}  // namespace zstrip::panels
