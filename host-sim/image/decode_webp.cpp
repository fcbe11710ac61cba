// Reads WebP (libwebp).
#include <webp/decode.h>

#include <algorithm>
#include <memory>
#include <string_view>

#include "image/decode.hpp"
#include "image/decoders.hpp"

namespace zstrip::sim {

bool is_webp(std::span<const std::uint8_t> file) {
  constexpr std::string_view kRiff = "RIFF", kWebp = "WEBP";
  return file.size() >= 12 && std::equal(kRiff.begin(), kRiff.end(), file.begin()) &&
         std::equal(kWebp.begin(), kWebp.end(), file.begin() + 8);
}

Result<RgbImage> decode_webp(std::span<const std::uint8_t> file) {
  WebPBitstreamFeatures features{};
  if (WebPGetFeatures(file.data(), file.size(), &features) != VP8_STATUS_OK) {
    return damaged_picture("WebP", "its header is damaged");
  }
  if (features.has_animation != 0) return damaged_picture("WebP", "it is an animation");
  if (features.width < 1 || features.height < 1) return damaged_picture("WebP", "it has no pixels");
  const auto columns = static_cast<std::uint32_t>(features.width), rows = static_cast<std::uint32_t>(features.height);
  if (const Result<Done> done = check_image_size(columns, rows); !done) return done.failure();
  int width = 0, height = 0;
  const std::unique_ptr<std::uint8_t, decltype(&WebPFree)> pixels(
      WebPDecodeRGBA(file.data(), file.size(), &width, &height), &WebPFree);
  if (!pixels || width != features.width || height != features.height) {
    return damaged_picture("WebP", "it is cut off or damaged");
  }
  return split_alpha(columns, rows, {pixels.get(), std::size_t{4} * columns * rows});
}

}  // namespace zstrip::sim
