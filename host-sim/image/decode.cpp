// Reads pictures, distinguished by their first bytes; this file reads PNG (libspng) and JPEG (libjpeg-turbo).
#include "image/decode.hpp"

#include <fmt/format.h>
#include <spng.h>
#include <turbojpeg.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "image/decoders.hpp"
#include "text/number.hpp"

namespace zstrip::sim {
namespace {

constexpr std::array<std::uint8_t, 8> kPngSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::array<std::uint8_t, 3> kJpegSignature{0xFF, 0xD8, 0xFF};

/// Formats of pictures that are not read, by bytes at a place near their begin.
struct OtherFormat {
  std::size_t at;
  std::string_view bytes;
  const char* name;
};
constexpr std::array<OtherFormat, 10> kOtherFormats{{{0, "\xABKTX 20\xBB", "KTX 2"},
                                                     {0, "\xABKTX 11\xBB", "KTX"},
                                                     {0, "DDS ", "DDS"},
                                                     {0, "GIF8", "GIF"},
                                                     {0, {"II*\0", 4}, "TIFF"},
                                                     {0, {"MM\0*", 4}, "TIFF"},
                                                     {0, "8BPS", "Photoshop"},
                                                     {0, "v/1\x01", "OpenEXR"},
                                                     {0, "#?RADIANCE", "Radiance HDR"},
                                                     {4, "ftypavif", "AVIF"}}};

/// Limit of the format.
constexpr std::uint32_t kMaxSideOfPng = 0x7FFFFFFF;

bool starts_with(std::span<const std::uint8_t> file, std::span<const std::uint8_t> signature) {
  return file.size() >= signature.size() && std::equal(signature.begin(), signature.end(), file.begin());
}

/// True if the file has transparent pixels.
bool has_alpha(spng_ctx& png, const spng_ihdr& header) {
  spng_trns key{};
  return header.color_type == SPNG_COLOR_TYPE_GRAYSCALE_ALPHA || header.color_type == SPNG_COLOR_TYPE_TRUECOLOR_ALPHA ||
         spng_get_trns(&png, &key) == 0;
}

Result<RgbImage> decode_png(std::span<const std::uint8_t> file) {
  const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> png(spng_ctx_new(0), &spng_ctx_free);
  if (!png) return damaged_picture("PNG", "no memory");
  spng_set_image_limits(png.get(), kMaxSideOfPng, kMaxSideOfPng);
  spng_ihdr header{};
  std::size_t bytes = 0;
  int error = spng_set_png_buffer(png.get(), file.data(), file.size());
  if (error == 0) error = spng_get_ihdr(png.get(), &header);
  if (error == 0) {
    if (const Result<Done> done = check_image_size(header.width, header.height); !done) return done.failure();
  }
  const bool alpha = error == 0 && has_alpha(*png, header);
  const spng_format format = alpha ? SPNG_FMT_RGBA8 : SPNG_FMT_RGB8;
  if (error == 0) error = spng_decoded_image_size(png.get(), format, &bytes);
  if (error != 0) return damaged_picture("PNG", spng_strerror(error));
  std::vector<std::uint8_t> pixels(bytes);
  error = spng_decode_image(png.get(), pixels.data(), bytes, format, alpha ? SPNG_DECODE_TRNS : 0);
  if (error != 0) return damaged_picture("PNG", spng_strerror(error));
  if (alpha) return split_alpha(header.width, header.height, pixels);
  return RgbImage{header.width, header.height, std::move(pixels)};
}

/// True if a segment of Adobe's stands before the pixels; its inks are stored inverted.
bool has_mark_of_adobe(std::span<const std::uint8_t> file) {
  constexpr std::uint8_t kAdobe = 0xEE, kScan = 0xDA;
  constexpr std::array<std::uint8_t, 5> kName{'A', 'd', 'o', 'b', 'e'};
  std::size_t at = 2;
  while (at + 4 <= file.size() && file[at] == 0xFF && file[at + 1] != kScan) {
    if (file[at + 1] == kAdobe && starts_with(file.subspan(at + 4), kName)) return true;
    at += 2 + (std::size_t{file[at + 2]} << 8 | file[at + 3]);
  }
  return false;
}

/// Converts cyan, magenta, yellow and black, without a profile. 255 is full ink; with `inverted` 0 is.
std::vector<std::uint8_t> rgb_of_inks(std::span<const std::uint8_t> cmyk, bool inverted) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(cmyk.size() / 4 * 3);
  const auto paper = [inverted](unsigned ink) { return inverted ? ink : 255 - ink; };
  for (std::size_t i = 0; i + 3 < cmyk.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) {
      rgb.push_back(static_cast<std::uint8_t>((paper(cmyk[i + c]) * paper(cmyk[i + 3]) + 127) / 255));
    }
  }
  return rgb;
}

