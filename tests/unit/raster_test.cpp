// Both rasterisers against the exact oracle: coverage, depth, colour; random, tiny, huge and degenerate triangles.
#include <gtest/gtest.h>

#include <random>
#include "raster_judge.hpp"

namespace {

using namespace raster_judge;

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
    ASSERT_EQ(verdict(canvas, c), "");
  }
  EXPECT_GT(small, 3000);
}

TEST(Raster, NarrowSpansMatchTheOracle) {
  RandomTriangles triangles(2);
  for (int i = 0; i < 3000; ++i) {
    const Corners c = triangles.next(100, triangles.between(1, 1500), 65000);
    Canvas canvas;
    draw_spans(canvas, c, true);
    ASSERT_EQ(verdict(canvas, c), "");
  }
}

TEST(Raster, HugeNarrowTrianglesMatchTheOracle) {
  RandomTriangles triangles(3);
  for (int i = 0; i < 2000; ++i) {
    const Corners c = triangles.next(20, 14000, 65000);
    Canvas canvas;
    draw_spans(canvas, c, true);
    ASSERT_EQ(verdict(canvas, c), "");
  }
}

TEST(Raster, WideTrianglesMatchTheOracle) {
  RandomTriangles triangles(4);
  for (int i = 0; i < 2000; ++i) {
    const Corners c = triangles.next(20, (1 << triangles.between(12, 22)) - 2000, 65000);
    Canvas canvas;
    draw_spans(canvas, c, false);
    ASSERT_EQ(verdict(canvas, c), "");
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
    ASSERT_EQ(verdict(narrow, c), "");
    Canvas small;
    if (draw_small(small, c)) {
      ASSERT_EQ(verdict(small, c), "");
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

// Regression: a depth difference close to the whole range wrapped and passed for a small one.
TEST(Raster, SmallTrianglesHaveNoDepthDifferenceThatWraps) {
  const Corners c{
      {{102, 585, 65000U << 16 | 0x2000, {}}, {35, 473, 1U << 16 | 0x2000, {}}, {34, 474, 65000U << 16 | 0x2000, {}}}};
  ASSERT_GT(area_of(c), 0);
  Canvas canvas;
  EXPECT_FALSE(draw_small(canvas, c));
  draw_spans(canvas, c, true);
  EXPECT_EQ(verdict(canvas, c), "");
}

}  // namespace
