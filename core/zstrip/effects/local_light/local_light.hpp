// Light that depends on the position of a vertex: point and spot lights, highlights (Blinn-Phong). Computed in world
// space relative to the eye, so that lights need no conversion to an instance's space.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

#include "zstrip/base/math.hpp"
#include "zstrip/base/unit_vector.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/effects/local_light/effect.hpp"
#include "zstrip/geometry/instance.hpp"
#include "zstrip/geometry/light.hpp"

namespace zstrip::detail {

/// World coordinates relative to the eye, 17.15; lights within 2^29, vertices within 5 2^28.
struct WorldPoint {
  std::int32_t x, y, z;
};

/// Returns base^exponent for 0 <= base < 2^16 (0.16), rounded in every step: at most 16 multiplications.
constexpr std::uint32_t power(std::uint32_t base, std::uint32_t exponent) {
  std::uint32_t result = 1U << 16;  // a product with the base is at most 2^32 - 2^16
  for (; exponent != 0; exponent >>= 1) {
    if ((exponent & 1) != 0) result = (result * base + (1U << 15)) >> 16;
    base = (base * base + (1U << 15) - 1) >> 16;
  }
  return result;
}

/// Returns 1 - cosine of the angle between two unit vectors, 4.28: half of the square of their difference. Near 0 it
/// has more bits than a dot product, and the errors of the vectors' lengths cancel.
constexpr std::uint32_t apart(const UnitVector& a, const UnitVector& b) {
  const auto square = [](std::int32_t c) { return static_cast<std::uint32_t>(c * c); };  // 2^30 at most
  return (square(a.x - b.x) + square(a.y - b.y) + square(a.z - b.z)) >> 1;
}

/// The amount of light that reaches a surface, 8.12: 1.0 is the light's full colour; saturates.
using Gain = std::uint32_t;
inline constexpr Gain kAllOfIt = 1U << 12, kMaxGain = 1U << 20;

struct WorldLight {
  WorldPoint position;
  UnitVector towards;       ///< 1.14, opposite to the spot's direction
  std::int32_t range;       ///< 17.15; 0: unlimited
  std::uint32_t intensity;  ///< 16.16
  std::int32_t outer;       ///< 2.28: 1 - cosine of the outer cone
  std::uint32_t cone;       ///< 2^14 / (cosine of the inner cone - cosine of the outer cone), at most 2^29; 0: a
                            ///< point light
  Colour colour;
};
static_assert(sizeof(WorldLight) == local_light::Effect::kWorldLightBytes);

/// Returns the amount of a light that arrives from `from`, the direction to it, as KHR_lights_punctual defines it.
constexpr Gain attenuation(const WorldLight& light, const DirectionAndLength& from) {
  // intensity / d^2, d = root 2^shift / 2^15.
  const std::uint32_t half = from.inverse >> 1;
  const std::uint32_t inverse_square = half * half;  // 2^58 / root^2
  // 4096 intensity / d^2 = product 2^-(32 + shift). Near a light, where the shift is negative, the product's lower
  // word has most of the bits.
  const std::uint64_t product = long_product(light.intensity, inverse_square);
  const std::int32_t shift = 2 * from.shift;
  Gain gain = 0;
  if (shift < 0) {
    gain = static_cast<Gain>(std::min<std::uint64_t>(product >> std::max<std::int32_t>(32 + shift, 0), kMaxGain));
  } else if (shift < 32) {
    gain = std::min(static_cast<std::uint32_t>(product >> 32) >> shift, kMaxGain);
  }
  if (light.range != 0) {
    const std::uint64_t distance =
        from.shift >= 0 ? std::uint64_t{from.root} << from.shift : from.root >> std::min<std::int32_t>(-from.shift, 31);
    if (distance >= static_cast<std::uint32_t>(light.range)) return 0;
    const int surplus = std::max(0, 16 - std::countl_zero(static_cast<std::uint32_t>(light.range)));
    const std::uint32_t quotient = ((static_cast<std::uint32_t>(distance) >> surplus) << 15) /
                                   (static_cast<std::uint32_t>(light.range) >> surplus);
    const std::uint32_t square = (quotient * quotient) >> 15;  // 1.15
    gain = static_cast<std::uint32_t>((std::uint64_t{gain} * (32768 - ((square * square) >> 15))) >> 15);
  }
  if (light.cone != 0) {
    const std::int32_t above = light.outer - static_cast<std::int32_t>(apart(light.towards, from.unit));  // 2.28
    if (above <= 0) return 0;
    const std::uint64_t ratio = (std::uint64_t{light.cone} * static_cast<std::uint32_t>(above)) >> 28;  // 0.14
    const auto within = static_cast<std::uint32_t>(std::min<std::uint64_t>(ratio, 1U << 14));
    gain = static_cast<std::uint32_t>((std::uint64_t{gain} * ((within * within) >> 14)) >> 14);
  }
  return gain;
}

/// Values of an instance for the frame's local light.
struct InstanceShading {
  LinearForm x, y, z;         ///< WorldPoint of a position
  std::int16_t normal[3][3];  ///< rows, 1.14: object to world, without its scale
  std::int16_t unused;
};
static_assert(sizeof(InstanceShading) == local_light::Effect::kShadingBytes);

struct FrameLights {
  WorldLight lights[kMaxPunctualLights];
  UnitVector back;  ///< 1.14: the direction to the eye of an orthographic camera
  std::uint32_t count;
};
static_assert(sizeof(FrameLights) == local_light::Effect::kFrameLightsBytes);

FrameLights frame_lights(const Scene& scene, const Camera& camera);
InstanceShading instance_shading(const Mesh& mesh, const Transform& transform, const Camera& camera);

/// The sum of light on a vertex, 0..255 a channel or more. A light adds at most 2^16; a product is below 2^28 + 2^11.
struct LightSum {
  std::uint32_t r, g, b;
  constexpr void add(const Colour& colour, Gain gain) {
    r += (gain * colour.r + 2048) >> 12;
    g += (gain * colour.g + 2048) >> 12;
    b += (gain * colour.b + 2048) >> 12;
  }
};

/// A point of a surface. Adds the light that it reflects to the eye, one light after the other. `direction` makes unit
/// vectors: direction_of, or a faster function.
template <Effects effects, auto direction>
struct LitPoint {
  WorldPoint at;
  UnitVector normal, to_eye;
  std::uint8_t shininess;
  bool shines;
  LightSum diffuse{0, 0, 0}, highlights{0, 0, 0};

