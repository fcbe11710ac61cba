// Converts the renderer's pixels to picture files.
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
  apng,  ///< several pictures as an animation; a single picture is encoded as png
  jpeg,  ///< quality 90, chroma not subsampled; gray4 and mono as grey
  ppm,   ///< binary PPM; gray4 and mono as binary PGM
  raw,   ///< the bytes of the strips, unchanged
};

/// Returns ".png", ".apng", ".jpg", ".ppm" or ".pgm", or ".raw".
const char* file_extension(ImageType type, PixelFormat format);

/// `pixels` are all rows of the view, bytes_per_row each. Fails only if the library does (memory).
Result<std::vector<std::uint8_t>> encode(ImageType type, const View& view, std::span<const std::byte> pixels);

/// Encodes a picture of 8 bits a channel; raw is xrgb8888.
Result<std::vector<std::uint8_t>> encode(ImageType type, const RgbImage& image);

}  // namespace zstrip::sim
