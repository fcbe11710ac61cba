// The span loop of instances whose fragments have effects: depth test, then the stages of the effects, then the write.
// Slower than the loops of textured_span.hpp, which draw the other instances of the scene.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/effects/pixel_shading/pixel_light.hpp"
#include "zstrip/geometry/light.hpp"
#include "zstrip/raster/fragment_settings.hpp"
#include "zstrip/raster/span_triangle.hpp"
#include "zstrip/raster/texture_sampler.hpp"

namespace zstrip::detail {

/// Returns the mean of `a`, weighted `share` (0..256), and `b`, weighted 256 - share, rounded to nearest.
constexpr std::uint32_t mixed(std::uint32_t a, std::uint32_t b, std::uint32_t share) {
  return (a * share + b * (256 - share) + 128) >> 8;
}

/// Multiplies a texel by light channels of 8.16; light of 255 leaves the texel unchanged.
constexpr FragmentColour modulated(const FragmentColour& texel, std::uint32_t r, std::uint32_t g, std::uint32_t b) {
  const auto product = [](std::uint32_t channel, std::uint32_t light) {
    const std::uint32_t whole = light >> 16;
    return (channel * (whole + (whole >> 7)) + 128) >> 8;
  };
  return {product(texel.r, r), product(texel.g, g), product(texel.b, b), texel.a};
}

/// All values of these effects that vary over a triangle, except depth.
template <Effects effects>
struct FragmentPlanes {
  static constexpr bool kOrthographic = effects.has(effect::orthographic);
  using Sampler = TextureSampler<effects.has(effect::texture_palettes), effects.has(effect::mipmaps)>;

  FragmentPlanes(const PlaneSetup& setup, const RasterVertex* const (&v)[3], const FragmentSurface<effects>& surface,
                 const TargetOf<effects>& target) {
    const FragmentSettings& settings = target.fragments;
    const auto plane = [&](auto member) {
      const auto value = [&](int i) { return std::int64_t{v[i]->*member}; };
      return setup.plane(value(0), value(1) - value(0), value(2) - value(0));
    };
    bool varies = true;
    if constexpr (effects.has(effect::pixel_shading)) {
      const CompiledInstance& instance = *target.light.instance;
      if (has_lit_fragments(instance.shade)) {
        pixel_light = PixelLight<effects>(setup, v, surface, target.light);
        varies = instance.coloured;
      }
    }
    if (varies) {
      light = {plane(&RasterVertex::r), plane(&RasterVertex::g), plane(&RasterVertex::b)};
    } else {
      const Plane white{static_cast<std::uint32_t>(channel_start(255)), 0, 0};
      light = {white, white, white};
    }
    if constexpr (effects.has(effect::textures)) {
      textured = settings.textured;
      if (textured) {
        texture = surface.texture;
        coordinates = TextureCoordinates<kOrthographic>(setup, v, surface.depth_offset);
      }
    }
    if constexpr (effects.has(effect::fog)) {
      fogged = settings.fog != nullptr;
      if (fogged) fog = FogPlane<kOrthographic>(*settings.fog, setup, v, settings.depth_offset);
    }
  }

