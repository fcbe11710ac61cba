// Single triangles through both rasterisers, and the verdict of the exact oracle on the pixels. What the raster tests
// and the hard cases share.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "triangle_oracle.hpp"
#include "zstrip/raster/assemble.hpp"

namespace raster_judge {

using namespace zstrip;
using namespace zstrip::detail;

constexpr std::int32_t kWidth = 96;
constexpr std::int32_t kHeight = 64;

/// A picture whose raster origin is its upper left corner.
struct Canvas {
  std::vector<std::uint16_t> depth = std::vector<std::uint16_t>(kWidth * kHeight, 0);
  std::vector<std::uint16_t> colour = std::vector<std::uint16_t>(kWidth * kHeight, 0);
  Statistics statistics{};

  StripTarget target() {
    return {.area = {0, 0, kWidth, kHeight},
            .view_left = 0,
            .view_top = 0,
            .first_column = 0,
            .first_row = 0,
            .depth = depth.data(),
            .colour = colour.data(),
            .depth_stride = kWidth,
            .colour_stride = kWidth,
            .statistics = &statistics};
  }
};

struct Corner {
  std::int32_t x, y;    // 1/16 pixels, unbiased
  std::uint32_t depth;  // 16.16, snapped
  Colour colour;
};
using Corners = std::array<Corner, 3>;

inline std::string words(const Corners& c) {
  std::ostringstream text;
  for (const Corner& v : c) text << "{" << v.x << "," << v.y << "," << v.depth << "} ";
  return text.str();
}

inline std::int64_t area_of(const Corners& c) {
  return std::int64_t{c[2].x - c[0].x} * (c[1].y - c[0].y) - std::int64_t{c[1].x - c[0].x} * (c[2].y - c[0].y);
}

inline void draw_spans(Canvas& canvas, const Corners& c, bool narrow) {
  RasterVertex v[3];
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = {c[i].x + kCentreBias,         c[i].y + kCentreBias,         c[i].depth, channel_start(c[i].colour.r),
            channel_start(c[i].colour.g), channel_start(c[i].colour.b), 0,          0};
  }
  draw_span_triangle<Shade::gouraud, false, true>(canvas.target(), v[0], v[1], v[2], Surface{}, narrow);
}

inline SnappedVertex snapped(const Corner& c) {
  return {static_cast<std::int16_t>(c.x + kCentreBias), static_cast<std::int16_t>(c.y + kCentreBias), c.depth};
}

/// False if the triangle is not small.
inline bool draw_small(Canvas& canvas, const Corners& c) {
  const SnappedVertex v[3] = {snapped(c[0]), snapped(c[1]), snapped(c[2])};
  const auto [min_x, max_x] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [min_y, max_y] = std::minmax({v[0].y, v[1].y, v[2].y});
  if (!is_small(max_x - min_x, max_y - min_y, v[0], v[1], v[2])) return false;
  const Rect box{std::max(min_x >> 4, 0), std::max(min_y >> 4, 0), std::min(max_x >> 4, kWidth),
                 std::min(max_y >> 4, kHeight)};
  if (box.empty()) return true;
  const Colour* const colours[3] = {&c[0].colour, &c[1].colour, &c[2].colour};
  draw_small_triangle<true, true>(canvas.target(), v[0], v[1], v[2], colours, 0, static_cast<std::int32_t>(area_of(c)),
                                  min_x >> 4, min_y >> 4, box);
  return true;
}

/// Coverage exact; depth within one code of the exact plane and inside the corners' codes; colour within one of 8 bits.
/// Empty if all of it holds, else the first violation in words. The canvas was empty before.
inline std::string verdict(const Canvas& canvas, const Corners& c) {
  const oracle::Triangle exact({{{c[0].x, c[0].y}, {c[1].x, c[1].y}, {c[2].x, c[2].y}}});
  const auto [lowest, highest] = std::minmax({c[0].depth >> 16, c[1].depth >> 16, c[2].depth >> 16});
  const auto violation = [&](const char* what, std::int32_t x, std::int32_t y) {
    return std::string(what) + " of " + words(c) + "at " + std::to_string(x) + "," + std::to_string(y);
  };
  for (std::int32_t y = 0; y < kHeight; ++y) {
    for (std::int32_t x = 0; x < kWidth; ++x) {
      const auto i = static_cast<std::size_t>(y * kWidth + x);
      if ((canvas.depth[i] != 0) != exact.covers(x, y)) return violation("coverage", x, y);
      if (canvas.depth[i] == 0) continue;
      if (canvas.depth[i] < lowest || canvas.depth[i] > highest) return violation("depth range", x, y);
      // The half code that vertices carry for rounding is taken out again.
      const auto z = [&](std::size_t k) { return std::int64_t{c[k].depth} - 0x8000; };
      const oracle::Wide depth_error =
          (oracle::Wide{canvas.depth[i]} << 16) * exact.area() - exact.value_times_area(x, y, {z(0), z(1), z(2)});
      if (depth_error > 65536 * exact.area() || -depth_error > 65536 * exact.area()) return violation("depth", x, y);
      // 565 keeps the upper 5 or 6 bits of the 8-bit value: the value lies in [shown, shown + 8) or + 4, give or
      // take 1.
      const auto in_cell = [&](std::int64_t shown, std::int64_t cell, std::array<std::int64_t, 3> values) {
        const oracle::Wide value = exact.value_times_area(x, y, values);
        return value >= (oracle::Wide{shown} - 1) * exact.area() &&
               value <= (oracle::Wide{shown} + cell + 1) * exact.area();
      };
      const std::uint16_t pixel = canvas.colour[i];
      if (!in_cell((pixel >> 11) << 3, 8, {c[0].colour.r, c[1].colour.r, c[2].colour.r}) ||
          !in_cell(((pixel >> 5) & 63) << 2, 4, {c[0].colour.g, c[1].colour.g, c[2].colour.g}) ||
          !in_cell((pixel & 31) << 3, 8, {c[0].colour.b, c[1].colour.b, c[2].colour.b})) {
        return violation("colour", x, y);
      }
    }
  }
  return {};
}

}  // namespace raster_judge
