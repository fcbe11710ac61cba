// The span loop of instances whose fragments have effects: depth test, then the stages that exist, then the write.
// Slower than the loops of span_fill.hpp, which draw all other instances of the same scene.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "zstrip/geometry/light.hpp"
#include "zstrip/raster/fragment_settings.hpp"
#include "zstrip/raster/span_triangle.hpp"

namespace zstrip::detail {

/// A fragment's colour on its way to the pixel, 0..255 a channel.
struct FragmentColour {
  std::uint32_t r, g, b, a;
};

/// `share` 0..256 of a, the rest of b; rounded to nearest.
constexpr std::uint32_t mixed(std::uint32_t a, std::uint32_t b, std::uint32_t share) {
  return (a * share + b * (256 - share) + 128) >> 8;
}

/// RGB565 to 8 bits a channel, the upper bits repeated below: 31 and 63 become 255.
constexpr FragmentColour expanded(std::uint16_t pixel) {
  const std::uint32_t r = pixel >> 11, g = (pixel >> 5) & 0x3FU, b = pixel & 0x1FU;
  return {(r << 3) | (r >> 2), (g << 2) | (g >> 4), (b << 3) | (b >> 2), 255};
}

/// Texel times light, channels of 8.16; light of 255 leaves the texel as it is.
constexpr FragmentColour modulated(const FragmentColour& texel, std::uint32_t r, std::uint32_t g, std::uint32_t b) {
  const auto product = [](std::uint32_t channel, std::uint32_t light) {
    const std::uint32_t whole = light >> 16;
    return (channel * (whole + (whole >> 7)) + 128) >> 8;
  };
  return {product(texel.r, r), product(texel.g, g), product(texel.b, b), texel.a};
}

/// Fetches texels by coordinates in fractions of the texture, 0.32. `palettes`: of textures that may have one.
template <bool palettes>
class TextureSampler {
 public:
  using Indices = std::conditional_t<palettes, TexelIndices, Absent>;

  TextureSampler() = default;
  TextureSampler(const TextureView& texture, Indices indices)
      : texels_(texture.texels),
        log2_width_(texture.log2_width),
        log2_height_(texture.log2_height),
        to_column_(TextureAxis(texture.log2_width).to_index),
        to_row_(texture.log2_height + texture.log2_width == 0 ? 31 : 32 - texture.log2_height - texture.log2_width),
        row_mask_(~((std::uint32_t{1} << texture.log2_width) - 1)),
        indices_(indices) {}

  template <bool alpha>
  FragmentColour nearest(std::uint32_t u, std::uint32_t v, bool has_alpha) const {
    return texel<alpha>(nearest_index(u, v), has_alpha);
  }
  /// RGB565.
  std::uint16_t nearest_word(std::uint32_t u, std::uint32_t v) const { return word(nearest_index(u, v)); }

  /// The mean of the four texels whose centres lie around the point, by their distance in 1/256; rounded to nearest.
  template <bool alpha>
  FragmentColour bilinear(std::uint32_t u, std::uint32_t v, bool has_alpha) const {
    const Between x(u, log2_width_), y(v, log2_height_);
    const auto fetch = [&](std::uint32_t column, std::uint32_t row) {
      return texel<alpha>((row << log2_width_) + column, has_alpha);
    };
    const FragmentColour a = fetch(x.first, y.first), b = fetch(x.second, y.first), c = fetch(x.first, y.second),
                         d = fetch(x.second, y.second);
    const auto mean = [&](std::uint32_t FragmentColour::*channel) {
      const std::uint32_t upper = a.*channel * (256 - x.share) + b.*channel * x.share;
      const std::uint32_t lower = c.*channel * (256 - x.share) + d.*channel * x.share;
      return (upper * (256 - y.share) + lower * y.share + 32768) >> 16;
    };
    return {mean(&FragmentColour::r), mean(&FragmentColour::g), mean(&FragmentColour::b), mean(&FragmentColour::a)};
  }

 private:
  std::uint32_t nearest_index(std::uint32_t u, std::uint32_t v) const {
    return ((v >> to_row_) & row_mask_) + (u >> to_column_);
  }

  /// The texel's RGB565.
  std::uint16_t word(std::uint32_t index) const {
    if constexpr (palettes) {
      if (indices_.bits == 8) return texels_[(texels_[256 + (index >> 1)] >> (8 * (index & 1))) & 0xFF];
      if (indices_.bits == 4) return texels_[(texels_[16 + (index >> 2)] >> (4 * (index & 3))) & 0xF];
    }
    return texels_[index];
  }