Result<RgbImage> decode_jpeg(std::span<const std::uint8_t> file) {
  const std::unique_ptr<void, decltype(&tjDestroy)> jpeg(tjInitDecompress(), &tjDestroy);
  if (!jpeg) return damaged_picture("JPEG", "no memory");
  int width = 0;
  int height = 0;
  int subsampling = 0;
  int colour_space = 0;
  if (tjDecompressHeader3(jpeg.get(), file.data(), file.size(), &width, &height, &subsampling, &colour_space) != 0) {
    return damaged_picture("JPEG", tjGetErrorStr2(jpeg.get()));
  }
  if (width < 1 || height < 1) return damaged_picture("JPEG", "it has no pixels");
  RgbImage image{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), {}};
  if (const Result<Done> done = check_image_size(image.width, image.height); !done) return done.failure();
  const bool of_inks = colour_space == TJCS_CMYK || colour_space == TJCS_YCCK;
  const TJPF format = of_inks ? TJPF_CMYK : TJPF_RGB;
  std::vector<std::uint8_t> pixels((of_inks ? 4 : 3) * std::size_t{image.width} * image.height);
  if (tjDecompress2(jpeg.get(), file.data(), file.size(), pixels.data(), width, 0, height, format, 0) != 0) {
    return damaged_picture("JPEG", tjGetErrorStr2(jpeg.get()));
  }
  image.rgb = of_inks ? rgb_of_inks(pixels, has_mark_of_adobe(file)) : std::move(pixels);
  return image;
}

}  // namespace

Failure damaged_picture(const char* kind, const char* reason) {
  return {ExitStatus::input, fmt::format("is not a whole {} picture ({})", kind, reason)};
}

Result<Done> check_image_size(std::uint32_t width, std::uint32_t height) {
  if (width <= kMaxImageSide && height <= kMaxImageSide && std::uint64_t{width} * height <= kMaxImagePixels)
    return Done{};
  return Failure{ExitStatus::input,
                 fmt::format("is too large: {}x{} pixels; at most {} a side and {} together are read", width, height,
                             grouped(kMaxImageSide), grouped(kMaxImagePixels))};
}

RgbImage split_alpha(std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> rgba) {
  RgbImage image{width, height, {}};
  image.rgb.reserve(rgba.size() / 4 * 3);
  image.alpha.reserve(rgba.size() / 4);
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    image.rgb.insert(image.rgb.end(), {rgba[i], rgba[i + 1], rgba[i + 2]});
    image.alpha.push_back(rgba[i + 3]);
  }
  const bool opaque = std::all_of(image.alpha.begin(), image.alpha.end(), [](std::uint8_t a) { return a == 255; });
  if (opaque) image.alpha.clear();
  return image;
}

Result<RgbImage> decode_image(std::span<const std::uint8_t> file) {
  if (starts_with(file, kPngSignature)) return decode_png(file);
  if (starts_with(file, kJpegSignature)) return decode_jpeg(file);
  if (is_webp(file)) return decode_webp(file);
  if (is_bitmap(file)) return decode_bitmap_or_targa(file, "BMP");
  if (is_targa(file)) return decode_bitmap_or_targa(file, "TGA");
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  for (const OtherFormat& other : kOtherFormats) {
    if (text.size() < other.at || !text.substr(other.at).starts_with(other.bytes)) continue;
    return Failure{ExitStatus::input,
                   fmt::format("is a picture in {}; PNG, JPEG, WebP, BMP and TGA are read", other.name)};
  }
  return Failure{ExitStatus::input, "is not a picture in PNG, JPEG, WebP, BMP or TGA"};
}

}  // namespace zstrip::sim
