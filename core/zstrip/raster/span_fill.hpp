// The pixel loops of the span rasteriser: one for each kind of shading.
#pragma once

#include <cstdint>

#include "zstrip/raster/colour.hpp"
#include "zstrip/raster/plane.hpp"
#include "zstrip/raster/target.hpp"
#include "zstrip/raster/texture_coordinates.hpp"

namespace zstrip::detail {

/// A run of pixels in one row. `columns`, `rows` are relative to the anchor of the triangle's planes.
struct Span {
  std::uint16_t* depth;
  std::uint16_t* colour;
  std::int32_t length;  ///< > 0
  std::int32_t columns, rows;
};

template <bool statistics>
inline void count_pass(Statistics* counters) {
  if constexpr (statistics) ++counters->depth_passes;
}

template <bool statistics>
void fill_flat(const Span& span, const Plane& depth, std::uint16_t colour, Statistics* counters) {
  std::uint32_t z = depth.at(span.columns, span.rows);
  for (std::int32_t i = 0; i < span.length; ++i) {
    const auto code = static_cast<std::uint16_t>(z >> 16);
    if (code > span.depth[i]) {
      span.depth[i] = code;
      span.colour[i] = colour;
      count_pass<statistics>(counters);
    }
    z += depth.step_x;
  }
}

struct ColourPlanes {
  Plane r, g, b;  ///< 8.16
};

template <bool statistics>
void fill_gouraud(const Span& span, const Plane& depth, const ColourPlanes& planes, Statistics* counters) {
  std::uint32_t z = depth.at(span.columns, span.rows);
  std::uint32_t r = planes.r.at(span.columns, span.rows);
  std::uint32_t g = planes.g.at(span.columns, span.rows);
  std::uint32_t b = planes.b.at(span.columns, span.rows);
  for (std::int32_t i = 0; i < span.length; ++i) {
    const auto code = static_cast<std::uint16_t>(z >> 16);
    if (code > span.depth[i]) {
      span.depth[i] = code;
      span.colour[i] = rgb565(r, g, b);
      count_pass<statistics>(counters);
    }
    z += depth.step_x;
    r += planes.r.step_x;
    g += planes.g.step_x;
    b += planes.b.step_x;
  }
}

/// Pixels between two exact texture positions.
inline constexpr std::int32_t kPerspectiveRun = 16;

/// 2^16 / n, for the last, shorter run of a span.
inline constexpr std::uint32_t kInverse[kPerspectiveRun] = {0,    65536, 32768, 21845, 16384, 13107, 10922, 9362,
                                                            8192, 7281,  6553,  5957,  5461,  5041,  4681,  4369};

/// `light` is read only where `lit`.
template <bool orthographic, bool lit, bool statistics>
void fill_textured(const Span& span, const Plane& depth, const TextureView& texture,
                   const TextureCoordinates<orthographic>& coordinates, const ColourPlanes& light,
                   Statistics* counters) {
  // Positions as fractions of the texture in 0.32: wrapping is what unsigned integers do.
  const int to_fraction_u = 16 - texture.log2_width;
  const int to_fraction_v = 16 - texture.log2_height;
  const int column_shift = 32 - texture.log2_width;
  const int row_shift = 32 - texture.log2_height;
  std::uint32_t z = depth.at(span.columns, span.rows);
  std::uint32_t r = 0, g = 0, b = 0;
  if constexpr (lit) {
    r = light.r.at(span.columns, span.rows);
    g = light.g.at(span.columns, span.rows);
    b = light.b.at(span.columns, span.rows);
  }
  std::uint16_t* depth_cell = span.depth;
  std::uint16_t* pixel = span.colour;
  TexelPosition from = coordinates.at(span.columns, span.rows);
  for (std::int32_t done = 0; done < span.length;) {
    const std::int32_t left = span.length - done;
    // A full run ends at the next one's first pixel, the last run at its own last pixel: always inside the triangle.
    const std::int32_t run = left > kPerspectiveRun ? kPerspectiveRun : left;
    TexelPosition to = from;
    std::int32_t step_u = 0, step_v = 0;  // 16.16
    const auto difference = [](std::int32_t a, std::int32_t b_) {
      return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b_));
    };
    if (left > kPerspectiveRun) {
      to = coordinates.at(span.columns + done + run, span.rows);
      step_u = difference(to.u, from.u) >> 4;
      step_v = difference(to.v, from.v) >> 4;
    } else if (left > 1) {
      to = coordinates.at(span.columns + done + run - 1, span.rows);
      const auto inverse = static_cast<std::int64_t>(kInverse[run - 1]);
      step_u = static_cast<std::int32_t>((difference(to.u, from.u) * inverse) >> 16);
      step_v = static_cast<std::int32_t>((difference(to.v, from.v) * inverse) >> 16);
    }
    std::uint32_t u = static_cast<std::uint32_t>(from.u) << to_fraction_u;
    std::uint32_t v = static_cast<std::uint32_t>(from.v) << to_fraction_v;
    const std::uint32_t du = static_cast<std::uint32_t>(step_u) << to_fraction_u;
    const std::uint32_t dv = static_cast<std::uint32_t>(step_v) << to_fraction_v;
    for (std::int32_t i = 0; i < run; ++i) {
      const auto code = static_cast<std::uint16_t>(z >> 16);
      if (code > depth_cell[i]) {
        depth_cell[i] = code;
        // 64-bit shifts are not needed: a side of one texel has shift 32, which the mask below stands for.
        const std::uint32_t column = texture.log2_width == 0 ? 0 : u >> column_shift;
        const std::uint32_t texel_row = texture.log2_height == 0 ? 0 : v >> row_shift;
        const std::uint16_t texel = texture.texels[(texel_row << texture.log2_width) + column];
        if constexpr (lit) {
          pixel[i] = modulated(texel, r, g, b);
        } else {
          pixel[i] = texel;
        }
        count_pass<statistics>(counters);
      }
      z += depth.step_x;
      u += du;
      v += dv;
      if constexpr (lit) {
        r += light.r.step_x;
        g += light.g.step_x;
        b += light.b.step_x;
      }
    }
    depth_cell += run;
    pixel += run;
    done += run;
    from = to;
  }
}

}  // namespace zstrip::detail
