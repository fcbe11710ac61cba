// Reads BMP and TGA (stb_image). The caller has checked the first bytes, so that no other format of stb_image is read.
#include <stb_image.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

#include "image/decode.hpp"
#include "image/decoders.hpp"

namespace zstrip::sim {
namespace {

/// Returns the end of the pixels in a complete TGA file.
std::uint64_t end_of_targa(std::span<const std::uint8_t> file, std::uint64_t pixels) {
  const std::uint64_t bytes_of_pixel = (file[16] + 7U) / 8;
  const std::uint64_t colours = file[1] == 0 ? 0 : file[5] | static_cast<std::uint64_t>(file[6]) << 8;
  std::uint64_t at = 18U + file[0] + colours * ((file[7] + 7U) / 8);
  if (file[2] <= 8) return at + pixels * bytes_of_pixel;
  // Each run is a length, then one pixel or as many pixels.
  while (pixels != 0 && at < file.size()) {
    const std::uint64_t length = (file[at] & 0x7FU) + 1;
    at += 1 + ((file[at] & 0x80) != 0 ? 1 : length) * bytes_of_pixel;
    pixels -= std::min(pixels, length);
  }
  return pixels == 0 ? at : file.size() + 1;
}

/// Returns the least size of a complete file: stb_image reads beyond the end of a truncated one.
std::uint64_t least_bytes(std::span<const std::uint8_t> file, std::uint64_t columns, std::uint64_t rows) {
  if (!is_bitmap(file)) return end_of_targa(file, columns * rows);
  const auto word = [&](std::size_t at) { return file[at] | static_cast<std::uint32_t>(file[at + 1]) << 8; };
  const bool is_old = word(14) == 12;  // header of OS/2
  const std::uint64_t bits = file.size() < 30 || is_old ? word(24) : word(28);
  return (word(10) | static_cast<std::uint64_t>(word(12)) << 16) + (columns * bits + 31) / 32 * 4 * rows;
}

}  // namespace

bool is_bitmap(std::span<const std::uint8_t> file) { return file.size() >= 26 && file[0] == 'B' && file[1] == 'M'; }

bool is_targa(std::span<const std::uint8_t> file) {
  constexpr std::array<std::uint8_t, 6> kTypes{1, 2, 3, 9, 10, 11};  // palette, colour, grey; the same in runs
  constexpr std::array<std::uint8_t, 5> kBits{8, 15, 16, 24, 32};
  return file.size() >= 18 && file[1] <= 1 && std::ranges::find(kTypes, file[2]) != kTypes.end() &&
         std::ranges::find(kBits, file[16]) != kBits.end();
}

Result<RgbImage> decode_bitmap_or_targa(std::span<const std::uint8_t> file, const char* kind) {
  int width = 0, height = 0, channels = 0;
  const bool fits = file.size() <= std::size_t{std::numeric_limits<int>::max()};
  const int size = fits ? static_cast<int>(file.size()) : 0;
  if (stbi_info_from_memory(file.data(), size, &width, &height, &channels) == 0) {
    return damaged_picture(kind, "its header is damaged");
  }
  if (height < 0 && height > std::numeric_limits<int>::min()) height = -height;  // a BMP whose first row is the top one
  if (width < 1 || height < 1) return damaged_picture(kind, "it has no pixels");
  const auto columns = static_cast<std::uint32_t>(width), rows = static_cast<std::uint32_t>(height);
  if (const Result<Done> done = check_image_size(columns, rows); !done) return done.failure();
  if (file.size() < least_bytes(file, columns, rows)) return damaged_picture(kind, "it is cut off");
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(file.data(), size, &width, &height, &channels, 4), &stbi_image_free);
  if (!pixels) return damaged_picture(kind, "it is damaged, or of a rare kind that is not read");
  return split_alpha(columns, rows, {pixels.get(), std::size_t{4} * columns * rows});
}

}  // namespace zstrip::sim
