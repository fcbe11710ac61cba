// Single triangles in every depth format, and the verdict on their depth: within one code of the exact plane, and never
// outside the corners' codes. The conversions to codes are written here once more, from their definitions, in real
// numbers; only coverage comes from the pixels' own oracle.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "raster_judge.hpp"
#include "triangle_oracle.hpp"

namespace depth_judge {

using namespace zstrip;
using namespace zstrip::detail;

/// near / w of a vertex at near.
constexpr long double kMaxNearOverW = 4294967296.0L - 393216.0L;

/// A depth as vertices have it (1/2^32 of all codes, or near / w in 0.32) to a code as a real number, so that a pixel's
/// code is right within 1 of it.
template <DepthFormat format>
long double exact_code(long double depth) {
  switch (format) {
    case DepthFormat::z16: return depth / 65536 - 0.5L;  // half a code is added at the vertex
    case DepthFormat::z24: return depth / 256 - 0.5L;
    case DepthFormat::float16: {
      // Exponent 0 for depth below 2^25, else one more for each doubling; 13 bits of mantissa; rounded down.
      const long double exponent = depth < 33554432 ? 0 : std::floor(std::log2(depth)) - 24;
      const long double mantissa = exponent == 0 ? depth / 4096 : depth / std::exp2(11 + exponent) - 8192;
      return exponent * 8192 + mantissa - 0.5L;
    }
  }
  return 0;
}

/// As exact_code, of a vertex: rounded as the pixels are.
template <DepthFormat format>
long double vertex_code(std::uint32_t depth) {
  return std::floor(exact_code<format>(depth) + 0.5L);
}

template <DepthFormat format>
struct Canvas {
  using Cell = DepthCell<format>;
  std::int32_t width, height;
  std::vector<Cell> depth = std::vector<Cell>(static_cast<std::size_t>(width * height), 0);
  std::vector<std::uint16_t> colour = std::vector<std::uint16_t>(static_cast<std::size_t>(width * height), 0);

  StripTarget target() {
    return {.area = {0, 0, width, height},
            .view_left = 0,
            .view_top = 0,
            .first_column = 0,
            .first_row = 0,
            .depth = reinterpret_cast<std::uint16_t*>(depth.data()),
            .colour = colour.data(),
            .depth_stride = width,
            .colour_stride = width,
            .statistics = nullptr};
  }
};

/// Through the span rasteriser; or, of the float, through that for small triangles. False if it would not take it.
template <DepthFormat format>
bool draw(Canvas<format>& canvas, const raster_judge::Corners& c, bool small) {
  if (!small) {
    RasterVertex v[3] = {};
    for (std::size_t i = 0; i < 3; ++i) v[i] = {c[i].x + kCentreBias, c[i].y + kCentreBias, c[i].depth, 0, 0, 0, 0, 0};
    Surface surface{};
    surface.flat_colour = 0xFFFF;
    draw_span_triangle<Shade::flat, false, false, DepthMode{format}>(canvas.target(), v[0], v[1], v[2], surface,
                                                                     canvas.width <= 1024);
    return true;
  } else if constexpr (format == DepthFormat::float16) {
    const std::uint32_t octave = float16_octave(c[0].depth);
    SnappedVertex v[3];
    for (std::size_t i = 0; i < 3; ++i) {
      if (float16_octave(c[i].depth) != octave) return false;
      v[i] = raster_judge::snapped(c[i]);
      v[i].depth = static_cast<std::uint32_t>(float16_depth(c[i].depth, octave));
    }
    const auto [min_x, max_x] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [min_y, max_y] = std::minmax({v[0].y, v[1].y, v[2].y});
    if (!is_small(max_x - min_x, max_y - min_y, v[0], v[1], v[2])) return false;
    const Rect box{std::max(min_x >> 4, 0), std::max(min_y >> 4, 0), std::min(max_x >> 4, canvas.width),
                   std::min(max_y >> 4, canvas.height)};
    if (box.empty()) return true;
    const Colour* const colours[3] = {nullptr, nullptr, nullptr};
    draw_small_triangle<false, false>(canvas.target(), v[0], v[1], v[2], colours, 0xFFFF,
                                      static_cast<std::int32_t>(raster_judge::area_of(c)), min_x >> 4, min_y >> 4, box);
    return true;
  } else {
    return false;
  }
}

/// Empty if all of it holds, else the first violation in words. The canvas was empty before. `worst` is raised to the
/// largest difference, in codes.
template <DepthFormat format>
std::string verdict(const Canvas<format>& canvas, const raster_judge::Corners& c, long double* worst = nullptr) {
  const oracle::Triangle exact({{{c[0].x, c[0].y}, {c[1].x, c[1].y}, {c[2].x, c[2].y}}});
  long double lowest = 0xFFFFFFFF, highest = 0;
  for (const raster_judge::Corner& v : c) {
    lowest = std::min(lowest, vertex_code<format>(v.depth));
    highest = std::max(highest, vertex_code<format>(v.depth));
  }
  for (std::int32_t y = 0; y < canvas.height; ++y) {
    for (std::int32_t x = 0; x < canvas.width; ++x) {
      const auto cell = canvas.depth[static_cast<std::size_t>(y * canvas.width + x)];
      const auto violation = [&](const char* what) {
        return std::string(what) + " of " + raster_judge::words(c) + "at " + std::to_string(x) + "," +
               std::to_string(y) + ": " + std::to_string(cell);
      };
      if ((cell != 0) != exact.covers(x, y)) return violation("coverage");
      if (cell == 0) continue;
      if (cell < lowest || cell > highest) return violation("depth range");
      const oracle::Wide value = exact.value_times_area(x, y, {c[0].depth, c[1].depth, c[2].depth});
      const long double code =
          exact_code<format>(static_cast<long double>(value) / static_cast<long double>(exact.area()));
      const long double error = std::abs(cell - code);
      if (worst != nullptr) *worst = std::max(*worst, error);
      if (error > 1) return violation("depth");
    }
  }
  return {};
}

}  // namespace depth_judge