  /// Two neighbours along an axis that repeats, and the second one's share in 1/256.
  struct Between {
    std::uint32_t first = 0, second = 0, share = 0;

    Between(std::uint32_t fraction, std::uint32_t log2_size) {
      if (log2_size == 0) return;
      const std::uint32_t from_centre = fraction - (std::uint32_t{1} << (31 - log2_size));
      first = from_centre >> (32 - log2_size);
      second = (first + 1) & ((std::uint32_t{1} << log2_size) - 1);
      share = (from_centre << log2_size) >> 24;
    }
  };

  template <bool alpha>
  FragmentColour texel(std::uint32_t index, [[maybe_unused]] bool has_alpha) const {
    FragmentColour colour = expanded(word(index));
    if constexpr (alpha) {
      const std::uint32_t texels = std::uint32_t{1} << (log2_width_ + log2_height_);
      if (has_alpha) colour.a = (texels_[texels + (index >> 1)] >> (8 * (index & 1))) & 0xFFU;
    }
    return colour;
  }

  const std::uint16_t* texels_ = nullptr;
  std::uint32_t log2_width_ = 0, log2_height_ = 0;
  std::int32_t to_column_ = 0, to_row_ = 0;  ///< right shifts; a row stays multiplied by the width
  std::uint32_t row_mask_ = 0;
  [[no_unique_address]] Indices indices_{};
};

/// Everything that varies over a triangle but its depth, as far as the effects go.
template <Effects effects>
struct FragmentPlanes {
  static constexpr bool kOrthographic = effects.has(effect::orthographic);
  using Sampler = TextureSampler<effects.has(effect::texture_palettes)>;

