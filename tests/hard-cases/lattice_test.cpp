// Every triangle on a lattice of 6 x 6 quarter pixels, with every triangle that shares an edge with it.
#include <gtest/gtest.h>

#include "raster_judge.hpp"

namespace hard_cases {
namespace {

constexpr int kSide = 6;
constexpr int kPoints = kSide * kSide;
constexpr int kCells = 4;  ///< pixels on a side that the lattice can reach

using raster_judge::Corner;
using raster_judge::Corners;

/// One bit a pixel, of the 4 x 4 pixels from (3, 3) on; -1 where the two rasterisers or the oracle disagree.
int covered_pixels(const Corners& c) {
  raster_judge::Canvas small, spans;
  if (!raster_judge::draw_small(small, c)) return -1;
  raster_judge::draw_spans(spans, c, true);
  const oracle::Triangle exact({{{c[0].x, c[0].y}, {c[1].x, c[1].y}, {c[2].x, c[2].y}}});
  int mask = 0;
  for (int y = 0; y < kCells; ++y) {
    for (int x = 0; x < kCells; ++x) {
      const auto i = static_cast<std::size_t>((y + 3) * raster_judge::kWidth + x + 3);
      const bool covers = exact.covers(x + 3, y + 3);
      if ((small.depth[i] != 0) != covers || (spans.depth[i] != 0) != covers) return -1;
      mask |= int{covers} << (y * kCells + x);
    }
  }
  return mask;
}

Corner lattice_point(int i) {
  return {64 + 4 * (i % kSide), 64 + 4 * (i / kSide), zstrip::snap_depth(1000U << 16), {10, 20, 30, 255}};
}

TEST(HardCases, A00_EveryPairOfTrianglesOnALatticeThatSharesAnEdge) {
  // Coverage of every triangle p, q, r, either winding; the judge has seen each by itself.
  std::vector<int> cover(kPoints * kPoints * kPoints, 0);
  const auto at = [](int p, int q, int r) { return static_cast<std::size_t>((p * kPoints + q) * kPoints + r); };
  int triangles = 0;
  for (int p = 0; p < kPoints; ++p) {
    for (int q = 0; q < kPoints; ++q) {
      for (int r = 0; r < kPoints; ++r) {
        Corners c{lattice_point(p), lattice_point(q), lattice_point(r)};
        if (raster_judge::area_of(c) == 0) continue;
        if (raster_judge::area_of(c) < 0) std::swap(c[1], c[2]);  // what the double-sided path does
        const int mask = covered_pixels(c);
        ASSERT_GE(mask, 0) << raster_judge::words(c);
        cover[at(p, q, r)] = mask;
        ++triangles;
      }
    }
  }
  // The edge p, q between r on one side and s on the other: no pixel twice. Together they are a quadrilateral; where it
  // is convex, the other diagonal gives the same pixels.
  const auto side = [](int p, int q, int r) {
    return raster_judge::area_of({lattice_point(p), lattice_point(q), lattice_point(r)});
  };
  long pairs = 0;
  for (int p = 0; p < kPoints; ++p) {
    for (int q = 0; q < kPoints; ++q) {
      for (int r = 0; r < kPoints; ++r) {
        if (side(p, q, r) <= 0) continue;
        for (int s = 0; s < kPoints; ++s) {
          if (side(p, q, s) >= 0) continue;
          const int one = cover[at(p, q, r)], other = cover[at(q, p, s)];
          ASSERT_EQ(one & other, 0) << p << ' ' << q << ' ' << r << ' ' << s;
          if (side(r, s, p) * side(r, s, q) < 0) {
            ASSERT_EQ(one | other, cover[at(r, s, p)] | cover[at(s, r, q)]) << p << ' ' << q << ' ' << r << ' ' << s;
          }
          ++pairs;
        }
      }
    }
  }
  EXPECT_GT(triangles, 40'000);
  EXPECT_GT(pairs, 200'000);
  RecordProperty("triangles", triangles);
  RecordProperty("pairs", static_cast<int>(pairs));
}

}  // namespace
}  // namespace hard_cases
