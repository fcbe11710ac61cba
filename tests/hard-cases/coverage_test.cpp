// Hard cases A: which pixels a triangle covers.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "generators.hpp"
#include "lattice.hpp"
#include "space.hpp"

namespace hard_cases {
namespace {

/// A convex quadrilateral a, b, c, d, clockwise on the screen, whose corners lie on the lattice.
std::array<oracle::Point, 4> convex_quadrilateral(int extent, int beyond) {
  for (;;) {
    const oracle::Point centre = any_point(beyond);
    std::array<oracle::Point, 4> q{point_near(centre, extent), point_near(centre, extent), point_near(centre, extent),
                                   point_near(centre, extent)};
    bool convex = true;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto &a = q[i], &b = q[(i + 1) % 4], &c = q[(i + 2) % 4];
      convex &= (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
    }
    if (convex) return q;
    RC_PRE(between(0, 63) != 0);
  }
}

RC_GTEST_PROP(HardCases, A01_SharedEdge, ()) {
  const int extent = between(1, 600);
  const oracle::Point a = any_point(200), b = point_near(a, extent);
  const std::vector<Corners2> pair{{a, b, point_near(a, extent)}, {b, a, point_near(b, extent)}};
  RC_ASSERT(coverage_verdict(pair) == "");
}

RC_GTEST_PROP(HardCases, A01_EitherDiagonalOfAQuadrilateralGivesTheSamePixels, ()) {
  const auto q = convex_quadrilateral(between(2, 500), 100);
  const std::vector<int> one = exact_cover({{q[0], q[1], q[2]}, {q[0], q[2], q[3]}});
  const std::vector<int> other = exact_cover({{q[0], q[1], q[3]}, {q[1], q[2], q[3]}});
  RC_ASSERT(one == other);  // of the oracle itself
  RC_ASSERT(coverage_verdict({{q[0], q[1], q[2]}, {q[0], q[2], q[3]}}) == "");
  RC_ASSERT(coverage_verdict({{q[0], q[1], q[3]}, {q[1], q[2], q[3]}}) == "");
}

RC_GTEST_PROP(HardCases, A02_SharedEdgeSecondWindingReversed, ()) {
  const auto q = convex_quadrilateral(between(2, 500), 100);
  RC_ASSERT(coverage_verdict({{q[0], q[1], q[2]}, {q[0], q[3], q[2]}}) == "");
}

TEST(HardCases, A03_QuadRotatedThroughAQuarterTurn) {
  for (int angle = 0; angle <= 900; ++angle) {
    const double a = angle * M_PI / 1800;
    const auto corner = [&](double x, double y) {
      return oracle::Point{std::lround(48 * 16 + 350 * (x * std::cos(a) - y * std::sin(a))),
                           std::lround(32 * 16 + 350 * (x * std::sin(a) + y * std::cos(a)))};
    };
    const std::array<oracle::Point, 4> q{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
    ASSERT_EQ(coverage_verdict({{q[0], q[1], q[2]}, {q[0], q[2], q[3]}}), "") << angle << " tenths of a degree";
  }
}

// Two triangles on one edge, at distances of 0.1 to 4: alone and together they cover the same pixels, and none twice
// where their other corners lie on opposite sides of the edge.
RC_GTEST_PROP(HardCases, A04_SharedEdgeInPerspective, ()) {
  Space space(2 * kFixedOne, 2 * kFixedOne + 6554);
  space.camera.near_plane = 655;
  space.camera.far_plane = 8 * kFixedOne;
  for (int i = 0; i < 4; ++i) {
    const int z = between(-32000, 31000);
    const int reach = (33000 - z) / 4;
    space.model.positions.push_back({static_cast<std::int16_t>(between(-reach, reach)),
                                     static_cast<std::int16_t>(between(-reach, reach)), static_cast<std::int16_t>(z)});
    space.model.colours.push_back(kWhite);
  }
  const auto draw = [&](std::vector<Triangle> triangles) {
    space.model.triangles = std::move(triangles);
    return space.draw();
  };
  const Picture left = draw({{0, 1, 2}}), right = draw({{1, 0, 3}}), both = draw({{0, 1, 2}, {1, 0, 3}});
  RC_ASSERT(both.status);
  const std::vector<bool> in_left = mask_of(left), in_right = mask_of(right), in_both = mask_of(both);
  for (std::size_t i = 0; i < in_both.size(); ++i) RC_ASSERT(in_both[i] == (in_left[i] || in_right[i]));
  RC_ASSERT(both.statistics.fragments == left.statistics.fragments + right.statistics.fragments);

  std::array<std::array<long double, 2>, 4> on_screen;
  for (std::size_t i = 0; i < 4; ++i) {
    const oracle::Homogeneous h = space.homogeneous(space.model.positions[i]);
    on_screen[i] = {h.x / h.w, h.y / h.w};
  }
  const long double dx = on_screen[1][0] - on_screen[0][0], dy = on_screen[1][1] - on_screen[0][1];
  const auto distance = [&](std::size_t i) {
    return (dx * (on_screen[i][1] - on_screen[0][1]) - dy * (on_screen[i][0] - on_screen[0][0])) / std::hypot(dx, dy);
  };
  // A corner within a pixel of the line may be on either side once it is snapped.
  if (!(distance(2) * distance(3) < 0 && std::abs(distance(2)) > 1 && std::abs(distance(3)) > 1)) return;
  for (std::size_t i = 0; i < in_both.size(); ++i) RC_ASSERT(!(in_left[i] && in_right[i]));
}

TEST(HardCases, A05_QuadClippedPartlyAndCoveringEverything) {
  for (int size : {1, 15, 16, 17, 300, 1000, 3000, 16000}) {
    for (int at = -size; at <= kView.width * 16; at += 37 + size / 8) {
      const oracle::Point p{at, at / 2 - 100}, q{at + size, at / 2 - 100 + size};
      ASSERT_EQ(coverage_verdict({{p, {q.x, p.y}, q}, {p, q, {p.x, q.y}}}), "");
    }
  }
  const oracle::Point p{0, 0}, q{kView.width * 16, kView.height * 16};
  const std::vector<int> cover = exact_cover({{p, {q.x, p.y}, q}, {p, q, {p.x, q.y}}});
  EXPECT_EQ(std::ranges::count(cover, 1), kPixels);
  EXPECT_EQ(coverage_verdict({{p, {q.x, p.y}, q}, {p, q, {p.x, q.y}}}), "");
}

/// Triangles around `centre`, from each rim point to the next.
std::vector<Corners2> fan(const oracle::Point& centre, const std::vector<oracle::Point>& rim) {
  std::vector<Corners2> triangles;
  for (std::size_t i = 0; i < rim.size(); ++i) triangles.push_back({centre, rim[i], rim[(i + 1) % rim.size()]});
  return triangles;
}

TEST(HardCases, A06_SampleExactlyOnAVertex) {
  const oracle::Point centre{40 * 16 + 8, 30 * 16 + 8};
  for (int dx = -40; dx <= 40; dx += 4) {
    for (int dy = -40; dy <= 40; dy += 4) {
      // Four triangles around the centre; it belongs to exactly one.
      const std::vector<oracle::Point> rim{{centre.x + 64, centre.y + dy},
                                           {centre.x + dx, centre.y + 64},
                                           {centre.x - 64, centre.y - dy},
                                           {centre.x - dx, centre.y - 64}};
      const std::vector<Corners2> triangles = fan(centre, rim);
      ASSERT_EQ(exact_cover(triangles)[30 * 96 + 40], 1);
      ASSERT_EQ(coverage_verdict(triangles), "") << dx << ' ' << dy;
    }
  }
}

TEST(HardCases, A07_FanAroundASampleIsDrawnOnce) {
  for (int count : {3, 4, 5, 7, 16, 61, 200}) {
    for (const oracle::Point centre : {oracle::Point{648, 488}, oracle::Point{640, 480}, oracle::Point{643, 485}}) {
      std::vector<oracle::Point> rim;
      for (int i = 0; i < count; ++i) {
        const double a = 2 * M_PI * i / count;
        rim.push_back({centre.x + std::lround(400 * std::cos(a)), centre.y + std::lround(400 * std::sin(a))});
      }
      const std::vector<Corners2> triangles = fan(centre, rim);
      for (const int cover : exact_cover(triangles)) ASSERT_LE(cover, 1);
      ASSERT_EQ(coverage_verdict(triangles), "") << count;
    }
  }
}

TEST(HardCases, A08_TopEdgesBelongBottomEdgesDoNot) {
  // Edges through pixel centres: rows 10 and 20, columns 10 and 20.
  const oracle::Point p{168, 168}, q{328, 328};
  const std::vector<int> cover = exact_cover({{p, {q.x, p.y}, q}, {p, q, {p.x, q.y}}});
  EXPECT_EQ(cover[10 * 96 + 15], 1) << "top row";
  EXPECT_EQ(cover[20 * 96 + 15], 0) << "bottom row";
  EXPECT_EQ(cover[15 * 96 + 10], 1) << "left column";
  EXPECT_EQ(cover[15 * 96 + 20], 0) << "right column";
  EXPECT_EQ(coverage_verdict({{p, {q.x, p.y}, q}, {p, q, {p.x, q.y}}}), "");
}

RC_GTEST_PROP(HardCases, A08_HorizontalAndVerticalEdgesThroughCentres, ()) {
  const auto centre_line = [](int limit) { return between(-2, limit + 2) * 16 + 8; };
  const std::int64_t x0 = centre_line(96), x1 = centre_line(96), y0 = centre_line(64), y1 = centre_line(64);
  RC_ASSERT(coverage_verdict({{{{x0, y0}, {x1, y0}, {x1, y1}}}, {{{x0, y0}, {x1, y1}, {x0, y1}}}}) == "");
}

RC_GTEST_PROP(HardCases, A09_ZeroAreaFillsNothing, ()) {
  const oracle::Point a = any_point(100);
  const std::int64_t dx = between(-90, 90), dy = between(-90, 90), s = between(-9, 9), t = between(-9, 9);
  RC_ASSERT(coverage_verdict({{a, {a.x + s * dx, a.y + s * dy}, {a.x + t * dx, a.y + t * dy}}}) == "");
}

/// Positions 1/8 of a sub-pixel apart, snapped by the test: to nearest, halves up in raster coordinates.
struct FineTriangle {
  std::array<std::array<int, 2>, 3> steps;  ///< 1/128 pixels from the picture's centre, y upwards

  Corners2 snapped() const {
    Corners2 corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto nearest = [](int value) { return (value + 4) >> 3; };
      corners[i] = {nearest(steps[i][0]) + kView.width * 8, nearest(-steps[i][1]) + kView.height * 8};
    }
    return corners;
  }
  /// Positive: counter-clockwise with y upwards.
  std::int64_t turn() const {
    const auto d = [this](std::size_t i, std::size_t axis) { return std::int64_t{steps[i][axis]} - steps[0][axis]; };
    return d(1, 0) * d(2, 1) - d(1, 1) * d(2, 0);
  }
  Picture draw(bool double_sided) const {
    Lattice lattice;
    Model& model = lattice.model();
    model.mesh.half_extent = {8 * kFixedOne, 8 * kFixedOne, 8 * kFixedOne};
    model.material.double_sided = double_sided;
    for (const auto& s : steps) {
      model.positions.push_back({static_cast<std::int16_t>(s[0]), static_cast<std::int16_t>(s[1]), 0});
      model.colours.push_back(kWhite);
    }
    model.triangles = {{0, 1, 2}};
    return lattice.draw();
  }
};

void expect_cover(const Picture& picture, const std::vector<int>& exact) {
  const std::vector<bool> mask = mask_of(picture);
  for (std::size_t i = 0; i < mask.size(); ++i) RC_ASSERT(mask[i] == (exact[i] > 0));
}

RC_GTEST_PROP(HardCases, A10_CulledAfterSnapping, ()) {
  FineTriangle triangle;
  const int x = between(-5000, 5000), y = between(-3000, 3000), dx = between(-800, 800), dy = between(-800, 800);
  // Nearly collinear: about half of them change their winding or lose their area when they are snapped.
  const int t = between(0, 8);
  triangle.steps = {{{x, y}, {x + dx * t / 8 + between(-9, 9), y + dy * t / 8 + between(-9, 9)}, {x + dx, y + dy}}};
  const Corners2 snapped = triangle.snapped();
  const oracle::Triangle exact(snapped);
  RC_TAG(exact.area() == 0 ? "loses its area" : "keeps its area");
  expect_cover(triangle.draw(true), exact_cover({snapped}));
  expect_cover(triangle.draw(false), exact_cover({snapped}, true));
}

TEST(HardCases, A10_AWindingThatFlipsIsCulledAsSnapped) {
  // Before snapping counter-clockwise by a hair, afterwards clockwise.
  int flipped = 0;
  for (int x = -40; x < 40; ++x) {
    for (int y = -40; y < 40; ++y) {
      const FineTriangle triangle{{{{0, 0}, {x + 640, y + 331}, {1280, 663}}}};
      const Corners2 c = triangle.snapped();
      const std::int64_t turn = (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x);
      if ((triangle.turn() > 0) == (turn < 0) || turn == 0) continue;
      ++flipped;
      const std::vector<bool> mask = mask_of(triangle.draw(false));
      const std::vector<int> cover = exact_cover({c}, true);
      for (std::size_t i = 0; i < mask.size(); ++i) ASSERT_EQ(mask[i], cover[i] > 0) << x << ' ' << y;
    }
  }
  EXPECT_GT(flipped, 5);
}

RC_GTEST_PROP(HardCases, A11_SliversLoseNoNeighbour, ()) {
  // Two triangles and the sliver between them tile the same quadrilateral as without it.
  const oracle::Point a = any_point(), b = point_near(a, 900);
  const oracle::Point middle{(a.x + b.x) / 2 + between(-2, 2), (a.y + b.y) / 2 + between(-2, 2)};
  const oracle::Point above = point_near(a, 900), below = point_near(b, 900);
  const std::vector<Corners2> triangles{{a, middle, above}, {middle, b, above}, {a, b, middle}, {b, a, below}};
  RC_ASSERT(coverage_verdict(triangles) == "");
}

TEST(HardCases, A12_NegativeCoordinatesAreFlooredAndRoundedToNearest) {
  // The same triangle shifted by whole pixels through zero (the picture's centre) covers the same pixels, shifted.
  const Corners2 shape{{{3, 5}, {171, 37}, {60, 203}}};
  for (int shift = -70 * 16; shift <= 110 * 16; shift += 16) {
    Corners2 moved = shape;
    for (oracle::Point& p : moved) p.x += shift, p.y += shift / 2 / 16 * 16;
    ASSERT_EQ(coverage_verdict({moved}), "") << shift;
  }
  // Halves go up: 1/128 pixels, every residue on both sides of zero.
  for (int value = -64; value <= 64; ++value) {
    const FineTriangle triangle{{{{value, value}, {value + 2000, value + 3}, {value + 5, value + 2000}}}};
    const std::vector<bool> mask = mask_of(triangle.draw(true));
    const std::vector<int> cover = exact_cover({triangle.snapped()});
    for (std::size_t i = 0; i < mask.size(); ++i) ASSERT_EQ(mask[i], cover[i] > 0) << value;
  }
}

TEST(HardCases, A13_ExactlyFourSubPixelBits) {
  // A left edge moves through the centres of a column in steps of 1/128 pixel: the column appears at one step only, and
  // moves of the edge by less than half a sub-pixel change nothing.
  for (int column = 40; column < 56; ++column) {
    int changes = 0;
    bool before = true;
    for (int offset = 0; offset < 128; ++offset) {
      const int x = (column - 48) * 128 + offset;
      const FineTriangle triangle{{{{x, -2000}, {x + 2560, 0}, {x, 2000}}}};
      const bool covered = mask_of(triangle.draw(true))[static_cast<std::size_t>(32 * 96 + column)];
      // Snapped to nearest: the centre, at 64, still belongs at offsets up to 67.
      ASSERT_EQ(covered, offset < 68) << column << ' ' << offset;
      changes += covered != before;
      before = covered;
    }
    ASSERT_EQ(changes, 1);
  }
}

RC_GTEST_PROP(HardCases, A14_TJunctionHasTheSameHoleInEveryFrame, ()) {
  const oracle::Point a = any_point(), b = point_near(a, 700);
  const oracle::Point on_edge{(a.x + b.x) / 2, (a.y + b.y) / 2};
  const std::vector<Corners2> triangles{
      {a, b, point_near(a, 500)}, {b, on_edge, point_near(b, 500)}, {on_edge, a, point_near(a, 500)}};
  Lattice lattice;
  lattice.model().material.double_sided = true;
  for (const Corners2& t : triangles) lattice.add(t);
  const Picture first = lattice.draw();
  for (const std::uint16_t rows : {std::uint16_t{64}, std::uint16_t{1}, std::uint16_t{5}})
    RC_ASSERT(lattice.draw(rows).pixels == first.pixels);
  RC_ASSERT(coverage_verdict(triangles) == "");
}

TEST(HardCases, A15_QuadsTiledAtTheOrigin) {
  // Cells of every size from a quarter pixel on, around the upper left corner and around the centre of the picture.
  for (const oracle::Point origin : {oracle::Point{0, 0}, oracle::Point{48 * 16, 32 * 16}}) {
    for (int size = 4; size <= 40; ++size) {
      std::vector<Corners2> triangles;
      for (int i = -6; i < 6; ++i) {
        for (int j = -6; j < 6; ++j) {
          const oracle::Point p{origin.x + i * size, origin.y + j * size}, q{p.x + size, p.y + size};
          triangles.push_back({p, {q.x, p.y}, q});
          triangles.push_back({p, q, {p.x, q.y}});
        }
      }
      for (const int cover : exact_cover(triangles)) ASSERT_LE(cover, 1);
      ASSERT_EQ(coverage_verdict(triangles), "") << size;
    }
  }
}

RC_GTEST_PROP(HardCases, A16_TrianglesLargerThanTheScreenDoNotVanish, ()) {
  const int extent = between(1000, 32000);
  RC_ASSERT(coverage_verdict({any_triangle(extent / 2)}) == "");
}

}  // namespace
}  // namespace hard_cases
