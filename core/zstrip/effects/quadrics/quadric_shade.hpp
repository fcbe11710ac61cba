// The colour of a quadric's pixel: its normal with the scene's lights, and its texture.
#pragma once

#include <bit>
#include <cstdint>

#include "zstrip/base/arctangent.hpp"
#include "zstrip/base/pixel_root.hpp"
#include "zstrip/effects/fog/fogged_colour.hpp"
#include "zstrip/effects/quadrics/quadric.hpp"
#include "zstrip/geometry/light.hpp"
#include "zstrip/pixels/colour.hpp"
#include "zstrip/pixels/target.hpp"
#include "zstrip/raster/fragment.hpp"

namespace zstrip::detail {

struct QuadricNormal {
  std::int32_t x, y, z;
};

/// Returns a direction of any length, below 2^14 in each component. `root` is shifted by
/// CompiledQuadric::direction_shift.
inline QuadricNormal direction_at(const DirectionPlane& plane, std::int32_t columns, std::int32_t rows,
                                  std::int32_t root) {
  const auto component = [&](int i) {
    return (plane.start[i] + plane.step_x[i] * columns + plane.step_y[i] * rows + plane.root_part[i] * root) >> 15;
  };
  return {component(0), component(1), component(2)};
}

/// Returns the direction with length one, 2.12; components are below 2^14.
inline QuadricNormal unit(const QuadricNormal& d) {
  const auto square = static_cast<std::uint32_t>(d.x * d.x + d.y * d.y + d.z * d.z);  // below 2^30
  if (square == 0) return d;
  const int zeros = std::countl_zero(square) & ~1;  // 2 .. 30
  const auto inverse = static_cast<std::int32_t>(refined_inverse(normalised_root(square << zeros)));
  const int shift = 31 - 12 - zeros / 2;
  return {(d.x * inverse) >> shift, (d.y * inverse) >> shift, (d.z * inverse) >> shift};
}

/// The cosine is 5.27; shifted, it is 0..255 if both vectors are unit vectors.
inline Colour lit_colour(const CompiledQuadric& quadric, const QuadricNormal& normal) {
  return lit_by<19, 7>(quadric, normal);
}

/// Maps longitude to u and latitude to v: the middle of the texture faces the sphere's +z, its top is the pole +y.
inline std::uint16_t texel_at(const TextureView& texture, const QuadricNormal& d) {
  const auto u = static_cast<std::uint32_t>(arctangent(d.x, d.z) + kFullTurn / 2) & 0xFFFFU;  // 0.16
  const std::uint64_t square = static_cast<std::uint32_t>(d.x * d.x + d.z * d.z);
  std::int32_t from_axis = 0;
  if (square != 0) {
    const WideRoot r = wide_root(square << 32);  // the root of the square itself has half_shift 0 .. 15
    from_axis = static_cast<std::int32_t>(r.root >> (8 + r.half_shift));
  }
  const auto v = static_cast<std::uint32_t>(arctangent(from_axis, d.y)) * 2;  // 0.16, 0 .. 1.0
  const std::uint32_t column = (u << texture.log2_width) >> 16;
  const std::uint32_t last_row = (1U << texture.log2_height) - 1;
  const std::uint32_t row = (v << texture.log2_height) >> 16;
  return texture.texels[((row < last_row ? row : last_row) << texture.log2_width) + column];
}

/// The colours of one quadric's pixels; the effects determine which members are used.
template <Effects effects>
struct QuadricShade {
  const CompiledQuadric& quadric;
  TextureView texture;
  const FogCurve* fog = nullptr;  ///< only with effect::fog
  std::int64_t depth_offset = 0;  ///< the offset of distance_at
  [[no_unique_address]] MemberIf<effects, effect::dithered_colours, DitherAnchor> dither{};

  /// Returns the colour of a pixel. `root` is negative on the far side. `depth` in 1/2^32 of all codes.
  std::uint16_t operator()(std::int32_t columns, std::int32_t rows, std::int32_t root, std::uint32_t depth) const {
    if constexpr (effects.has(effect::dithered_colours)) {
      if (dither.dithered) return dithered_colour(columns, rows, root, depth);
    }
    const std::uint16_t colour = surface_colour(columns, rows, root);
    if constexpr (effects.has(effect::fog)) {
      if (fog != nullptr) return fogged(colour, depth);
    }
    return colour;
  }

 private:
  /// Dithers once, as the last step.
  std::uint16_t dithered_colour(std::int32_t columns, std::int32_t rows, std::int32_t root, std::uint32_t depth) const {
    const std::uint32_t threshold = dither.threshold(columns, rows);
    if constexpr (effects.has(effect::fog)) {
      if (fog != nullptr) return fogged(surface_colour(columns, rows, root), depth, threshold);
    }
    return surface_colour(columns, rows, root, threshold);
  }

  template <class... Threshold>
  std::uint16_t surface_colour(std::int32_t columns, std::int32_t rows, std::int32_t root,
                               Threshold... threshold) const {
    Colour colour = quadric.base;
    if constexpr (effects.has(effect::lighting)) {
      if (quadric.lit) colour = lit_colour(quadric, unit(direction_at(quadric.normal, columns, rows, root)));
    }
    if constexpr (effects.has(effect::textures)) {
      if (quadric.textured) {
        const std::uint16_t texel = texel_at(texture, direction_at(quadric.surface, columns, rows, root));
        if (!quadric.lit) return texel;
        const auto channel = [](std::uint8_t value) { return static_cast<std::uint32_t>(value) << 16; };  // 8.16
        return modulated(texel, channel(colour.r), channel(colour.g), channel(colour.b));
      }
    }
    if constexpr (sizeof...(threshold) != 0) return dithered_rgb565(colour.r, colour.g, colour.b, threshold...);
    return rgb565(colour);
  }

  template <class... Threshold>
  std::uint16_t fogged(std::uint16_t pixel, std::uint32_t depth, Threshold... threshold) const {
    return fogged_colour<effects.has(effect::orthographic)>(*fog, expanded(pixel), depth, depth_offset, threshold...);
  }
};

}  // namespace zstrip::detail
