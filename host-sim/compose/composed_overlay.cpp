// Sprites and labels of a composed scene; see composed_overlay.hpp.
#include "compose/composed_overlay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "image/decode.hpp"
#include "import/quantise.hpp"
#include "import/read_file.hpp"
#include "zstrip/overlay.hpp"

namespace zstrip::sim {
namespace {

/// Returns 0..255: the image's alpha, or its brightness if it has no alpha.
std::uint32_t coverage_of(const RgbImage& image, std::uint32_t x, std::uint32_t y) {
  if (!image.alpha.empty()) return image.alpha_at(x, y);
  const std::uint8_t* const p = image.pixel(x, y);
  return (77U * p[0] + 150U * p[1] + 29U * p[2] + 128U) >> 8;
}

/// Returns rows with this many bits a pixel, rounded to nearest.
std::vector<std::uint8_t> packed_coverage(const RgbImage& image, std::uint32_t bits) {
  const std::uint32_t row_bytes = (image.width * bits + 7) / 8, most = (1U << bits) - 1;
  std::vector<std::uint8_t> bytes(std::size_t{row_bytes} * image.height);
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const std::uint32_t level = (coverage_of(image, x, y) * most + 127) / 255, bit = x * bits;
      std::uint8_t& byte = bytes[std::size_t{y} * row_bytes + bit / 8];
      byte = static_cast<std::uint8_t>(byte | level << (8 - bits - bit % 8));
    }
  }
  return bytes;
}

class Overlays {
 public:
  Overlays(const SceneFile& file, ComposedScene& scene) : file_(file), scene_(scene) {}

  Result<std::uint16_t> image_of(const FileSprite& sprite) {
    const auto [at, is_new] = images_.try_emplace({sprite.image, sprite.coverage_bits},
                                                  static_cast<std::uint16_t>(scene_.overlay_images.size()));
    if (!is_new) return at->second;
    const std::filesystem::path path = file_.beside(sprite.image);
    const auto wrong = [&](const std::string& what) {
      return at_line(file_.path, sprite.line, fmt::format("[[sprite]]: image '{}' {}", path.string(), what));
    };
    const Result<std::vector<std::uint8_t>> bytes = read_file(path);
    if (!bytes) return wrong(bytes.failure().message);
    const Result<RgbImage> image = decode_image(*bytes);
    if (!image) return wrong(image.failure().message);
    if (std::max(image->width, image->height) > kMaxImageSize) {
      return wrong(fmt::format("has more than {} pixels on a side", kMaxImageSize));
    }
    OverlayImage& added = scene_.overlay_images.emplace_back();
    added.width = static_cast<std::uint16_t>(image->width);
    added.height = static_cast<std::uint16_t>(image->height);
    if (sprite.coverage_bits == 0) added.colours = scene_.texels.emplace_back(to_rgb565(*image));
    if (sprite.coverage_bits != 0 || !image->alpha.empty()) {
      added.coverage_bits = sprite.coverage_bits != 0 ? sprite.coverage_bits : 8;
      added.coverage = scene_.coverage.emplace_back(packed_coverage(*image, added.coverage_bits));
    }
    return at->second;
  }

  std::uint16_t font_of(FileFont font) {
    const auto [at, is_new] = fonts_.try_emplace(font, static_cast<std::uint16_t>(scene_.fonts.size()));
    if (is_new) scene_.fonts.push_back(font == FileFont::small ? kSmallFont : kLargeFont);
    return at->second;
  }

 private:
  const SceneFile& file_;
  ComposedScene& scene_;
  std::map<std::pair<std::filesystem::path, std::uint8_t>, std::uint16_t> images_;
  std::map<FileFont, std::uint16_t> fonts_;
};

}  // namespace

Result<Done> add_overlay(const SceneFile& file, ComposedScene& scene) {
  constexpr std::size_t kMaxItems = 65535;
  if (file.sprites.size() > kMaxItems) {
    return at_line(file.path, file.sprites.back().line, "[[sprite]]: the scene has more than 65,535 of them");
  }
  Overlays overlays(file, scene);
  for (const FileSprite& sprite : file.sprites) {
    const Result<std::uint16_t> image = overlays.image_of(sprite);
    if (!image) return image.failure();
    scene.sprites.push_back({sprite.x, sprite.y, *image, sprite.colour});
  }
  for (const FileLabel& label : file.labels) {
    scene.labels.push_back({.text = scene.texts.emplace_back(label.text),
                            .x = label.x,
                            .y = label.y,
                            .font = overlays.font_of(label.font),
                            .alignment = label.alignment,
                            .colour = label.colour,
                            .background = label.background});
  }
  if (!scene.sprites.empty() || !scene.labels.empty()) {
    scene.overlay = Overlay{scene.overlay_images, scene.fonts, scene.sprites, scene.labels};
  }
  return Done{};
}

}  // namespace zstrip::sim
