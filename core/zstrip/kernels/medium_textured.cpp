// Draws a medium textured triangle: planes in words of 32 bits, then its rows, one run of texels each.
#include "zstrip/kernels/medium_textured.hpp"

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "zstrip/kernels/medium_triangle.hpp"
#include "zstrip/kernels/portable/triangle_rows.hpp"
#include "zstrip/kernels/texture_coordinates.hpp"
#include "zstrip/kernels/textured_span.hpp"
#include "zstrip/kernels/thumb/medium_textured.hpp"
#include "zstrip/kernels/triangle_planes.hpp"
#include "zstrip/kernels/vector/medium_textured.hpp"
#include "zstrip/pixels/textured_scan.hpp"

namespace zstrip::detail {
namespace {

struct OfTextures;  ///< see WordPlanes

/// Sets up the planes of texture coordinates that fit words.
template <bool affine, class Planes>
[[gnu::noinline]] void set_up_coordinates(TexturedScan& textured, const Planes& planes, const MediumTexture& textures) {
  if constexpr (std::is_same_v<Planes, ThumbPlanes> && !affine) {
    planes.set_texture(textured, textures.vertices, textures.surface.depth_offset);
  } else {
    TextureCoordinates<affine>(planes, textures.vertices, textures.surface.depth_offset).start_rows(textured);
  }
}

/// Sets up all planes from the scan's area, anchor and colours. Returns false if a channel is too steep.
template <bool affine>
bool set_up_planes(TexturedScan& textured, const MediumTriangle& t, const MediumTexture& textures) {
  MediumScan& scan = textured.scan;
  if constexpr (kHasThumb2 && !affine) {
    if (!set_up_medium_thumb(scan, t.v0, t.v1, t.v2)) return false;
    set_up_texture_thumb(textured, textures.vertices, textures.surface.depth_offset);
  } else {
    WordPlanes<OfTextures> planes(t.v0, t.v1, t.v2, t.area, scan.anchor_x, scan.anchor_y);
    if constexpr (kHasThumb2) {
      if (!set_up_medium_thumb(scan, t.v0, t.v1, t.v2)) return false;
    } else {
      if (!set_medium_planes(scan, planes, t.v0, t.v1, t.v2)) return false;
    }
    set_up_coordinates<affine>(textured, planes, textures);
  }
  return true;
}

using DepthTest = DepthRule<DepthMode{}>;
template <TexelLight lit>
using Run = TexturedRun<lit, false, std::uint32_t, DepthTest>;

/// Does the work of TexturedRun::fill for rows of a few pixels, without storing the values that a next run would need.
[[gnu::always_inline]] inline void fill_smooth(const Run<TexelLight::smooth>& run, const MediumScan& scan,
                                               std::uint16_t* depth, std::uint16_t* pixel, std::int32_t length) {
  std::uint32_t z = run.z, u = run.u, v = run.v, r = run.r, g = run.g, b = run.b;
  for (;;) {
    if (run.rule.draws(z, *depth)) {
      *pixel = modulated(run.texels[((v >> run.to_row) & run.row_mask) + (u >> run.to_column)], r, g, b);
    }
    if (--length == 0) return;
    ++depth, ++pixel;
    z += run.step_z, u += run.step_u, v += run.step_v;
    r += scan.step_x[MediumScan::red], g += scan.step_x[MediumScan::green], b += scan.step_x[MediumScan::blue];
  }
}

/// Inlined, so that a processor with enough registers keeps them across the division.
template <bool affine>
[[gnu::always_inline]] inline TexelPosition position_at(const TexturedScan& textured, std::int32_t column) {
  using Coordinates = TextureCoordinates<affine>;
  typename Coordinates::Place place{textured.at(TexturedScan::u_over_w, column),
                                    textured.at(TexturedScan::v_over_w, column), 0};
  if constexpr (!affine) place.one_over_w = textured.at(TexturedScan::one_over_w, column);
  return Coordinates::position(place, textured.base_u, textured.base_v, textured.right_shift);
}

/// Draws `length` > 0 pixels of the next row, from `column` on, counted from the anchor's column.
template <TexelLight lit, bool affine>
void draw_row(const TexturedScan& textured, Run<lit>& run, std::int32_t column, std::int32_t length) {
  const TexelPosition from = position_at<affine>(textured, column);
  run.u = static_cast<std::uint32_t>(from.u) * textured.to_fraction_u;
  run.v = static_cast<std::uint32_t>(from.v) * textured.to_fraction_v;
  if (length > 1) {
    const TexelPosition to = position_at<affine>(textured, column + length - 1);
    const auto pixels = static_cast<std::uint32_t>(length - 1);
    run.step_u = step_of_run(from.u, to.u, pixels) * textured.to_fraction_u;
    run.step_v = step_of_run(from.v, to.v, pixels) * textured.to_fraction_v;
  }
#if ZSTRIP_HAS_VECTORS
  if constexpr (lit == TexelLight::smooth) return fill_smooth_vector(run, textured, column, length);
#endif
  const MediumScan& scan = textured.scan;
  run.z = textured.at(MediumScan::depth, column);
  std::uint16_t* const depth = scan.rows.depth_row + column;
  std::uint16_t* const pixel = scan.rows.colour_row + column;
  if constexpr (lit == TexelLight::smooth) {
    run.r = textured.at(MediumScan::red, column);
    run.g = textured.at(MediumScan::green, column);
    run.b = textured.at(MediumScan::blue, column);
    fill_smooth(run, scan, depth, pixel, length);
  } else {
    fill_run(run, knows_texture(run), depth, pixel, length, ColourPlanes{}, nullptr);
  }
}

/// Draws `count` > 0 rows. Not inlined: it needs all registers.
template <TexelLight lit, bool affine>
[[gnu::noinline]] void scan_textured_rows(TexturedScan& textured, Run<lit>& run, std::int32_t count) {
  MediumScan& scan = textured.scan;
  do {
    const std::int32_t column = scan.rows.left.pixel, length = scan.rows.right.pixel - column;
    if (length > 0) draw_row<lit, affine>(textured, run, column, length);
    scan.rows.go_down();
    ++textured.row;
  } while (--count != 0);
}

struct RowsLeft : TriangleRows {
  MediumRows& edges;
  std::int32_t count;  ///< remaining rows of the current part, from `row` on

