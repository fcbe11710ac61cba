// A renderer that draws strips of a given picture.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "picture.hpp"

namespace zstrip::panels {

struct Drawn {
  explicit operator bool() const { return true; }
};
/// Draws the strips of a picture; the buffers hold garbage beyond.
struct PictureStrips {
  const Picture& picture;
  hal::DisplayFormat format;
  std::uint16_t rows;
  Drawn draw_strip(std::uint16_t strip, std::span<std::byte> pixels) const {
    std::ranges::fill(pixels, std::byte{0x5A});
    const auto top = static_cast<std::uint16_t>(strip * rows);
    const auto height = static_cast<std::uint16_t>(std::min<int>(rows, picture.height - top));
    const std::vector<std::byte> bytes = bytes_of(picture, {0, top, picture.width, height}, format);
    std::ranges::copy(bytes, pixels.begin());
    return {};
  }
};

}  // namespace zstrip::panels
