// Turns the renderer's pixels into picture files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "image/rgb_image.hpp"
#include "result.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

enum class ImageType : std::uint8_t {
  png,   ///< 8-bit RGB; gray4 and mono as grey of 4 and 1 bits
  apng,  ///< several of them, played; a single picture is encoded as png
  jpeg,  ///< of quality 90, colours as fine as brightness; gray4 and mono as grey
  ppm,   ///< binary PPM; gray4 and mono as binary PGM
  raw,   ///< the bytes of the strips as they are
};

/// With the dot: ".png", ".apng", ".jpg", ".ppm" or ".pgm", ".raw".
const char* file_extension(ImageType type, PixelFormat format);

/// `pixels` are all rows of the view, bytes_per_row each. Fails only when the library does (memory).
Result<std::vector<std::uint8_t>> encode(ImageType type, const View& view, std::span<const std::byte> pixels);

/// A picture of 8 bits a channel; raw is xrgb8888.
Result<std::vector<std::uint8_t>> encode(ImageType type, const RgbImage& image);

}  // namespace zstrip::sim
