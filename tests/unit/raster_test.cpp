// Both rasterisers against the exact oracle: coverage, depth, colour; random, tiny, huge and degenerate triangles.
#include <gtest/gtest.h>

#include <random>
#include <sstream>
#include <vector>

#include "triangle_oracle.hpp"
#include "zstrip/raster/assemble.hpp"

namespace {

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

std::string words(const Corners& c) {
  std::ostringstream text;
  for (const Corner& v : c) text << "{" << v.x << "," << v.y << "," << v.depth << "} ";
  return text.str();
}

std::int64_t area_of(const Corners& c) {
  return std::int64_t{c[2].x - c[0].x} * (c[1].y - c[0].y) - std::int64_t{c[1].x - c[0].x} * (c[2].y - c[0].y);
}

void draw_spans(Canvas& canvas, const Corners& c, bool narrow) {
  RasterVertex v[3];
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = {c[i].x + kCentreBias,         c[i].y + kCentreBias,         c[i].depth, channel_start(c[i].colour.r),
            channel_start(c[i].colour.g), channel_start(c[i].colour.b), 0,          0};
  }
  draw_span_triangle<Shade::gouraud, false, true>(canvas.target(), v[0], v[1], v[2], Surface{}, narrow);
}

SnappedVertex snapped(const Corner& c) {
  return {static_cast<std::int16_t>(c.x + kCentreBias), static_cast<std::int16_t>(c.y + kCentreBias), c.depth};
}

