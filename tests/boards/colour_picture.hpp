// Pictures of 8 bits a channel: read from a screenshot, compared with words.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace zstrip::boards {

struct ColourPicture {
  int width = 0;
  int height = 0;
  std::vector<std::array<std::uint8_t, 3>> pixels;  ///< red, green, blue, row by row

  const std::array<std::uint8_t, 3>& at(int x, int y) const { return pixels[static_cast<std::size_t>(y * width + x)]; }
  friend bool operator==(const ColourPicture&, const ColourPicture&) = default;
};

/// Reads a binary PPM of 8 bits a channel. Anything else throws std::runtime_error.
ColourPicture read_ppm(const std::filesystem::path& file);

/// What fills the low bits of a channel of 5 or 6 bits that becomes one of 8.
enum class LowBits : std::uint8_t { zeros, repeated };

/// From RGB565; `pixels` must be width * height.
ColourPicture widened(const std::vector<std::uint16_t>& pixels, int width, int height, LowBits low_bits);

/// Empty if they are equal; else how many pixels differ, and the first of them.
std::string difference(const ColourPicture& expected, const ColourPicture& actual);

}  // namespace zstrip::boards