  explicit RowsLeft(MediumRows& of_scan) : edges(of_scan) {}

  /// Returns false if the triangle must be left to its spans.
  [[gnu::noinline]] bool begin(const MediumTriangle& t) {
    bound(t);
    if (right - anchor_x > kPerspectiveRun || !lies_in(t.target.area)) return false;
    count = 0;
    if (find_rows(t)) begin_first(edges, t), count = middle - row;
    return true;
  }

  /// Returns true if rows remain. Goes to the second part after the first one.
  bool has_more(const MediumTriangle& t) {
    if (row >= end) return false;
    if (count <= 0) begin_second(edges, t), count = end - row;
    return true;
  }

  /// Goes down to the next row with pixels. Returns false if there is none.
  bool has_pixels(const MediumTriangle& t) {
    while (has_more(t)) {
      for (; count != 0; ++row, --count) {
        if (edges.left.pixel < edges.right.pixel) return true;
        edges.go_down();
      }
    }
    return false;
  }
};

enum class Prepared : std::uint8_t { nothing, rows, left_to_spans };

/// The set-up for all kinds of light, so that its code exists once.
template <bool affine>
[[gnu::noinline]] Prepared begin_textured(TexturedScan& textured, RowsLeft& rows, LitWordRunState& run, TexelLight lit,
                                          const MediumTriangle& t, const MediumTexture& textures) {
  if (!rows.begin(t)) return Prepared::left_to_spans;
  // Tests for pixels first: planes are most of the work, and many triangles cover no pixel.
  if (!rows.has_pixels(t)) return Prepared::nothing;
  if (!fits_words(t, rows.width, rows.height) ||
      !TextureCoordinates<affine>::fits_words(textures.vertices, textures.surface.depth_offset,
                                              textures.surface.has_far_coordinates)) {
    return Prepared::left_to_spans;
  }
  MediumScan& scan = textured.scan;
  scan.area = t.area, scan.anchor_x = rows.anchor_x, scan.anchor_y = rows.anchor_y;
  scan.has_channels = lit == TexelLight::smooth;
  if (scan.has_channels) scan.set_colours(textures.colours);
  if (!set_up_planes<affine>(textured, t, textures)) return Prepared::left_to_spans;
  textured.row = rows.row - rows.anchor_y;
  textured.to_fraction_u = TextureAxis(textures.surface.texture.log2_width).to_fraction;
  textured.to_fraction_v = TextureAxis(textures.surface.texture.log2_height).to_fraction;
  run.set_texture(textures.surface.texture);
  run.step_z = scan.step_x[MediumScan::depth];
  if (lit == TexelLight::flat) {
    const Colour& light = *textures.colours[0];
    run.r = light_factor(static_cast<std::uint32_t>(channel_start(light.r)));
    run.g = light_factor(static_cast<std::uint32_t>(channel_start(light.g)));
    run.b = light_factor(static_cast<std::uint32_t>(channel_start(light.b)));
  }
  return Prepared::rows;
}

}  // namespace

template <TexelLight lit, bool affine>
bool draw_medium_textured(const MediumTriangle& t, const MediumTexture& textures) {
  TexturedScan textured;
  RowsLeft rows(textured.scan.rows);
  Run<lit> run;
  const Prepared prepared = begin_textured<affine>(textured, rows, run, lit, t, textures);
  if (prepared != Prepared::rows) return prepared == Prepared::nothing;
  do {
    if constexpr (kHasThumb && lit == TexelLight::smooth && !affine) {
      scan_textured_rows_thumb(textured, run, rows.count, kInverse);
    } else {
      scan_textured_rows<lit, affine>(textured, run, rows.count);
    }
    rows.row += rows.count, rows.count = 0;
  } while (rows.has_more(t));
  return true;
}

template bool draw_medium_textured<TexelLight::none, false>(const MediumTriangle&, const MediumTexture&);
template bool draw_medium_textured<TexelLight::none, true>(const MediumTriangle&, const MediumTexture&);
template bool draw_medium_textured<TexelLight::flat, false>(const MediumTriangle&, const MediumTexture&);
template bool draw_medium_textured<TexelLight::flat, true>(const MediumTriangle&, const MediumTexture&);
template bool draw_medium_textured<TexelLight::smooth, false>(const MediumTriangle&, const MediumTexture&);
template bool draw_medium_textured<TexelLight::smooth, true>(const MediumTriangle&, const MediumTexture&);

}  // namespace zstrip::detail
