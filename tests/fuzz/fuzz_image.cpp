// Picture files: any bytes decode to a whole picture or to a failure; any pixels encode to a PNG that decodes to them.
#include <webp/decode.h>

#include <array>
#include <cstring>
#include <span>
#include <vector>

#include "image/decode.hpp"
#include "image/encode.hpp"
#include "input.hpp"
#include "require.hpp"
#include "zstrip/view.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::sim;

/// Larger pictures are allowed, but would only slow the fuzzer down.
constexpr std::uint64_t kMaxPixels = 1U << 16;

std::uint64_t big_endian(std::span<const std::uint8_t> bytes) {
  std::uint64_t value = 0;
  for (const std::uint8_t byte : bytes) value = value << 8 | byte;
  return value;
}

/// Whether the file states such a size: at its fixed place in a PNG, behind a frame marker (FF C0 to FF CF, two bytes
/// of length and one of precision) in a JPEG. BMP and TGA are no larger than their bytes allow.
bool is_large(std::span<const std::uint8_t> file) {
  if (file.size() >= 24 && file[0] == 0x89) {
    return big_endian(file.subspan(16, 4)) * big_endian(file.subspan(20, 4)) > kMaxPixels;
  }
  int width = 0, height = 0;
  if (WebPGetInfo(file.data(), file.size(), &width, &height) != 0) {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) > kMaxPixels;
  }
  for (std::size_t i = 0; i + 9 <= file.size(); ++i) {
    if (file[i] == 0xFF && file[i + 1] >= 0xC0 && file[i + 1] <= 0xCF &&
        big_endian(file.subspan(i + 5, 2)) * big_endian(file.subspan(i + 7, 2)) > kMaxPixels) {
      return true;
    }
  }
  return false;
}

void judge_decoding(std::span<const std::uint8_t> file) {
  if (is_large(file)) return;
  const auto image = decode_image(file);
  if (!image) {
    fuzz::require(image.failure().status == ExitStatus::input, "a damaged picture is the input's fault");
    fuzz::require(image.failure().message.starts_with("is "), "a failure says what the file is not: %s",
                  image.failure().message.c_str());
    return;
  }
  fuzz::require(
      image->width >= 1 && image->height >= 1 && image->width <= kMaxImageSide && image->height <= kMaxImageSide,
      "sides of 1 to kMaxImageSide");
  fuzz::require(image->rgb.size() == 3 * std::size_t{image->width} * image->height, "three bytes a pixel");
}

/// The 8-bit channels that a pixel stands for.
std::array<unsigned, 3> rgb_of(std::span<const std::byte> pixels, const View& view, std::uint32_t x, std::uint32_t y) {
  const std::byte* const row = pixels.data() + std::size_t{y} * bytes_per_row(view.width, view.format);
  const auto byte = [row](std::size_t i) { return std::to_integer<unsigned>(row[i]); };
  const auto grey = [](unsigned value) { return std::array<unsigned, 3>{value, value, value}; };
  if (view.format == PixelFormat::mono) return grey((byte(x / 8) >> (7 - x % 8)) % 2 * 255);
  if (view.format == PixelFormat::gray4) return grey(byte(x / 2) / (x % 2 == 0 ? 16 : 1) % 16 * 17);
  if (view.format == PixelFormat::xrgb8888) return {byte(4 * x + 2), byte(4 * x + 1), byte(4 * x)};
  if (view.format == PixelFormat::rgb666) {
    const auto six_bits = [&byte, x](std::size_t i) { return byte(3 * x + i) / 4 * 4 + byte(3 * x + i) / 64; };
    return {six_bits(0), six_bits(1), six_bits(2)};
  }
  if (view.format == PixelFormat::rgb444) {
    const std::size_t i = x / 2 * 3;
    if (x % 2 == 0) return {byte(i) / 16 * 17, byte(i) % 16 * 17, byte(i + 1) / 16 * 17};
    return {byte(i + 1) % 16 * 17, byte(i + 2) / 16 * 17, byte(i + 2) % 16 * 17};
  }
  const bool swapped = view.format == PixelFormat::rgb565_swapped;
  const unsigned pixel = byte(2 * x + (swapped ? 1 : 0)) + 256 * byte(2 * x + (swapped ? 0 : 1));
  const unsigned r = pixel / 2048;
  const unsigned g = pixel / 32 % 64;
  const unsigned b = pixel % 32;
  return {r * 8 + r / 4, g * 4 + g / 16, b * 8 + b / 4};
}

void judge_encoding(fuzz::Input& input) {
  const View view{static_cast<std::uint16_t>(1 + input.below(40)), static_cast<std::uint16_t>(1 + input.below(40)),
                  static_cast<PixelFormat>(input.below(7))};
  std::vector<std::byte> pixels(std::size_t{view.height} * bytes_per_row(view.width, view.format));
  for (std::byte& b : pixels) b = static_cast<std::byte>(input.any<std::uint8_t>());

  const auto png = encode(ImageType::png, view, pixels);
  fuzz::require(static_cast<bool>(png), "every picture becomes a PNG");
  const auto image = decode_image(*png);
  fuzz::require(image && image->width == view.width && image->height == view.height, "a PNG keeps its size");
  for (std::uint32_t y = 0; y < view.height; ++y) {
    for (std::uint32_t x = 0; x < view.width; ++x) {
      const std::array<unsigned, 3> expected = rgb_of(pixels, view, x, y);
      const std::uint8_t* const got = image->pixel(x, y);
      fuzz::require(got[0] == expected[0] && got[1] == expected[1] && got[2] == expected[2],
                    "a PNG keeps its pixels: %u,%u", x, y);
    }
  }
  const bool grey = view.format == PixelFormat::gray4 || view.format == PixelFormat::mono;
  const auto ppm = encode(ImageType::ppm, view, pixels);
  fuzz::require(ppm && ppm->size() >= image->rgb.size() / (grey ? 3 : 1), "every picture becomes a PPM");
  // Its pixels are what stands behind the header.
  const std::uint8_t* const content = ppm->data() + (ppm->size() - image->rgb.size() / (grey ? 3 : 1));
  for (std::size_t i = 0; i < image->rgb.size(); i += grey ? 3 : 1) {
    fuzz::require(content[grey ? i / 3 : i] == image->rgb[i], "PPM and PNG agree: byte %zu", i);
  }
  const auto raw = encode(ImageType::raw, view, pixels);
  fuzz::require(raw && raw->size() == pixels.size() && std::memcmp(raw->data(), pixels.data(), pixels.size()) == 0,
                "raw is the pixels as they are");
}

}  // namespace

/// The bytes as a file, and as pixels.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span file(data, size);
  judge_decoding(file);
  fuzz::Input input(data, size);
  judge_encoding(input);
  return 0;
}
