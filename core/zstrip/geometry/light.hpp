// Computes the colour of a vertex: ambient and directional light on the material, times the vertex colour.
#pragma once

#include "zstrip/effects.hpp"
#include "zstrip/geometry/instance.hpp"

namespace zstrip::detail {

/// Converts 0..255 to a factor of 0..256, so that 255 is exactly one.
constexpr std::uint32_t factor(std::uint32_t channel) { return channel + (channel >> 7); }

constexpr std::uint8_t clamped_channel(std::uint32_t sum) { return static_cast<std::uint8_t>(sum < 255 ? sum : 255); }

/// Computes ambient and directional light for a compiled instance or quadric. A right shift by `shift` converts the
/// cosine for this format of normals to an intensity of up to 8 bits; adding that intensity shifted right by `ones`
/// makes it 0..256.
template <int shift, int ones, class Lit, class Direction>
[[gnu::always_inline]] inline Colour lit_by(const Lit& lit, const Direction& normal) {
  std::uint32_t r = lit.ambient.r;
  std::uint32_t g = lit.ambient.g;
  std::uint32_t b = lit.ambient.b;
  for (int i = 0; i < lit.light_count; ++i) {
    const ObjectLight& light = lit.lights[i];
    const std::int32_t cosine = normal.x * light.x + normal.y * light.y + normal.z * light.z;
    if (cosine <= 0) continue;
    std::uint32_t intensity = static_cast<std::uint32_t>(cosine) >> shift;
    intensity += intensity >> ones;
    if (intensity > 256) intensity = 256;  // normals may be longer than one
    r += (intensity * light.r) >> 8;
    g += (intensity * light.g) >> 8;
    b += (intensity * light.b) >> 8;
  }
  return {clamped_channel(r), clamped_channel(g), clamped_channel(b), 255};
}

/// The cosine is 3.22; shifted, it is 0..253 if both vectors are unit vectors.
inline Colour lit_colour(const CompiledInstance& instance, const Normal& normal) {
  return lit_by<14, 6>(instance, normal);
}

constexpr Colour modulated(const Colour& colour, const Colour& by) {
  return {static_cast<std::uint8_t>((colour.r * factor(by.r)) >> 8),
          static_cast<std::uint8_t>((colour.g * factor(by.g)) >> 8),
          static_cast<std::uint8_t>((colour.b * factor(by.b)) >> 8), 255};
}

/// Multiplies by the vertex's own colour, after the light.
template <Effects effects>
inline Colour with_vertex_colour(const Colour& colour, const CompiledInstance& instance, const Mesh& mesh,
                                 std::uint32_t vertex) {
  if constexpr (effects.has(effect::vertex_colours)) {
    if (instance.coloured) {
      const Colour& own = mesh.colours[vertex];
      // With a white base and no light the result is the vertex colour, without a multiplication.
      return colour == Colour{255, 255, 255, 255} ? own : modulated(colour, own);
    }
  }
  return colour;
}

/// Reads `instance.lit` and `instance.coloured` only if the effect exists.
template <Effects effects>
inline Colour vertex_colour(const CompiledInstance& instance, const Mesh& mesh, std::uint32_t vertex) {
  Colour colour = instance.base;
  if constexpr (effects.has(effect::lighting)) {
    if (instance.lit) colour = lit_colour(instance, mesh.normals[vertex]);
  }
  return with_vertex_colour<effects>(colour, instance, mesh, vertex);
}

}  // namespace zstrip::detail
