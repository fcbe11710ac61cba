// Materials with a separate texture for emission.
#include "import/emission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "image/resample.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

constexpr std::array<std::uint8_t, 3> kNoLight{}, kAllLight{255, 255, 255};

/// Returns the base colour, times `base` if there is one, plus the emission's texels times its colour.
RgbImage sum_of(const SourceMaterial& material, const RgbImage* base, const RgbImage& emission) {
  const auto side = [](std::uint32_t a, std::uint32_t b) { return std::min(std::max(a, b), kMaxTextureSide); };
  RgbImage sum{side(emission.width, base == nullptr ? 1 : base->width),
               side(emission.height, base == nullptr ? 1 : base->height),
               {}};
  sum.rgb.reserve(std::size_t{3} * sum.width * sum.height);
  const auto pixel_of = [&sum](const RgbImage& image, std::uint32_t x, std::uint32_t y) {
    const auto at = [](std::uint32_t i, std::uint32_t from, std::uint32_t to) {
      return static_cast<std::uint32_t>(std::uint64_t{i} * to / from);
    };
    return std::pair{at(x, sum.width, image.width), at(y, sum.height, image.height)};
  };
  for (std::uint32_t y = 0; y < sum.height; ++y) {
    for (std::uint32_t x = 0; x < sum.width; ++x) {
      const auto [u, v] = pixel_of(emission, x, y);
      const auto [s, t] = base == nullptr ? std::pair{0U, 0U} : pixel_of(*base, x, y);
      for (std::size_t c = 0; c < 3; ++c) {
        const int lit = base == nullptr ? 255 : int{base->pixel(s, t)[c]};
        const int value = lit * material.colour[c] + emission.pixel(u, v)[c] * material.emissive[c];
        sum.rgb.push_back(static_cast<std::uint8_t>(std::min((value + 127) / 255, 255)));
      }
      if (base != nullptr && !base->alpha.empty()) sum.alpha.push_back(base->alpha_at(s, t));
    }
  }
  return sum;
}

}  // namespace

void show_emission(SourceModel& model) {
  for (SourceMaterial& material : model.materials) {
    const std::uint32_t emission = std::exchange(material.emissive_texture, kNoSourceTexture);
    if (emission == kNoSourceTexture || emission == material.texture || !material.lit) continue;
    const bool textured = material.texture != kNoSourceTexture;
    if (material.colour == kNoLight && !textured) {
      material.texture = emission;
      continue;
    }
    RgbImage sum = sum_of(material, textured ? &model.textures[material.texture] : nullptr, model.textures[emission]);
    material.texture = static_cast<std::uint32_t>(model.textures.size());
    model.textures.push_back(std::move(sum));
    model.texture_names.push_back(model.texture_names[emission]);
    material.colour = kAllLight;
    material.emissive = kNoLight;
    model.warnings.push_back(
        fmt::format("material '{}' drawn with its emission lit like the rest of it: it has a texture of its own",
                    printable(material.name)));
  }
}

}  // namespace zstrip::sim
