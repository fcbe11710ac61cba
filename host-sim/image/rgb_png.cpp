// Encodes a picture in memory as a PNG file, with libspng.
#include "image/rgb_png.hpp"

#include <fmt/format.h>
#include <spng.h>

#include <cstdlib>
#include <memory>

namespace zstrip::sim {

Result<std::vector<std::uint8_t>> encode_rgb_png(const RgbImage& image) {
  spng_ihdr header{};
  header.width = image.width;
  header.height = image.height;
  header.color_type = SPNG_COLOR_TYPE_TRUECOLOR;
  header.bit_depth = 8;
  const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> png(spng_ctx_new(SPNG_CTX_ENCODER), &spng_ctx_free);
  if (!png) return Failure{ExitStatus::environment, "no memory to write a PNG"};
  int error = spng_set_option(png.get(), SPNG_ENCODE_TO_BUFFER, 1);
  if (error == 0) error = spng_set_ihdr(png.get(), &header);
  if (error == 0) {
    error = spng_encode_image(png.get(), image.rgb.data(), image.rgb.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
  }
  std::size_t bytes = 0;
  std::unique_ptr<void, decltype(&std::free)> file(nullptr, &std::free);
  if (error == 0) file.reset(spng_get_png_buffer(png.get(), &bytes, &error));
  if (error != 0) return Failure{ExitStatus::internal, fmt::format("PNG writer: {}", spng_strerror(error))};
  const auto* first = static_cast<const std::uint8_t*>(file.get());
  return std::vector<std::uint8_t>(first, first + bytes);
}

}  // namespace zstrip::sim
