// Draws instances whose fragments have effects, in runs of up to 16 pixels: depth test, then one stage after the other
// for all pixels of the run (kernels/fragment_run.hpp). Slower than textured_span.hpp, which draws the other instances
// of the scene.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "zstrip/base/bayer.hpp"
#include "zstrip/geometry/light.hpp"
#include "zstrip/kernels/fragment_run.hpp"
#include "zstrip/raster/fragment_settings.hpp"
#include "zstrip/raster/pixel_light.hpp"
#include "zstrip/raster/run_texels.hpp"
#include "zstrip/raster/span_triangle.hpp"

namespace zstrip::detail {

/// All values of these effects that vary over a triangle, except depth.
template <Effects effects>
struct FragmentPlanes {
  static constexpr bool kOrthographic = effects.has(effect::orthographic);
  static constexpr bool kStored = effects.any(effect::texture_palettes | effect::mipmaps);

  FragmentPlanes(const TrianglePlanes& setup, const RasterVertex* const (&v)[3],
                 const FragmentSurface<effects>& surface, const TargetOf<effects>& target) {
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
      const auto channel = [&](auto member) {
        const std::int32_t first = v[0]->*member;
        if (v[1]->*member != first || v[2]->*member != first) return plane(member);
        return Plane{static_cast<std::uint32_t>(first), 0, 0};
      };
      light = {channel(&RasterVertex::r), channel(&RasterVertex::g), channel(&RasterVertex::b)};
    } else {
      const Plane white{static_cast<std::uint32_t>(channel_start(255)), 0, 0};
      light = {white, white, white};
    }
    const auto is_one = [](const Plane& channel) {
      return channel.start >> 16 == 255 && channel.step_x == 0 && channel.step_y == 0;
    };
    unlit = is_one(light.r) && is_one(light.g) && is_one(light.b);
    if constexpr (effects.has(effect::textures)) {
      textured = settings.textured;
      if (textured) {
        TextureFormat format = TextureFormat::rgb565;
        if constexpr (kStored) storage = target.storage, format = storage.format;
        texels = texels_of(surface.texture, format);
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
  bool unlit = false;  ///< light is 255 everywhere, and changes no texel
  template <Effects needed, class Member>
  using If = MemberIf<effects, needed, Member>;
  [[no_unique_address]] If<effect::textures, RunTexels> texels{};
  [[no_unique_address]] If<effect::textures, TextureCoordinates<kOrthographic>> coordinates;
  [[no_unique_address]] If<effect::fog, FogPlane<kOrthographic>> fog;
  [[no_unique_address]] If<effect::dithered_colours, DitherAnchor> dither;
  [[no_unique_address]] If<effect::pixel_shading, PixelLight<effects>> pixel_light;
  [[no_unique_address]] std::conditional_t<kStored, TexelStorage, Absent> storage;
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

/// Neighbouring pixels of one triangle in a row, of which all that varies is stepped.
template <Effects effects>
struct FragmentRun {
  const FragmentPlanes<effects>& planes;
  const TargetOf<effects>& target;
  RunTexels texels;                            ///< this and the next two only with effect::textures
  std::uint32_t to_fraction_u, to_fraction_v;  ///< TextureAxis
  RunPlace place;
  RunLight light;
  std::int32_t visible, step_visible;  ///< 8.16, up to 256
  std::int32_t columns, rows;          ///< of the first pixel, from the anchor
  std::int32_t count;                  ///< 1 .. kPerspectiveRun

  static constexpr bool kPalettes = effects.has(effect::texture_palettes);
  static constexpr bool kAlpha = effects.has(effect::texture_alpha);

  /// Runs of a triangle. What varies is set for each span, and for each run.
  FragmentRun(const FragmentPlanes<effects>& of, const TargetOf<effects>& on) : planes(of), target(on) {
    light = {of.light.r.start,  of.light.g.start,  of.light.b.start,
             of.light.r.step_x, of.light.g.step_x, of.light.b.step_x};
    if constexpr (effects.has(effect::textures)) {
      texels = of.texels;
      to_fraction_u = TextureAxis(static_cast<std::uint8_t>(texels.log2_width)).to_fraction;
      to_fraction_v = TextureAxis(static_cast<std::uint8_t>(texels.log2_height)).to_fraction;
    }
  }

  /// Sets the row and the light of a span.
  void begin_span(std::int32_t first_column, std::int32_t row) {
    rows = row;
    if (planes.unlit) return;  // it is the same everywhere
    light.r = planes.light.r.at(first_column, row);
    light.g = planes.light.g.at(first_column, row);
    light.b = planes.light.b.at(first_column, row);
  }

  /// Sets the values that are stepped between two exact points. The run begins `before` pixels to the right of the
  /// first one; `left` is step_of_run's.
  void set_ends(const FragmentPoint& from, const FragmentPoint& to, std::int32_t left, std::int32_t before) {
    if constexpr (effects.has(effect::mipmaps)) {
      texels = level_of(planes.texels, level_of_run(from.footprint, to.footprint, planes.storage.smaller_levels));
    }
    if constexpr (effects.has(effect::textures)) {
      const auto fraction = [](std::int32_t at, std::uint32_t to_fraction) {
        return static_cast<std::uint32_t>(at) * to_fraction;
      };
      place.step_u = fraction(step_of_run(difference(to.texel.u, from.texel.u), left), to_fraction_u);
      place.step_v = fraction(step_of_run(difference(to.texel.v, from.texel.v), left), to_fraction_v);
      place.u = fraction(from.texel.u, to_fraction_u) + place.step_u * static_cast<std::uint32_t>(before);
      place.v = fraction(from.texel.v, to_fraction_v) + place.step_v * static_cast<std::uint32_t>(before);
    }
    if constexpr (effects.has(effect::fog)) {
      step_visible = step_of_run((to.visibility - from.visibility) * 256, left);
      visible = from.visibility * 256 + 128 + step_visible * before;  // 128 keeps steps that are rounded down from
                                                                      // falling below 0
    }
  }

  /// Moves the first pixel to the right.
  void move(std::int32_t pixels) {
    const auto n = static_cast<std::uint32_t>(pixels);
    columns += pixels;
    light.r += light.step_r * n, light.g += light.step_g * n, light.b += light.step_b * n;
    if constexpr (effects.has(effect::textures)) place.u += place.step_u * n, place.v += place.step_v * n;
    if constexpr (effects.has(effect::fog)) visible += step_visible * pixels;
  }

  /// Draws the run if one stage writes its pixels, or light is the last of two. Returns false else.
  bool draw_at_once([[maybe_unused]] std::uint16_t* pixels) const {
    if constexpr (effects.any(effect::texture_palettes | effect::mipmaps)) {
      if (planes.storage.only_effect) {
        // Rounds as TexturedRun does, so that a palette changes no pixel and a smaller level changes only the texel.
        RunColours words;
        fetch_words<kPalettes>(texels, place, words, count);
        write_lit_words(light, words, pixels, count);
        return true;
      }
    }
    if constexpr (effects.has(effect::fog)) {
      if (planes.fogged && !has_texels() && !has_pixel_light() && !blends() && !discards() && !dithers()) {
        write_fogged_light(light, target.fragments.fog->colour, visible, step_visible, pixels, count);
        return true;
      }
    }
    if constexpr (effects.has(effect::textures)) {
      if (planes.textured && !planes.unlit && !planes.fogged && !has_pixel_light() && !blends() && !discards() &&
          !dithers()) {
        RunColours colours;
        fetch(colours);
        write_lit(light, colours, pixels, count);
        return true;
      }
    }
    return false;
  }

  /// Runs all stages over the colours of `pixels`, and writes the result to `shown`, which may be the same.
  void draw([[maybe_unused]] const std::uint16_t* pixels, std::uint32_t* colours, std::uint16_t* shown) const {
    [[maybe_unused]] const std::uint32_t alpha = shade(colours);
    if constexpr (effects.has(effect::blending)) {
      if (blends()) {
        if (!dithers()) return write_mixed(pixels, alpha, colours, shown, count);
        mix_behind(pixels, alpha, colours, count);
      }
    }
    write(colours, shown);
  }

  /// Runs the stages before blending. Returns the material's alpha (0 .. 256) if colours do not have it yet, else 256.
  std::uint32_t shade(std::uint32_t* colours) const {
    [[maybe_unused]] const FragmentSettings& settings = target.fragments;
    if (!has_texels()) {
      shine(colours);
    } else {
      fetch(colours);
      if (has_pixel_light()) {
        RunColours lights;
        shine(lights);
        multiply_by_colours(lights, colours, count);
      } else if (!planes.unlit) {
        multiply_by_light(light, colours, count);
      }
    }
    [[maybe_unused]] std::uint32_t alpha = factor(settings.alpha);
    if constexpr (effects.has(effect::alpha_test)) {
      if (discards()) multiply_alpha(alpha, colours, count), alpha = 256;
    }
    if constexpr (effects.has(effect::fog)) {
      if (planes.fogged) mix_fog(settings.fog->colour, visible, step_visible, colours, count);
    }
    return alpha;
  }

  void write(const std::uint32_t* colours, std::uint16_t* pixels) const {
    if constexpr (effects.has(effect::dithered_colours)) {
      if (dithers()) {
        return write_dithered(kBayer[(planes.dither.row + rows) & 7],
                              static_cast<std::uint32_t>(planes.dither.column + columns), colours, pixels, count);
      }
    }
    write_packed(colours, pixels, count);
  }

  /// Counts the stages of the run.
  void count_stages(auto& work) const {
    const auto pixels = static_cast<std::uint32_t>(count);
    ++work[WorkKind::runs];
    if (has_texels()) {
      bool bilinear = false, alpha = false;
      if constexpr (effects.has(effect::bilinear)) bilinear = target.fragments.bilinear;
      if constexpr (kAlpha) alpha = target.fragments.has_texture_alpha;
      work[bilinear ? WorkKind::bilinear_texels : WorkKind::nearest_texels] += pixels;
      if (alpha) work[WorkKind::texel_alphas] += pixels;
      if (!planes.unlit || has_pixel_light()) work[WorkKind::lit_texels] += pixels;
    }
    if constexpr (effects.has(effect::mipmaps)) {
      if (planes.textured && planes.storage.smaller_levels != 0) ++work[WorkKind::runs_of_levels];
    }
    if (has_pixel_light()) work[WorkKind::lit_fragments] += pixels;
    if (discards()) work[WorkKind::masked] += pixels;
    if constexpr (effects.has(effect::fog)) {
      if (planes.fogged) work[WorkKind::fogged] += pixels;
    }
    if (blends()) work[WorkKind::blended] += pixels;
    if (dithers()) work[WorkKind::dithered] += pixels;
  }

  bool discards() const { return effects.has(effect::alpha_test) && target.fragments.cutoff != 0; }
  bool blends() const { return effects.has(effect::blending) && target.fragments.blends; }
  bool dithers() const {
    if constexpr (effects.has(effect::dithered_colours)) return planes.dither.dithered;
    return false;
  }

 private:
  bool has_texels() const {
    if constexpr (effects.has(effect::textures)) return planes.textured;
    return false;
  }
  bool has_pixel_light() const {
    if constexpr (effects.has(effect::pixel_shading)) return planes.pixel_light.is_on();
    return false;
  }

  void fetch(std::uint32_t* colours) const {
    if constexpr (effects.has(effect::textures)) {
      const FragmentSettings& settings = target.fragments;
      const bool alpha = kAlpha && settings.has_texture_alpha;
      if constexpr (effects.has(effect::bilinear)) {
        if (settings.bilinear) {
          if constexpr (kAlpha) {
            if (alpha)
              return fetch_bilinear<false, true>(texels, place, colours, count);  // such texels have no palette
          }
          return fetch_bilinear<kPalettes, false>(texels, place, colours, count);
        }
      }
      fetch_nearest<kPalettes>(texels, place, colours, count);
      if constexpr (kAlpha) {
        if (alpha) fetch_alpha(texels, place, colours, count);
      }
    }
  }

  /// Sets colours to the light on each pixel.
  void shine(std::uint32_t* colours) const {
    if constexpr (effects.has(effect::pixel_shading)) {
      if (planes.pixel_light.is_on()) {
        for (std::int32_t i = 0; i < count; ++i) {
          const FragmentColour at = planes.pixel_light.at(columns + i, rows, target.light);
          colours[i] = 0xFF000000 | at.r << 16 | at.g << 8 | at.b;
        }
        if (!planes.unlit) multiply_by_light(light, colours, count);
        return;
      }
    }
    set_to_light(light, colours, count);
  }
};

/// Draws a run that passed the depth test. `codes`: the new codes of its cells, if a texel may still discard a pixel;
/// otherwise the cells have them already.
template <Effects effects, class Rule>
[[gnu::noinline]] void draw_fragment_run(const FragmentRun<effects>& run, [[maybe_unused]] const Rule& rule,
                                         [[maybe_unused]] typename Rule::Cell* codes,
                                         [[maybe_unused]] typename Rule::Cell* cells, std::uint16_t* pixels,
                                         Statistics* counters) {
  constexpr bool kCounts = effects.has(effect::statistics);
  if constexpr (kCounts) run.count_stages(counters->work);
  if (!run.draw_at_once(pixels)) {
    RunColours colours;
    if constexpr (effects.has(effect::alpha_test)) {
      if (run.discards()) {
        std::uint16_t shown[kPerspectiveRun];
        run.draw(pixels, colours, shown);
        for (std::int32_t i = 0; i < run.count; ++i) {
          if (colours[i] >> 24 < run.target.fragments.cutoff) continue;
          rule.drawn(codes[i], !run.blends(), cells[i]);
          pixels[i] = shown[i];
          count_pass<kCounts>(counters);
        }
        return;
      }
    }
    run.draw(pixels, colours, pixels);
  }
  for (std::int32_t i = 0; kCounts && i < run.count; ++i) count_pass<kCounts>(counters);
}

/// The use of the cell of a pixel that passes the depth test.
enum class CellUse : std::uint8_t {
  written,  ///< the pixel is drawn and hides what lies behind it
  kept,     ///< the pixel is drawn, but hides nothing
  later,    ///< a texel may still discard the pixel
};

/// Finds the first pixels from `first` on, before `count`, that pass the depth test one after another: moves `first` to
/// the first of them and returns the end. `z` is the depth at `first`; it moves along.
template <class Rule, class Value>
[[gnu::always_inline]] inline std::int32_t passing_pixels(CellUse use, const Rule& rule, typename Rule::Cell* cells,
                                                          Value& z, Value step, std::int32_t& first, std::int32_t count,
                                                          typename Rule::Cell* codes) {
  Value depth = z;
  std::int32_t i = first;
  const auto passes = [&] {
    typename Rule::Cell code = cells[i];
    bool result;
    if constexpr (Rule::kNearerOnly) {
      const typename Rule::Cell cell = std::exchange(code, rule.code(depth));
      result = code > cell;  // decided at once, or compilers keep both codes
    } else {
      result = rule.may_draw(depth, code);
    }
    depth += step;
    if (result) {
      if (use == CellUse::later) {
        codes[i] = code;
      } else {
        rule.drawn(code, use == CellUse::written, cells[i]);
      }
    }
    return result;
  };
  while (i < count && !passes()) ++i;
  first = i;
  if (i < count) ++i;
  while (i < count && passes()) ++i;
  z = depth;
  return i;
}

/// Not inlined, so that the loop keeps its registers; for speed a loop for each use.
template <CellUse use, class Rule, class Value>
[[gnu::noinline]] std::int32_t passing_pixels(Rule rule, typename Rule::Cell* cells, Value& z, Value step,
                                              std::int32_t& first, std::int32_t count, typename Rule::Cell* codes) {
  return passing_pixels(use, rule, cells, z, step, first, count, codes);
}

/// Draws a span of one triangle.
template <Effects effects, class DepthPlane, class Rule>
void fill_fragments(const Span<typename Rule::Cell>& span, const DepthPlane& depth, const Rule& rule,
                    FragmentRun<effects>& run, Statistics* counters) {
  constexpr bool kDiscards = effects.has(effect::alpha_test);
  if constexpr (effects.has(effect::statistics)) ++counters->work[WorkKind::spans];
  auto z = depth.at(span.columns, span.rows);
  run.begin_span(span.columns, span.rows);
  // As in fill_textured, runs are counted from the left end of the whole span, so that they do not depend on the strip.
  std::int32_t before = span.skipped & (kPerspectiveRun - 1);
  std::int32_t column = span.columns - before;
  std::int32_t left = span.whole_length - span.skipped + before;
  std::int32_t to_draw = span.length;
  auto* cell = span.depth;
  std::uint16_t* pixel = span.colour;
  const CellUse use = run.discards() ? CellUse::later : run.blends() ? CellUse::kept : CellUse::written;
  const auto passing = [&](std::int32_t& first, std::int32_t count, typename Rule::Cell* codes) {
    const auto step = depth.step_x;
    if constexpr (kForSize) return passing_pixels(use, rule, cell, z, step, first, count, codes);
    if (kDiscards && use == CellUse::later) {
      return passing_pixels<CellUse::later>(rule, cell, z, step, first, count, codes);
    }
    if (effects.has(effect::blending) && use == CellUse::kept) {
      return passing_pixels<CellUse::kept>(rule, cell, z, step, first, count, codes);
    }
    return passing_pixels<CellUse::written>(rule, cell, z, step, first, count, codes);
  };
  FragmentPoint from = point_at(run.planes, column, span.rows);
  for (;;) {
    // A full run ends at the first pixel of the next run, the last run at its own last pixel, both inside the triangle.
    const std::int32_t length = std::min(left, kPerspectiveRun);
    const FragmentPoint to =
        left > 1 ? point_at(run.planes, column + (left > kPerspectiveRun ? length : length - 1), span.rows) : from;
    run.set_ends(from, to, left, before);
    run.columns = column + before;
    const std::int32_t tested = std::min(length - before, to_draw);
    typename Rule::Cell codes[kDiscards ? kPerspectiveRun : 1];
    std::int32_t moved = 0;
    for (std::int32_t first = 0; first < tested;) {
      const std::int32_t end = passing(first, tested, codes);
      if (end == first) break;
      if (first != moved) run.move(first - moved);
      moved = first;
      run.count = end - first;
      draw_fragment_run<effects>(run, rule, codes + first, cell + first, pixel + first, counters);
      first = end + 1;  // the pixel at the end failed
    }
    to_draw -= tested;
    if (to_draw == 0) break;
    run.move(tested - moved);
    cell += tested;
    pixel += tested;
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
  const SpanTriangle<kMode, TrianglePlanes> triangle(target, v0, v1, v2);
  const RasterVertex* const vertices[3] = {&v0, &v1, &v2};
  FragmentPlanes<effects> planes(triangle.setup, vertices, surface, target);
  if constexpr (effects.has(effect::dithered_colours)) {
    planes.dither = {triangle.anchor_x - target.view_left, triangle.anchor_y - target.view_top, target.dithered};
  }
  if constexpr (effects.has(effect::statistics)) {
    if (planes.textured) ++target.statistics->work[WorkKind::staged_textures];
  }
  FragmentRun<effects> run(planes, target);
  triangle.template walk<effects.has(effect::statistics), true>(
      target, v0, v1, v2, narrow, [&](const auto& span, const auto& z, const auto& rule) {
        fill_fragments<effects>(span, z, rule, run, target.statistics);
      });
}

}  // namespace zstrip::detail