/// False if the triangle is not small.
bool draw_small(Canvas& canvas, const Corners& c) {
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
void judge(const Canvas& canvas, const Corners& c) {
  const oracle::Triangle exact({{{c[0].x, c[0].y}, {c[1].x, c[1].y}, {c[2].x, c[2].y}}});
  const auto [lowest, highest] = std::minmax({c[0].depth >> 16, c[1].depth >> 16, c[2].depth >> 16});
  for (std::int32_t y = 0; y < kHeight; ++y) {
    for (std::int32_t x = 0; x < kWidth; ++x) {
      const auto i = static_cast<std::size_t>(y * kWidth + x);
      ASSERT_EQ(canvas.depth[i] != 0, exact.covers(x, y)) << words(c) << " at " << x << ',' << y;
      if (canvas.depth[i] == 0) continue;
      ASSERT_GE(canvas.depth[i], lowest) << words(c) << " at " << x << ',' << y;
      ASSERT_LE(canvas.depth[i], highest) << words(c) << " at " << x << ',' << y;
      const auto close = [&](std::int64_t got_times_65536, std::array<std::int64_t, 3> values, std::int64_t limit) {
        const oracle::Wide error = oracle::Wide{got_times_65536} * exact.area() - exact.value_times_area(x, y, values);
        return error <= oracle::Wide{limit} * exact.area() && -error <= oracle::Wide{limit} * exact.area();
      };
      // The half code that vertices carry for rounding is taken out again.
      const auto z = [&](std::size_t k) { return std::int64_t{c[k].depth} - 0x8000; };
      ASSERT_TRUE(close(std::int64_t{canvas.depth[i]} << 16, {z(0), z(1), z(2)}, 65536))
          << words(c) << " at " << x << ',' << y;
      // 565 keeps the upper 5 or 6 bits of the 8-bit value: the value lies in [shown, shown + 8) or + 4, give or
      // take 1.
      const auto in_cell = [&](std::int64_t shown, std::int64_t cell, std::array<std::int64_t, 3> values) {
        const oracle::Wide value = exact.value_times_area(x, y, values) * 65536;
        return value >= (oracle::Wide{shown} - 1) * 65536 * exact.area() &&
               value <= (oracle::Wide{shown} + cell + 1) * 65536 * exact.area();
      };
      const std::uint16_t pixel = canvas.colour[i];
      ASSERT_TRUE(in_cell((pixel >> 11) << 3, 8, {c[0].colour.r, c[1].colour.r, c[2].colour.r}))
          << words(c) << x << ',' << y;
      ASSERT_TRUE(in_cell(((pixel >> 5) & 63) << 2, 4, {c[0].colour.g, c[1].colour.g, c[2].colour.g}))
          << words(c) << x << ',' << y;
      ASSERT_TRUE(in_cell((pixel & 31) << 3, 8, {c[0].colour.b, c[1].colour.b, c[2].colour.b}))
          << words(c) << x << ',' << y;
    }
  }
}

class RandomTriangles {
 public:
  explicit RandomTriangles(unsigned seed) : random_(seed) {}

  std::int32_t between(std::int32_t low, std::int32_t high) {
    return std::uniform_int_distribution<std::int32_t>(low, high)(random_);
  }

  /// Counter-clockwise (y up), area not zero, corners within `extent` sixteenths of a random place.
  Corners next(std::int32_t place, std::int32_t extent, std::uint32_t depth_range) {
    for (;;) {
      Corners c;
      const std::int32_t cx = between(-place / 4, kWidth * 16 + place / 4);
      const std::int32_t cy = between(-place / 4, kHeight * 16 + place / 4);
      const auto base = static_cast<std::uint32_t>(between(1, 65534 - static_cast<std::int32_t>(depth_range)));
      for (Corner& v : c) {
        v.x = cx + between(-extent, extent);
        v.y = cy + between(-extent, extent);
        const auto code = base + static_cast<std::uint32_t>(between(0, static_cast<std::int32_t>(depth_range)));
        v.depth = snap_depth((code << 16) | static_cast<std::uint32_t>(between(0, 65535)));
        v.colour = {byte(), byte(), byte(), 255};
      }
      if (area_of(c) == 0) continue;
      if (area_of(c) < 0) std::swap(c[1], c[2]);
      return c;
    }
  }

 private:
  std::uint8_t byte() {
    const std::int32_t kind = between(0, 3);  // ends of the range are where things wrap
    return static_cast<std::uint8_t>(kind == 0 ? 0 : kind == 1 ? 255 : between(0, 255));
  }
  std::mt19937 random_;
};

TEST(Raster, SmallTrianglesMatchTheOracle) {
  RandomTriangles triangles(1);
  int small = 0;
  for (int i = 0; i < 6000; ++i) {
    const Corners c = triangles.next(100, triangles.between(1, 60), 4000);
    Canvas canvas;
    if (!draw_small(canvas, c)) continue;
    ++small;
    ASSERT_NO_FATAL_FAILURE(judge(canvas, c));
  }
  EXPECT_GT(small, 3000);
}

TEST(Raster, NarrowSpansMatchTheOracle) {
  RandomTriangles triangles(2);
  for (int i = 0; i < 3000; ++i) {
    const Corners c = triangles.next(100, triangles.between(1, 1500), 65000);
    Canvas canvas;
    draw_spans(canvas, c, true);
    ASSERT_NO_FATAL_FAILURE(judge(canvas, c));
  }
}

TEST(Raster, HugeNarrowTrianglesMatchTheOracle) {
  RandomTriangles triangles(3);
  for (int i = 0; i < 2000; ++i) {
    const Corners c = triangles.next(20, 14000, 65000);
    Canvas canvas;
    draw_spans(canvas, c, true);
    ASSERT_NO_FATAL_FAILURE(judge(canvas, c));
  }
}

TEST(Raster, WideTrianglesMatchTheOracle) {
  RandomTriangles triangles(4);
  for (int i = 0; i < 2000; ++i) {
    const Corners c = triangles.next(20, (1 << triangles.between(12, 22)) - 2000, 65000);
    Canvas canvas;
    draw_spans(canvas, c, false);
    ASSERT_NO_FATAL_FAILURE(judge(canvas, c));
  }
}

TEST(Raster, SliversMatchTheOracle) {
  RandomTriangles triangles(5);
  for (int i = 0; i < 4000; ++i) {
    Corners c = triangles.next(50, 700, 65000);
    // Flatten to a sliver: the third corner next to a point of the opposite edge.
    const std::int32_t t = triangles.between(0, 16);
    c[2].x = c[0].x + (c[1].x - c[0].x) * t / 16 + triangles.between(-2, 2);
    c[2].y = c[0].y + (c[1].y - c[0].y) * t / 16 + triangles.between(-2, 2);
    if (area_of(c) == 0) continue;
    if (area_of(c) < 0) std::swap(c[0], c[1]);
    Canvas narrow;
    draw_spans(narrow, c, true);
    ASSERT_NO_FATAL_FAILURE(judge(narrow, c));
    Canvas small;
    if (draw_small(small, c)) {
      ASSERT_NO_FATAL_FAILURE(judge(small, c));
    }
  }
}

TEST(Raster, NarrowAndWideGiveTheSamePixels) {
  RandomTriangles triangles(6);
  for (int i = 0; i < 2000; ++i) {
    const Corners c = triangles.next(100, 2000, 65000);
    Canvas narrow;
    Canvas wide;
    draw_spans(narrow, c, true);
    draw_spans(wide, c, false);
    ASSERT_EQ(narrow.depth, wide.depth) << words(c);
    ASSERT_EQ(narrow.colour, wide.colour) << words(c);
  }
}

// Every triangle on a lattice of 5 x 5 quarter pixels, both rasterisers, both windings through the sign of the area.
TEST(Raster, EveryTriangleOnASmallLattice) {
  constexpr int kSide = 5;
  for (int p = 0; p < kSide * kSide; ++p) {
    for (int q = 0; q < kSide * kSide; ++q) {
      for (int r = 0; r < kSide * kSide; ++r) {
        const auto corner = [](int i) {
          return Corner{64 + 4 * (i % kSide), 64 + 4 * (i / kSide), snap_depth(1000U << 16), Colour{10, 20, 30, 255}};
        };
        const Corners c{corner(p), corner(q), corner(r)};
        if (area_of(c) <= 0) continue;
        const oracle::Triangle exact({{{c[0].x, c[0].y}, {c[1].x, c[1].y}, {c[2].x, c[2].y}}});
        Canvas small;
        Canvas spans;
        ASSERT_TRUE(draw_small(small, c));
        draw_spans(spans, c, true);
        for (int y = 3; y < 7; ++y) {
          for (int x = 3; x < 7; ++x) {
            const auto i = static_cast<std::size_t>(y * kWidth + x);
            ASSERT_EQ(small.depth[i] != 0, exact.covers(x, y)) << words(c) << x << ',' << y;
            ASSERT_EQ(spans.depth[i] != 0, exact.covers(x, y)) << words(c) << x << ',' << y;
          }
        }
      }
    }
  }
}

}  // namespace