  /// Adds the highlight of a light with the factor `gain`, from `towards`.
  void add_highlight(const UnitVector& towards, const Colour& colour, Gain gain) {
    if constexpr (effects.has(effect::specular)) {
      if (!shines || dot(normal, towards) <= 0) return;
      const UnitVector half = direction(towards.x + to_eye.x, towards.y + to_eye.y, towards.z + to_eye.z).unit;
      const std::uint32_t off = apart(normal, half);
      const std::uint32_t cosine =  // 0.16
          off < 1U << 28 ? std::min<std::uint32_t>(((1U << 28) - off + (1U << 11)) >> 12, 0xFFFF) : 0;
      const std::uint32_t share = power(cosine, shininess);
      highlights.add(colour, static_cast<Gain>((std::uint64_t{gain} * share) >> 16));
    }
  }
  /// Adds the highlight of a directional light, whose diffuse part does not depend on the position.
  void add_highlight(const DirectionalLight& light) {
    add_highlight({light.x >> 1, light.y >> 1, light.z >> 1}, light.colour, kAllOfIt);
  }
  [[gnu::always_inline]] void add(const WorldLight& light) {
    const DirectionAndLength from =
        direction(light.position.x - at.x, light.position.y - at.y, light.position.z - at.z);
    const std::int32_t cosine = dot(normal, from.unit) >> 14;  // 1.14
    if (cosine <= 0) return;
    const Gain gain = attenuation(light, from);
    if (gain == 0) return;
    diffuse.add(light.colour, static_cast<Gain>((std::uint64_t{gain} * static_cast<std::uint32_t>(cosine)) >> 14));
    add_highlight(from.unit, light.colour, gain);
  }