  ColourPlanes light;  ///< constant over a flat triangle; 255 if texels are not lit; vertex colours with pixel_light
  bool textured = false, fogged = false;
  TextureView texture{};
  template <Effects needed, class Member>
  using If = MemberIf<effects, needed, Member>;
  [[no_unique_address]] If<effect::textures, TextureCoordinates<kOrthographic>> coordinates;
  [[no_unique_address]] If<effect::fog, FogPlane<kOrthographic>> fog;
  [[no_unique_address]] If<effect::dithered_colours, DitherAnchor> dither;
  [[no_unique_address]] If<effect::pixel_shading, PixelLight<effects>> pixel_light;
  [[no_unique_address]] typename Sampler::Storage storage;
};

/// Values that are exact only at the ends of a run, and linear in between.
struct FragmentPoint {
  TexelPosition texel{};
  std::uint32_t footprint = 0;  ///< TexelFootprint::texels
  std::int32_t visibility = 0;  ///< 0..65536
};

template <Effects effects>
FragmentPoint point_at(const FragmentPlanes<effects>& planes, std::int32_t columns, std::int32_t rows) {
  FragmentPoint point;
  if constexpr (effects.has(effect::textures)) {
    if constexpr (effects.has(effect::mipmaps)) {
      if (planes.textured && planes.storage.smaller_levels != 0) {
        const TexelFootprint there = planes.coordinates.footprint_at(columns, rows);
        point.texel = there.position, point.footprint = there.texels;
      } else if (planes.textured) {
        point.texel = planes.coordinates.at(columns, rows);
      }
    } else if (planes.textured) {
      point.texel = planes.coordinates.at(columns, rows);
    }
  }
  if constexpr (effects.has(effect::fog)) {
    if (planes.fogged) point.visibility = planes.fog.at(columns, rows);
  }
  return point;
}

/// Returns a run's step a pixel for a difference, rounded down. The run begins `left` pixels before the span's end.
constexpr std::int32_t step_of_run(std::int32_t difference, std::int32_t left) {
  if (left > kPerspectiveRun) return difference >> 4;
  if (left <= 1) return 0;
  return static_cast<std::int32_t>((difference * static_cast<std::int64_t>(kInverse[left - 1])) >> 16);
}

/// Runs the stages after the depth test. Returns false if the fragment is discarded. `u`, `v` in 0.32 of the texture,
/// light in 8.16, `visible` 0..256. With effect::dithered_colours the last argument is a threshold of kBayer.
template <Effects effects, class... Threshold>
bool shade_fragment(const FragmentPlanes<effects>& planes, const FragmentSettings& settings,
                    [[maybe_unused]] const typename FragmentPlanes<effects>::Sampler& sampler, std::uint32_t r,
                    std::uint32_t g, std::uint32_t b, [[maybe_unused]] std::uint32_t u,
                    [[maybe_unused]] std::uint32_t v, [[maybe_unused]] std::uint32_t visible, std::uint16_t& pixel,
                    Threshold... threshold) {
  constexpr bool kTextureAlpha = effects.has(effect::texture_alpha);
  if constexpr (effects.any(effect::texture_palettes | effect::mipmaps)) {
    // Rounds as TexturedRun does, so that a palette changes no pixel and a smaller level changes only the texel.
    if (planes.storage.only_effect) {
      pixel = modulated(sampler.nearest_word(u, v), r, g, b);
      return true;
    }
  }
  FragmentColour colour{r >> 16, g >> 16, b >> 16, 255};
  if constexpr (effects.has(effect::textures)) {
    if (planes.textured) {
      FragmentColour texel;
      bool fetched = false;
      if constexpr (effects.has(effect::bilinear)) {
        fetched = settings.bilinear;
        if (fetched) texel = sampler.template bilinear<kTextureAlpha>(u, v, settings.has_texture_alpha);
      }
      if (!fetched) texel = sampler.template nearest<kTextureAlpha>(u, v, settings.has_texture_alpha);
      colour = modulated(texel, r, g, b);
    }
  }
  if constexpr (effects.any(effect::alpha_test | effect::blending)) {
    colour.a = (colour.a * factor(settings.alpha)) >> 8;
  }
  if constexpr (effects.has(effect::alpha_test)) {
    if (colour.a < settings.cutoff) return false;
  }
  if constexpr (effects.has(effect::fog)) {
    if (planes.fogged) {
      const Colour& fog = settings.fog->colour;
      colour = {mixed(colour.r, fog.r, visible), mixed(colour.g, fog.g, visible), mixed(colour.b, fog.b, visible),
                colour.a};
    }
  }
  if constexpr (effects.has(effect::blending)) {
    if (settings.blends) {
      const FragmentColour behind = expanded(pixel);
      const std::uint32_t share = factor(colour.a);
      colour = {mixed(colour.r, behind.r, share), mixed(colour.g, behind.g, share), mixed(colour.b, behind.b, share),
                255};
    }
  }
  if constexpr (sizeof...(threshold) != 0) {
    if (planes.dither.dithered) {
      pixel = dithered_rgb565(colour.r, colour.g, colour.b, threshold...);
      return true;
    }
  }
  pixel = rgb565(colour.r << 16, colour.g << 16, colour.b << 16);
  return true;
}

/// Draws a span of one triangle. `target` has the settings of the triangle's instance.
template <Effects effects, class DepthPlane, class Rule>
void fill_fragments(const Span<typename Rule::Cell>& span, const DepthPlane& depth, const Rule& rule,
                    const FragmentPlanes<effects>& planes, const TargetOf<effects>& target, Statistics* counters) {
  const FragmentSettings& settings = target.fragments;
  constexpr bool kTextures = effects.has(effect::textures);
  constexpr bool kFog = effects.has(effect::fog);
  constexpr bool kDithered = effects.has(effect::dithered_colours);
  auto z = depth.at(span.columns, span.rows);
  std::uint32_t r = planes.light.r.at(span.columns, span.rows);
  std::uint32_t g = planes.light.g.at(span.columns, span.rows);
  std::uint32_t b = planes.light.b.at(span.columns, span.rows);
  typename FragmentPlanes<effects>::Sampler sampler;
  TextureAxis axis_u(0), axis_v(0);
  if constexpr (kTextures) {
    sampler = {planes.texture, planes.storage};
    axis_u = TextureAxis(planes.texture.log2_width);
    axis_v = TextureAxis(planes.texture.log2_height);
  }
  // As in fill_textured, runs are counted from the left end of the whole span, so that they do not depend on the strip.
  std::int32_t before = span.skipped & (kPerspectiveRun - 1);
  std::int32_t column = span.columns - before;
  std::int32_t left = span.whole_length - span.skipped + before;
  std::int32_t to_draw = span.length;
  auto* cell = span.depth;
  std::uint16_t* pixel = span.colour;
  FragmentPoint from = point_at(planes, column, span.rows);
  for (;;) {
    // A full run ends at the first pixel of the next run, the last run at its own last pixel, both inside the triangle.
    const std::int32_t length = std::min(left, kPerspectiveRun);
    const FragmentPoint to =
        left > 1 ? point_at(planes, column + (left > kPerspectiveRun ? length : length - 1), span.rows) : from;
    std::uint32_t u = 0, v = 0, step_u = 0, step_v = 0;
    if constexpr (kTextures && effects.has(effect::mipmaps)) {
      sampler.show(planes.texture, level_of_run(from.footprint, to.footprint, planes.storage.smaller_levels));
    }
    if constexpr (kTextures) {
      step_u = axis_u.fraction(step_of_run(difference(to.texel.u, from.texel.u), left));
      step_v = axis_v.fraction(step_of_run(difference(to.texel.v, from.texel.v), left));
      u = axis_u.fraction(from.texel.u) + step_u * static_cast<std::uint32_t>(before);
      v = axis_v.fraction(from.texel.v) + step_v * static_cast<std::uint32_t>(before);
    }
    std::int32_t visible = 0, step_visible = 0;  // 8.16, up to 256
    if constexpr (kFog) {
      step_visible = step_of_run((to.visibility - from.visibility) * 256, left);
      visible = from.visibility * 256 + 128 + step_visible * before;  // 128 keeps steps that are rounded down from
                                                                      // falling below 0
    }
    const std::int32_t drawn = std::min(length - before, to_draw);
    for (std::int32_t i = 0; i < drawn; ++i) {
      // The cell is written last: the stages may discard the fragment, and a blended fragment hides nothing.
      typename Rule::Cell kept = *cell;
      bool shown = rule.may_draw(z, kept);
      const std::uint32_t share = static_cast<std::uint32_t>(visible) >> 16;
      const auto shade = [&](std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
        if constexpr (kDithered) {
          const std::uint32_t threshold = planes.dither.threshold(column + before + i, span.rows);
          return shade_fragment(planes, settings, sampler, red, green, blue, u, v, share, *pixel, threshold);
        } else {
          return shade_fragment(planes, settings, sampler, red, green, blue, u, v, share, *pixel);
        }
      };
      if constexpr (effects.has(effect::pixel_shading)) {
        if (shown && planes.pixel_light.is_on()) {
          const FragmentColour lit =
              modulated(planes.pixel_light.at(column + before + i, span.rows, target.light), r, g, b);
          shown = shade(lit.r << 16, lit.g << 16, lit.b << 16);
        } else {
          shown = shown && shade(r, g, b);
        }
      } else {
        shown = shown && shade(r, g, b);
      }
      if (shown) {
        rule.drawn(kept, !effects.has(effect::blending) || !settings.blends, *cell);
        count_pass<effects.has(effect::statistics)>(counters);
      }
      ++cell;
      ++pixel;
      z += depth.step_x;
      r += planes.light.r.step_x;
      g += planes.light.g.step_x;
      b += planes.light.b.step_x;
      u += step_u;
      v += step_v;
      visible += step_visible;
    }
    to_draw -= drawn;
    if (to_draw == 0) break;
    column += kPerspectiveRun;
    left -= kPerspectiveRun;
    before = 0;
    from = to;
  }
}

/// Draws a counter-clockwise triangle of an instance whose fragments have effects. `narrow`: see draw_span_triangle.
template <Effects effects, class Narrow>
void draw_fragment_triangle(const TargetOf<effects>& target, const RasterVertex& v0, const RasterVertex& v1,
                            const RasterVertex& v2, const FragmentSurface<effects>& surface, Narrow narrow) {
  constexpr DepthMode kMode = depth_mode(effects);
  const SpanTriangle<kMode> triangle(target, v0, v1, v2);
  const RasterVertex* const vertices[3] = {&v0, &v1, &v2};
  FragmentPlanes<effects> planes(triangle.setup, vertices, surface, target);
  if constexpr (effects.has(effect::dithered_colours)) {
    planes.dither = {triangle.anchor_x - target.view_left, triangle.anchor_y - target.view_top, target.dithered};
  }
  if constexpr (effects.any(effect::texture_palettes | effect::mipmaps)) planes.storage = target.storage;
  triangle.template walk<effects.has(effect::statistics), true>(
      target, v0, v1, v2, narrow, [&](const auto& run, const auto& z, const auto& rule) {
        fill_fragments<effects>(run, z, rule, planes, target, target.statistics);
      });
}

}  // namespace zstrip::detail
