// Pictures of 16 greys: read from a screenshot, compared with words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace zstrip::boards {

struct GreyPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> levels;  ///< 0..15, row by row

  std::uint8_t at(int x, int y) const { return levels[static_cast<std::size_t>(y * width + x)]; }
  friend bool operator==(const GreyPicture&, const GreyPicture&) = default;
};

/// Reads a binary PPM in which each pixel is a square of `scale` x `scale` equal ones of colour (17 level) in all
/// channels. Anything else throws std::runtime_error that says what is wrong where.
GreyPicture read_scaled_ppm(const std::filesystem::path& file, int scale);

/// From bytes of two pixels each, the left one in the high nibble, as rows of (width + 1) / 2 bytes.
GreyPicture unpack_gray4(const std::vector<std::byte>& bytes, int width, int height);

/// Empty if they are equal; else how many pixels differ, and the first of them.
std::string difference(const GreyPicture& expected, const GreyPicture& actual);

}  // namespace zstrip::boards
