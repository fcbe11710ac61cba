// Converts the renderer's pixels to 8 bits a channel; names their formats.
#include "image/to_rgb.hpp"

#include <array>

namespace zstrip::sim {
namespace {

using Rgb8 = std::array<std::uint8_t, 3>;

/// Widens a channel of `bits` bits by repeating its upper bits: the largest value becomes 255.
std::uint8_t widened(unsigned channel, unsigned bits) {
  return static_cast<std::uint8_t>(channel << (8 - bits) | channel >> (2 * bits - 8));
}

/// Returns pixel x of a row in a colour format.
Rgb8 colour_at(std::span<const std::byte> row, std::size_t x, PixelFormat format) {
  const auto byte = [row](std::size_t i) { return std::to_integer<unsigned>(row[i]); };
  const auto from_565 = [](unsigned pixel) {
    return Rgb8{widened(pixel >> 11, 5), widened(pixel >> 5 & 63, 6), widened(pixel & 31, 5)};
  };
  const auto nibble = [&byte, x](std::size_t i) {
    return byte((3 * x + i) / 2) >> ((3 * x + i) % 2 == 0 ? 4 : 0) & 15;
  };
  const std::size_t i = x * bytes_per_row(1, format);
  switch (format) {
    case PixelFormat::rgb565_swapped: return from_565(byte(i) << 8 | byte(i + 1));
    case PixelFormat::rgb666:
      return {widened(byte(i) >> 2, 6), widened(byte(i + 1) >> 2, 6), widened(byte(i + 2) >> 2, 6)};
    case PixelFormat::rgb444: return {widened(nibble(0), 4), widened(nibble(1), 4), widened(nibble(2), 4)};
    case PixelFormat::xrgb8888: return {widened(byte(i + 2), 8), widened(byte(i + 1), 8), widened(byte(i), 8)};
    default: return from_565(byte(i) | byte(i + 1) << 8);
  }
}

}  // namespace

bool is_grey(PixelFormat format) { return format == PixelFormat::gray4 || format == PixelFormat::mono; }

const char* name(PixelFormat format) {
  switch (format) {
    case PixelFormat::rgb565: return "rgb565";
    case PixelFormat::rgb565_swapped: return "rgb565_swapped";
    case PixelFormat::gray4: return "gray4";
    case PixelFormat::mono: return "mono";
    case PixelFormat::rgb666: return "rgb666";
    case PixelFormat::rgb444: return "rgb444";
    case PixelFormat::xrgb8888: return "xrgb8888";
  }
  return "";
}

std::vector<std::uint8_t> grey_pixels_of(const View& view, std::span<const std::byte> pixels) {
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

RgbImage rgb_image_of(const View& view, std::span<const std::byte> pixels) {
  RgbImage image{.width = view.width, .height = view.height, .rgb = {}};
  image.rgb.reserve(std::size_t{view.width} * view.height * 3);
  if (is_grey(view.format)) {
    for (const std::uint8_t grey : grey_pixels_of(view, pixels)) image.rgb.insert(image.rgb.end(), 3, grey);
    return image;
  }
  const std::size_t row_bytes = bytes_per_row(view.width, view.format);
  for (std::size_t y = 0; y < view.height; ++y) {
    for (std::size_t x = 0; x < view.width; ++x) {
      const Rgb8 colour = colour_at(pixels.subspan(y * row_bytes, row_bytes), x, view.format);
      image.rgb.insert(image.rgb.end(), colour.begin(), colour.end());
    }
  }
  return image;
}

}  // namespace zstrip::sim