  /// Adds all local light, times the surface's colours. `lights`: the directional lights, without a shadow's light.
  [[gnu::always_inline]] void add_all_to(LightSum& total, std::span<const DirectionalLight> lights,
                                         const FrameLights& frame, const Colour& colour, const Colour& specular) {
    if constexpr (effects.has(effect::specular)) {
      for (const DirectionalLight& light : lights) add_highlight(light);
    }
    if constexpr (effects.has(effect::punctual_lights)) {
      for (std::uint32_t i = 0; i < frame.count; ++i) add(frame.lights[i]);
      total.r += (diffuse.r * factor(colour.r)) >> 8;
      total.g += (diffuse.g * factor(colour.g)) >> 8;
      total.b += (diffuse.b * factor(colour.b)) >> 8;
    }
    if constexpr (effects.has(effect::specular)) {
      total.r += (highlights.r * factor(specular.r)) >> 8;
      total.g += (highlights.g * factor(specular.g)) >> 8;
      total.b += (highlights.b * factor(specular.b)) >> 8;
    }
  }
};

template <Effects effects>
void add_local_light(LightSum& total, const CompiledInstance& instance, const Mesh& mesh, std::uint32_t vertex,
                     const Scene& scene, const FrameLights* frame, const InstanceShading* shading,
                     const Finish& finish) {
  const Normal& n = mesh.normals[vertex];
  const Position& p = mesh.positions[vertex];
  const WorldPoint at{shading->x.at(p), shading->y.at(p), shading->z.at(p)};
  const auto turned = [&](int row) {  // 1.7 times 1.14
    return (n.x * shading->normal[row][0] + n.y * shading->normal[row][1] + n.z * shading->normal[row][2]) >> 7;
  };
  const UnitVector normal = direction_of(turned(0), turned(1), turned(2)).unit;
  UnitVector to_eye = frame->back;
  bool shines = false;
  if constexpr (effects.has(effect::specular)) {
    shines = !is_black(finish.specular);
    if constexpr (!effects.has(effect::orthographic)) {
      if (shines) to_eye = direction_of(-at.x, -at.y, -at.z).unit;
    }
  }
  LitPoint<effects, direction_of> point{at, normal, to_eye, finish.shininess, shines};
  point.add_all_to(total, scene.lights.first(instance.light_count), *frame, instance.base, finish.specular);
}

/// Returns the colour of a lit vertex with all these effects, before the vertex colour. `frame` and `shading` are null
/// if the scene has no local light.
template <Effects effects>
Colour locally_lit_colour(const CompiledInstance& instance, const Mesh& mesh, std::uint32_t vertex, const Scene& scene,
                          [[maybe_unused]] const FrameLights* frame, [[maybe_unused]] const InstanceShading* shading,
                          const Finish& finish) {
  const Colour plain = lit_colour(instance, mesh.normals[vertex]);
  LightSum total{plain.r, plain.g, plain.b};
  if constexpr (effects.any(effect::local_light)) {
    if (shading != nullptr) {
      add_local_light<effects>(total, instance, mesh, vertex, scene, frame, shading, finish);
    }
  }
  if constexpr (effects.has(effect::emissive)) {
    total.r += finish.emissive.r;
    total.g += finish.emissive.g;
    total.b += finish.emissive.b;
  }
  return {clamped_channel(total.r), clamped_channel(total.g), clamped_channel(total.b), 255};
}

}  // namespace zstrip::detail
