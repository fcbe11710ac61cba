// Resamples a picture to sides that a texture can have.
#include "image/resample.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace zstrip::sim {
namespace {

/// The position of texel `index` of `to` between the texels of `from`: two neighbours and the weight of the second.
struct Sample {
  std::uint32_t first, second;
  double share;
};
Sample sample(std::uint32_t index, std::uint32_t to, std::uint32_t from, bool nearest) {
  const double centre = (index + 0.5) * from / to;
  if (nearest) return {static_cast<std::uint32_t>(centre), 0, 0};
  const double position = centre - 0.5;
  const double below = std::floor(position);
  const auto first = static_cast<std::uint32_t>(static_cast<std::int64_t>(below) + from) % from;
  return {first, (first + 1) % from, position - below};
}

}  // namespace

RgbImage halve(const RgbImage& from, bool halve_x, bool halve_y) {
  RgbImage to;
  to.width = halve_x ? (from.width + 1) / 2 : from.width;
  to.height = halve_y ? (from.height + 1) / 2 : from.height;
  to.rgb.reserve(3 * std::size_t{to.width} * to.height);
  for (std::uint32_t y = 0; y < to.height; ++y) {
    const std::uint32_t top = halve_y ? 2 * y : y;
    const std::uint32_t bottom = halve_y ? std::min(top + 1, from.height - 1) : y;
    for (std::uint32_t x = 0; x < to.width; ++x) {
      const std::uint32_t left = halve_x ? 2 * x : x;
      const std::uint32_t right = halve_x ? std::min(left + 1, from.width - 1) : x;
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const int sum = from.pixel(left, top)[channel] + from.pixel(right, top)[channel] +
                        from.pixel(left, bottom)[channel] + from.pixel(right, bottom)[channel];
        to.rgb.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
      }
      if (from.alpha.empty()) continue;
      const int sum = from.alpha_at(left, top) + from.alpha_at(right, top) + from.alpha_at(left, bottom) +
                      from.alpha_at(right, bottom);
      to.alpha.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
    }
  }
  return to;
}

RgbImage resample_to_power_of_two(RgbImage image) {
  while (image.width > kMaxTextureSide || image.height > kMaxTextureSide) {
    image = halve(image, image.width > kMaxTextureSide, image.height > kMaxTextureSide);
  }
  RgbImage scaled{std::bit_ceil(image.width), std::bit_ceil(image.height), {}};
  if (scaled.width == image.width && scaled.height == image.height) return image;
  const bool nearest = image.rgb.size() <= 3 * kMaxPaletteTexels;
  scaled.rgb.reserve(3 * std::size_t{scaled.width} * scaled.height);
  for (std::uint32_t y = 0; y < scaled.height; ++y) {
    const Sample row = sample(y, scaled.height, image.height, nearest);
    for (std::uint32_t x = 0; x < scaled.width; ++x) {
      const Sample column = sample(x, scaled.width, image.width, nearest);
      const auto mixed = [&](auto&& at) {
        const auto along = [&](std::uint32_t source_row) {
          return at(column.first, source_row) * (1 - column.share) + at(column.second, source_row) * column.share;
        };
        const double value = along(row.first) * (1 - row.share) + along(row.second) * row.share;
        return static_cast<std::uint8_t>(std::lround(value));
      };
      for (std::size_t channel = 0; channel < 3; ++channel) {
        scaled.rgb.push_back(mixed([&](std::uint32_t u, std::uint32_t v) { return image.pixel(u, v)[channel]; }));
      }
      if (image.alpha.empty()) continue;
      scaled.alpha.push_back(mixed([&](std::uint32_t u, std::uint32_t v) { return image.alpha_at(u, v); }));
    }
  }
  return scaled;
}

}  // namespace zstrip::sim
