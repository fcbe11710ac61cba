// Light at a pixel: interpolates normals over a triangle, normalises them there, and adds all lights of the scene.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "zstrip/base/pixel_direction.hpp"
#include "zstrip/effects/local_light/local_light.hpp"
#include "zstrip/pixels/colour.hpp"
#include "zstrip/raster/lit_corners.hpp"
#include "zstrip/raster/space_planes.hpp"

namespace zstrip::detail {

/// Adds a directional light; `colour` contains the material's. `light` is 1.15 in the space of the normal.
template <class Light>
void add_directional(LightSum& total, const Light& towards, const Colour& colour, const UnitVector& normal) {
  const std::int32_t cosine = normal.x * towards.x + normal.y * towards.y + normal.z * towards.z;  // 3.29: below 2^30
  if (cosine <= 0) return;
  total.add(colour, std::min(static_cast<Gain>(cosine) >> 17, kAllOfIt));
}

/// The values for the light on one triangle's pixels. `settings` must outlive it.
template <Effects effects>
class PixelLight {
  static constexpr bool kOrthographic = effects.has(effect::orthographic);
  static constexpr bool kLocal = effects.any(effect::local_light);
  static constexpr bool kDivides = effects.has(effect::punctual_lights) && !kOrthographic;

 public:
  PixelLight() = default;
  PixelLight(const TrianglePlanes& setup, const RasterVertex* const (&v)[3], const LitSurface& surface,
             const PixelLightSettings& settings)
      : is_on_(true) {
    const CornerInverses<kOrthographic> inverses(v, surface.depth_offset);
    const LitCorner(&c)[3] = surface.corners;
    normal_ = SpacePlanes(setup, {c[0].normal, c[1].normal, c[2].normal}, inverses);
    if constexpr (kLocal) {
      if (settings.shading == nullptr) return;
      place_ = SpacePlanes(setup, {c[0].place, c[1].place, c[2].place}, inverses);
      if constexpr (kDivides) {
        const auto& q = inverses.q;
        one_over_w_ = setup.plane(q[0], q[1] - q[0], q[2] - q[0]);
      }
    }
  }

  /// True if this triangle is lit at its pixels.
  bool is_on() const { return is_on_; }

  /// Returns the colour of the lit material, 0..255 a channel. Not inlined: the loop keeps its registers.
  [[gnu::noinline]] FragmentColour at(std::int32_t columns, std::int32_t rows,
                                      const PixelLightSettings& settings) const {
    const CompiledInstance& instance = *settings.instance;
    const Vector3 n = normal_.at(columns, rows);
    const UnitVector normal = pixel_direction_of(n.x, n.y, n.z).unit;
    LightSum total{instance.ambient.r, instance.ambient.g, instance.ambient.b};
    for (std::uint32_t i = 0; i < instance.light_count; ++i) {
      const ObjectLight& light = instance.lights[i];
      const Colour colour{light.r, light.g, light.b, 255};
      if constexpr (kLocal) {
        if (settings.shading != nullptr) {
          add_directional(total, settings.scene->lights[i], colour, normal);
          continue;
        }
      }
      add_directional(total, light, colour, normal);
    }
    if constexpr (kLocal) {
      if (settings.shading != nullptr) add_local(total, columns, rows, normal, settings);
    }
    if constexpr (effects.has(effect::emissive)) {
      total.r += settings.finish.emissive.r;
      total.g += settings.finish.emissive.g;
      total.b += settings.finish.emissive.b;
    }
    return {clamped_channel(total.r), clamped_channel(total.g), clamped_channel(total.b), 255};
  }

 private:
  void add_local(LightSum& total, std::int32_t columns, std::int32_t rows, const UnitVector& normal,
                 const PixelLightSettings& settings) const {
    const bool shines = effects.has(effect::specular) && !is_black(settings.finish.specular);
    // With perspective the vector to the eye may have any length.
    UnitVector to_eye = settings.lights->back;
    if constexpr (!kOrthographic) {
      if (shines) {
        const Vector3 p = place_.at(columns, rows);
        to_eye = pixel_direction_of(-p.x, -p.y, -p.z).unit;
      }
    }
    WorldPoint at{};
    if constexpr (effects.has(effect::punctual_lights)) {
      const Vector3 p = kOrthographic ? place_.undivided_at(columns, rows) : divided_place(columns, rows);
      at = {p.x, p.y, p.z};
    }
    LitPoint<effects, pixel_direction_of> point{at, normal, to_eye, settings.finish.shininess, shines};
    point.add_all_to(total, settings.scene->lights.first(settings.instance->light_count), *settings.lights,
                     settings.colour, settings.finish.specular);
  }

  Vector3 divided_place(std::int32_t columns, std::int32_t rows) const {
    if constexpr (kDivides) return place_.divided_at(columns, rows, one_over_w_.at(columns, rows));
    return {};
  }

  bool is_on_ = false;
  SpacePlanes normal_;
  [[no_unique_address]] std::conditional_t<kLocal, SpacePlanes, Absent> place_;
  [[no_unique_address]] std::conditional_t<kDivides, Plane, Absent> one_over_w_;
};

}  // namespace zstrip::detail