  FragmentPlanes(const PlaneSetup& setup, const RasterVertex* const (&v)[3], const Surface& surface,
                 const FragmentSettings& settings) {
    const auto plane = [&](auto member) {
      const auto value = [&](int i) { return std::int64_t{v[i]->*member}; };
      return setup.plane(value(0), value(1) - value(0), value(2) - value(0));
    };
    light = {plane(&RasterVertex::r), plane(&RasterVertex::g), plane(&RasterVertex::b)};
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

  ColourPlanes light;  ///< constant over a flat triangle, 255 where texels are not lit
  bool textured = false, fogged = false;
  TextureView texture{};
  template <Effects needed, class Member>
  using If = MemberIf<effects, needed, Member>;
  [[no_unique_address]] If<effect::textures, TextureCoordinates<kOrthographic>> coordinates;
  [[no_unique_address]] If<effect::fog, FogPlane<kOrthographic>> fog;
  [[no_unique_address]] If<effect::dithered_colours, DitherAnchor> dither;
  [[no_unique_address]] typename Sampler::Indices indices;
};

/// What is exact at the ends of a run only, and linear between.
struct FragmentPoint {
  TexelPosition texel{};
  std::int32_t visibility = 0;  ///< 0..65536
};

template <Effects effects>
FragmentPoint point_at(const FragmentPlanes<effects>& planes, std::int32_t columns, std::int32_t rows) {
  FragmentPoint point;
  if constexpr (effects.has(effect::textures)) {
    if (planes.textured) point.texel = planes.coordinates.at(columns, rows);
  }
  if constexpr (effects.has(effect::fog)) {
    if (planes.fogged) point.visibility = planes.fog.at(columns, rows);
  }
  return point;
}

/// A difference over a run that ends `left` pixels before the end of the span: a step a pixel, rounded down.
constexpr std::int32_t step_of_run(std::int32_t difference, std::int32_t left) {
  if (left > kPerspectiveRun) return difference >> 4;
  if (left <= 1) return 0;
  return static_cast<std::int32_t>((difference * static_cast<std::int64_t>(kInverse[left - 1])) >> 16);
}

/// The stages after the depth test; false if the fragment is discarded. `u`, `v` in 0.32 of the texture, light in 8.16,
/// `visible` 0..256. With effect::dithered_colours a threshold of kBayer comes last.
template <Effects effects, class... Threshold>
bool shade_fragment(const FragmentPlanes<effects>& planes, const FragmentSettings& settings,
                    [[maybe_unused]] const typename FragmentPlanes<effects>::Sampler& sampler, std::uint32_t r,
                    std::uint32_t g, std::uint32_t b, [[maybe_unused]] std::uint32_t u,
                    [[maybe_unused]] std::uint32_t v, [[maybe_unused]] std::uint32_t visible, std::uint16_t& pixel,
                    Threshold... threshold) {
  constexpr bool kTextureAlpha = effects.has(effect::texture_alpha);
  if constexpr (effects.has(effect::texture_palettes)) {
    // As TexturedRun does, so that a palette changes no pixel.
    if (planes.indices.only_effect) {
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

/// A span of one triangle. `planes` and `settings` are its instance's.
template <Effects effects, class DepthPlane, class Rule>
void fill_fragments(const Span<typename Rule::Cell>& span, const DepthPlane& depth, const Rule& rule,
                    const FragmentPlanes<effects>& planes, const FragmentSettings& settings, Statistics* counters) {
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
    sampler = {planes.texture, planes.indices};
    axis_u = TextureAxis(planes.texture.log2_width);
    axis_v = TextureAxis(planes.texture.log2_height);
  }
  // As in fill_textured: runs count from the whole span's left end, whatever the strip holds of it.
  std::int32_t before = span.skipped & (kPerspectiveRun - 1);
  std::int32_t column = span.columns - before;
  std::int32_t left = span.whole_length - span.skipped + before;
  std::int32_t to_draw = span.length;
  auto* cell = span.depth;
  std::uint16_t* pixel = span.colour;
  FragmentPoint from = point_at(planes, column, span.rows);
  for (;;) {
    // A full run ends at the next one's first pixel, the last run at its own last pixel: always inside the triangle.
    const std::int32_t length = std::min(left, kPerspectiveRun);
    const FragmentPoint to =
        left > 1 ? point_at(planes, column + (left > kPerspectiveRun ? length : length - 1), span.rows) : from;
    std::uint32_t u = 0, v = 0, step_u = 0, step_v = 0;
    if constexpr (kTextures) {
      step_u = axis_u.fraction(step_of_run(difference(to.texel.u, from.texel.u), left));
      step_v = axis_v.fraction(step_of_run(difference(to.texel.v, from.texel.v), left));
      u = axis_u.fraction(from.texel.u) + step_u * static_cast<std::uint32_t>(before);
      v = axis_v.fraction(from.texel.v) + step_v * static_cast<std::uint32_t>(before);
    }
    std::int32_t visible = 0, step_visible = 0;  // 8.16, up to 256
    if constexpr (kFog) {
      step_visible = step_of_run((to.visibility - from.visibility) * 256, left);
      visible = from.visibility * 256 + 128 + step_visible * before;  // 128: steps rounded down do not fall below 0
    }
    const std::int32_t drawn = std::min(length - before, to_draw);
    for (std::int32_t i = 0; i < drawn; ++i) {
      // The cell is written last: stages may still discard the fragment, and what is blended hides nothing.
      typename Rule::Cell kept = *cell;
      bool shown = rule.may_draw(z, kept);
      const std::uint32_t share = static_cast<std::uint32_t>(visible) >> 16;
      if constexpr (kDithered) {
        const std::uint32_t threshold = planes.dither.threshold(column + before + i, span.rows);
        shown = shown && shade_fragment(planes, settings, sampler, r, g, b, u, v, share, *pixel, threshold);
      } else {
        shown = shown && shade_fragment(planes, settings, sampler, r, g, b, u, v, share, *pixel);
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

/// Draws a counter-clockwise triangle of an instance whose fragments have effects. `narrow`: as draw_span_triangle.
template <Effects effects>
void draw_fragment_triangle(const TargetOf<effects>& target, const RasterVertex& v0, const RasterVertex& v1,
                            const RasterVertex& v2, const Surface& surface, bool narrow) {
  constexpr DepthMode kMode = depth_mode(effects);
  const SpanTriangle<kMode> triangle(target, v0, v1, v2);
  const RasterVertex* const vertices[3] = {&v0, &v1, &v2};
  FragmentPlanes<effects> planes(triangle.setup, vertices, surface, target.fragments);
  if constexpr (effects.has(effect::dithered_colours)) {
    planes.dither = {triangle.anchor_x - target.view_left, triangle.anchor_y - target.view_top, target.dithered};
  }
  if constexpr (effects.has(effect::texture_palettes)) planes.indices = target.indices;
  triangle.template walk<effects.has(effect::statistics), true>(
      target, v0, v1, v2, narrow, [&](const auto& run, const auto& z, const auto& rule) {
        fill_fragments<effects>(run, z, rule, planes, target.fragments, target.statistics);
      });
}

}  // namespace zstrip::detail
