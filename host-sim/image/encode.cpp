// Converts the renderer's pixels to picture files.
#include "image/encode.hpp"

#include <fmt/format.h>
#include <spng.h>

#include <cstdlib>
#include <memory>
#include <string>

#include "image/jpeg_writer.hpp"
#include "image/to_rgb.hpp"

namespace zstrip::sim {
namespace {

std::vector<std::uint8_t> bytes_of(std::span<const std::byte> pixels) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(pixels.data());
  return {first, first + pixels.size()};
}

Result<std::vector<std::uint8_t>> encode_png(const View& view, std::span<const std::byte> pixels) {
  spng_ihdr header{};
  header.width = view.width;
  header.height = view.height;
  header.color_type = is_grey(view.format) ? SPNG_COLOR_TYPE_GRAYSCALE : SPNG_COLOR_TYPE_TRUECOLOR;
  header.bit_depth = view.format == PixelFormat::gray4 ? 4 : view.format == PixelFormat::mono ? 1 : 8;
  // PNG packs grey pixels of 4 and 1 bits as gray4 and mono do.
  const std::vector<std::uint8_t> content = is_grey(view.format) ? bytes_of(pixels) : rgb_image_of(view, pixels).rgb;

  const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> png(spng_ctx_new(SPNG_CTX_ENCODER), &spng_ctx_free);
  if (!png) return Failure{ExitStatus::environment, "no memory to write a PNG"};
  int error = spng_set_option(png.get(), SPNG_ENCODE_TO_BUFFER, 1);
  if (error == 0) error = spng_set_ihdr(png.get(), &header);
  if (error == 0)
    error = spng_encode_image(png.get(), content.data(), content.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
  std::size_t bytes = 0;
  std::unique_ptr<void, decltype(&std::free)> file(nullptr, &std::free);
  if (error == 0) file.reset(spng_get_png_buffer(png.get(), &bytes, &error));
  if (error != 0) return Failure{ExitStatus::internal, fmt::format("PNG writer: {}", spng_strerror(error))};
  const auto* first = static_cast<const std::uint8_t*>(file.get());
  return std::vector<std::uint8_t>(first, first + bytes);
}

Result<std::vector<std::uint8_t>> encode_jpeg(const View& view, std::span<const std::byte> pixels) {
  const bool grey = is_grey(view.format);
  return write_jpeg(grey ? grey_pixels_of(view, pixels) : rgb_image_of(view, pixels).rgb, view.width, view.height);
}

std::vector<std::uint8_t> encode_ppm(const View& view, std::span<const std::byte> pixels) {
  const std::string header = fmt::format("P{}\n{} {}\n255\n", is_grey(view.format) ? 5 : 6, view.width, view.height);
  const std::vector<std::uint8_t> content =
      is_grey(view.format) ? grey_pixels_of(view, pixels) : rgb_image_of(view, pixels).rgb;
  std::vector<std::uint8_t> file(header.begin(), header.end());
  file.insert(file.end(), content.begin(), content.end());
  return file;
}

}  // namespace

const char* file_extension(ImageType type, PixelFormat format) {
  switch (type) {
    case ImageType::png: return ".png";
    case ImageType::apng: return ".apng";
    case ImageType::jpeg: return ".jpg";
    case ImageType::ppm: return is_grey(format) ? ".pgm" : ".ppm";
    case ImageType::raw: return ".raw";
  }
  return "";
}

Result<std::vector<std::uint8_t>> encode(ImageType type, const View& view, std::span<const std::byte> pixels) {
  switch (type) {
    case ImageType::png:
    case ImageType::apng: return encode_png(view, pixels);
    case ImageType::jpeg: return encode_jpeg(view, pixels);
    case ImageType::ppm: return encode_ppm(view, pixels);
    case ImageType::raw: return bytes_of(pixels);
  }
  return Failure{ExitStatus::internal, "unknown picture type"};
}

Result<std::vector<std::uint8_t>> encode(ImageType type, const RgbImage& image) {
  std::vector<std::byte> pixels;
  pixels.reserve(image.rgb.size() / 3 * 4);
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    for (const std::size_t channel : {2U, 1U, 0U}) pixels.push_back(std::byte{image.rgb[i + channel]});
    pixels.push_back(std::byte{0});
  }
  const View view{static_cast<std::uint16_t>(image.width), static_cast<std::uint16_t>(image.height),
                  PixelFormat::xrgb8888};
  return encode(type, view, pixels);
}

}  // namespace zstrip::sim
