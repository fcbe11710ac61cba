// Turns the renderer's pixels into picture files.
#include "image/encode.hpp"

#include <fmt/format.h>
#include <spng.h>

#include <cstdlib>
#include <memory>
#include <string>

namespace zstrip::sim {
namespace {

bool is_grey(PixelFormat format) { return format == PixelFormat::gray4 || format == PixelFormat::mono; }

/// Channels of 5 and 6 bits are widened by repeating their upper bits: 31 and 63 become 255.
std::vector<std::uint8_t> to_rgb8(const View& view, std::span<const std::byte> pixels) {
  const std::size_t low = view.format == PixelFormat::rgb565 ? 0 : 1;
  std::vector<std::uint8_t> rgb;
  rgb.reserve(pixels.size() / 2 * 3);
  for (std::size_t i = 0; i < pixels.size(); i += 2) {
    const unsigned pixel = std::to_integer<unsigned>(pixels[i + low]) | std::to_integer<unsigned>(pixels[i + 1 - low])
                                                                            << 8;
    const unsigned red = pixel >> 11;
    const unsigned green = pixel >> 5 & 63;
    const unsigned blue = pixel & 31;
    rgb.push_back(static_cast<std::uint8_t>(red << 3 | red >> 2));
    rgb.push_back(static_cast<std::uint8_t>(green << 2 | green >> 4));
    rgb.push_back(static_cast<std::uint8_t>(blue << 3 | blue >> 2));
  }
  return rgb;
}

std::vector<std::uint8_t> to_grey8(const View& view, std::span<const std::byte> pixels) {
  const std::size_t row_bytes = bytes_per_row(view.width, view.format);
  const unsigned bits = view.format == PixelFormat::gray4 ? 4 : 1;
  const unsigned white = (1U << bits) - 1;
  std::vector<std::uint8_t> grey;
  grey.reserve(std::size_t{view.width} * view.height);
  for (std::size_t y = 0; y < view.height; ++y) {
    for (unsigned x = 0; x < view.width; ++x) {
      const unsigned byte = std::to_integer<unsigned>(pixels[y * row_bytes + x * bits / 8]);
      const unsigned shift = 8 - bits - x * bits % 8;  // the left pixel is in the high bits
      grey.push_back(static_cast<std::uint8_t>((byte >> shift & white) * 255 / white));
    }
  }
  return grey;
}

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
  const std::vector<std::uint8_t> content = is_grey(view.format) ? bytes_of(pixels) : to_rgb8(view, pixels);

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

std::vector<std::uint8_t> encode_ppm(const View& view, std::span<const std::byte> pixels) {
  const std::string header = fmt::format("P{}\n{} {}\n255\n", is_grey(view.format) ? 5 : 6, view.width, view.height);
  const std::vector<std::uint8_t> content = is_grey(view.format) ? to_grey8(view, pixels) : to_rgb8(view, pixels);
  std::vector<std::uint8_t> file(header.begin(), header.end());
  file.insert(file.end(), content.begin(), content.end());
  return file;
}

}  // namespace

const char* file_extension(ImageType type, PixelFormat format) {
  switch (type) {
    case ImageType::png: return ".png";
    case ImageType::ppm: return is_grey(format) ? ".pgm" : ".ppm";
    case ImageType::raw: return ".raw";
  }
  return "";
}

Result<std::vector<std::uint8_t>> encode(ImageType type, const View& view, std::span<const std::byte> pixels) {
  switch (type) {
    case ImageType::png: return encode_png(view, pixels);
    case ImageType::ppm: return encode_ppm(view, pixels);
    case ImageType::raw: return bytes_of(pixels);
  }
  return Failure{ExitStatus::internal, "unknown picture type"};
}

}  // namespace zstrip::sim
