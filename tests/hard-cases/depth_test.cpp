// Hard cases D: depth codes, their planes and what they can tell apart. The renderer's depth test is "greater"; there
// are no other comparisons and no bias in it, so cases 35, 39 and 40 have nothing to test.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "depth_picture.hpp"
#include "generators.hpp"
#include "space.hpp"

namespace hard_cases {
namespace {

using picture::DepthPicture;
using raster_judge::Canvas;

/// Through the rasteriser that the renderer would choose.
void draw(Canvas& canvas, const raster_judge::Corners& c) {
  if (!raster_judge::draw_small(canvas, c)) raster_judge::draw_spans(canvas, c, true);
}

raster_judge::Corners any_front(int lowest = 1, int highest = 65534) {
  const int extent = between(0, 1) == 0 ? between(1, 90) : between(90, 3000);
  raster_judge::Corners c = with_attributes(any_triangle(extent), lowest, highest);
  RC_PRE(raster_judge::area_of(c) > 0);
  return c;
}

RC_GTEST_PROP(HardCases, D36_TheSameTriangleTwiceIsWrittenOnce, ()) {
  const raster_judge::Corners c = any_front();
  Canvas canvas;
  draw(canvas, c);
  const Canvas once = canvas;
  draw(canvas, c);
  RC_ASSERT(canvas.depth == once.depth);
  RC_ASSERT(canvas.statistics.depth_passes == once.statistics.depth_passes);
}

RC_GTEST_PROP(HardCases, D38_ADecalOneCodeNearerPassesEverywhereOneCodeFartherNowhere, ()) {
  const raster_judge::Corners c = any_front(2, 65533);
  const auto moved = [&](std::uint32_t codes) {
    raster_judge::Corners decal = c;
    for (raster_judge::Corner& v : decal) v.depth += codes << 16;
    return decal;
  };
  Canvas canvas;
  draw(canvas, c);
  const std::uint32_t fragments = canvas.statistics.fragments;
  draw(canvas, moved(static_cast<std::uint32_t>(-1)));
  RC_ASSERT(canvas.statistics.depth_passes == fragments);
  draw(canvas, moved(1));
  RC_ASSERT(canvas.statistics.depth_passes == 2 * fragments);
}

RC_GTEST_PROP(HardCases, D41_EdgeOnTrianglesWithHugeSlopes, ()) {
  // The whole depth range over a sub-pixel or two.
  const oracle::Point a = any_point(), b = point_near(a, between(20, 1200));
  const Corners2 points{{a, b, {b.x + between(-2, 2), b.y + between(-2, 2)}}};
  raster_judge::Corners c = with_attributes(points);
  RC_PRE(raster_judge::area_of(c) > 0);
  for (raster_judge::Corner& v : c) v.depth = any_depth(between(0, 1) == 0 ? 1 : 65000);
  Canvas canvas;
  draw(canvas, c);
  RC_ASSERT(raster_judge::verdict(canvas, c) == "");
}

/// The same vertices, the other two first: equal depth and colour everywhere.
void expect_no_difference_when_rotated(Model& model, const Camera& camera) {
  model.material.smooth = true;
  const Triangle t = model.triangles[0];
  const DepthPicture first = picture::render_depth(model.scene(), camera, kView);
  RC_ASSERT(first.status);
  for (const Triangle& rotated : {Triangle{t.b, t.c, t.a}, Triangle{t.c, t.a, t.b}}) {
    model.triangles[0] = rotated;
    const DepthPicture other = picture::render_depth(model.scene(), camera, kView);
    RC_ASSERT(other.depth == first.depth);
    RC_ASSERT(other.pixels == first.pixels);
  }
}

void colour_vertices(Model& model) {
  for (Colour& colour : model.colours) colour = {any_byte(), any_byte(), any_byte(), 255};
}

RC_GTEST_PROP(HardCases, D37_RotatedVerticesGiveEqualDepth, ()) {
  Lattice lattice;
  lattice.model().material.double_sided = true;
  const auto z = [] { return between(-32767, 32767); };
  lattice.add(any_triangle(between(0, 1) == 0 ? between(1, 90) : between(90, 3000)), kWhite, {z(), z(), z()});
  colour_vertices(lattice.model());
  expect_no_difference_when_rotated(lattice.model(), lattice.camera());
}

RC_GTEST_PROP(HardCases, D37_RotatedVerticesGiveEqualDepthWhenClipped, ()) {
  Space space(4 * kFixedOne, 0);
  space.camera.near_plane = kFixedOne / 4;
  space.camera.far_plane = 7 * kFixedOne / 2;
  const auto position = [] {
    return Position{static_cast<std::int16_t>(between(-32767, 32767)),
                    static_cast<std::int16_t>(between(-32767, 32767)),
                    static_cast<std::int16_t>(between(-32767, 32767))};
  };
  space.add({position(), position(), position()});
  colour_vertices(space.model);
  expect_no_difference_when_rotated(space.model, space.camera);
}

TEST(HardCases, D42_DepthRangesReversedHalfAndZeroWide) {
  Space space(kFixedOne, 3 * kFixedOne);
  space.add({{{-20000, -20000, 0}, {20000, -20000, 0}, {0, 20000, 0}}});
  const auto with = [&](Fixed near, Fixed far) {
    space.camera.near_plane = near;
    space.camera.far_plane = far;
    return space.draw();
  };
  EXPECT_EQ(with(4 * kFixedOne, 2 * kFixedOne).status.error, Error::camera) << "reversed";
  EXPECT_EQ(with(2 * kFixedOne, 2 * kFixedOne).status.error, Error::camera) << "zero wide";
  EXPECT_EQ(with(0, kFixedOne).status.error, Error::camera);
  EXPECT_EQ(with(-kFixedOne, kFixedOne).status.error, Error::camera);
  const Picture whole = with(kFixedOne, 100 * kFixedOne);
  EXPECT_GT(whole.statistics.fragments, 100U);
  EXPECT_EQ(with(3 * kFixedOne, 100 * kFixedOne).pixels, whole.pixels) << "near exactly at the triangle";
  EXPECT_EQ(with(kFixedOne, 3 * kFixedOne).pixels, whole.pixels) << "far exactly at the triangle";
  EXPECT_EQ(with(3 * kFixedOne - 1, 3 * kFixedOne + 1).pixels, whole.pixels) << "one unit on either side";
  EXPECT_EQ(with(3 * kFixedOne + 1, 100 * kFixedOne).statistics.fragments, 0U);
}

RC_GTEST_PROP(HardCases, D43_DepthStaysWithinItsVerticesRange, ()) {
  // Of single triangles, with their corners' depths next to each other: no room for an error.
  const int code = between(1, 65533);
  const raster_judge::Corners c = any_front(code, code + between(0, 1));
  Canvas canvas;
  draw(canvas, c);
  RC_ASSERT(raster_judge::verdict(canvas, c) == "");
}

RC_GTEST_PROP(HardCases, D43_DepthIsWithinOneCodeOfThePlane, ()) {
  const raster_judge::Corners c = any_front();
  Canvas canvas;
  draw(canvas, c);
  RC_ASSERT(raster_judge::verdict(canvas, c) == "");
}

TEST(HardCases, D45_CodesAreTheDocumentedMappingForEveryRatioOfFarToNear) {
  // Facing squares at near, at far and in between, as instances of one mesh; the code of the middle one is compared
  // with 1 + 65533 (1/w - 1/far) / (1/near - 1/far).
  double worst = 0;
  for (const auto& [near, far] : {std::pair{1.0, 10.0}, std::pair{1.0, 1000.0}, std::pair{0.3, 30000.0}}) {
    for (double fraction = 0.01; fraction < 1; fraction += 0.02) {
      Model model;
      model.positions = {{-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}, {-32767, 32767, 0}};
      model.triangles = {{0, 1, 2}, {0, 2, 3}};
      model.material.lit = false;
      model.mesh.half_extent = {64 * kFixedOne, 64 * kFixedOne, 0};
      const Fixed distances[3] = {static_cast<Fixed>(std::lround(near * std::pow(far / near, fraction) * 65536)),
                                  static_cast<Fixed>(std::lround(near * 65536)),
                                  static_cast<Fixed>(std::lround(far * 65536))};
      std::array<Instance, 3> instances;
      for (std::size_t i = 0; i < 3; ++i) {
        Transform& t = instances[i].transform;
        t.m[2][3] = -distances[i];
        // The probe fills the picture; the others are beside it.
        const Fixed size = i == 0 ? std::max<Fixed>(64, distances[0] / 128) : 1;
        t.m[0][0] = t.m[1][1] = size;
        if (i > 0) t.m[0][3] = distances[i] / 32 * 31;
      }
      Scene scene = model.scene();
      scene.instances = instances;
      Camera camera;
      camera.eye = {0, 0, 0};
      camera.near_plane = static_cast<Fixed>(near * 60000);
      camera.far_plane = 32700 * kFixedOne;
      const DepthPicture drawn = picture::render_depth(scene, camera, kView);
      ASSERT_TRUE(drawn.status);
      const std::uint32_t code = drawn.depth[32 * 96 + 48];
      const double w = distances[0] / 65536.0, n = distances[1] / 65536.0, f = distances[2] / 65536.0;
      const double exact = 1 + 65533 * (1 / w - 1 / f) / (1 / n - 1 / f);
      worst = std::max(worst, std::abs(code - exact));
    }
  }
  // Half a code of rounding, the fit's margin of 2^-20 of the range, and the vertex's own rounding.
  EXPECT_LE(worst, 0.75);
  RecordProperty("worst_in_codes", std::to_string(worst));
}

TEST(HardCases, D46_PlanesThatInterpenetrateMeetWithinOnePixel) {
  // Two large triangles cross in a line; which one is seen is right more than a pixel away from it.
  for (int tilt = 1; tilt <= 12; ++tilt) {
    Space space(8 * kFixedOne, 10 * kFixedOne);
    space.camera.near_plane = kFixedOne / 10;
    const auto slope = static_cast<std::int16_t>(tilt * 2500);
    const auto down = static_cast<std::int16_t>(-slope);
    space.add({{{-32767, -30000, slope}, {32767, -30000, down}, {0, 32767, static_cast<std::int16_t>(tilt * 100)}}},
              {255, 0, 0, 255});
    space.add({{{-32767, -30000, down}, {32767, -30000, slope}, {0, 32767, static_cast<std::int16_t>(tilt * -90)}}},
              {0, 0, 255, 255});
    const Picture picture = space.draw();
    ASSERT_TRUE(picture.status);
    const oracle::SpaceTriangle red = space.exact(space.model.triangles[0], 0.5L),
                                blue = space.exact(space.model.triangles[1], 0.5L);
    int judged = 0;
    for (int y = 1; y < kView.height - 1; ++y) {
      for (int x = 1; x < kView.width - 1; ++x) {
        if (red.sees(x, y) != oracle::Verdict::inside || blue.sees(x, y) != oracle::Verdict::inside) continue;
        // The same one is nearer at all neighbours: the line is more than a pixel away.
        int red_nearer = 0;
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) red_nearer += red.distance(x + dx, y + dy) < blue.distance(x + dx, y + dy);
        }
        if (red_nearer != 0 && red_nearer != 9) continue;
        ASSERT_EQ(pixel_at(picture, x, y), red_nearer == 9 ? 0xF800 : 0x001F) << tilt << " at " << x << ',' << y;
        ++judged;
      }
    }
    EXPECT_GT(judged, 1000);
  }
}

TEST(HardCases, D47_ConstantDepthIsExactOverTheWholePicture) {
  for (const View view : {View{96, 64}, View{320, 240}, View{4096, 2}, View{3, 4096}}) {
    for (int z = -32767; z <= 32767; z += 5461) {
      Space space(kFixedOne, 3 * kFixedOne);
      space.view = view;
      const auto at = static_cast<std::int16_t>(z);
      space.add({{{-32767, -32767, at}, {32767, -32767, at}, {32767, 32767, at}}});
      space.add({{{-32767, -32767, at}, {32767, 32767, at}, {-32767, 32767, at}}});
      // The square, one unit around the axis and at most four away, fills the picture.
      space.camera.focal = 5 * kFixedOne * std::max(1, view.width / view.height + 1);
      const DepthPicture drawn = picture::render_depth(space.model.scene(), space.camera, view);
      ASSERT_TRUE(drawn.status);
      ASSERT_NE(drawn.depth.front(), 0U);
      for (const std::uint32_t code : drawn.depth) ASSERT_EQ(code, drawn.depth.front()) << z;
    }
  }
}

RC_GTEST_PROP(HardCases, D48_SteppedDepthIsTheClosedForm, ()) {
  // Along 320 and 4096 columns: stepping adds up to the plane's value, whatever the step.
  const detail::Plane plane{*rc::gen::arbitrary<std::uint32_t>(), *rc::gen::arbitrary<std::uint32_t>(), 0};
  std::uint32_t stepped = plane.start;
  for (int column = 0; column < 4096; ++column) {
    if (column == 320 || column == 4095) RC_ASSERT(stepped == plane.at(column, 0));
    stepped += plane.step_x;
  }
}

RC_GTEST_PROP(HardCases, D48_ALongSpanEndsWithinOneCode, ()) {
  // A triangle of 4096 columns, whose corners lie inside the narrow limit.
  const std::int32_t top = between(0, 15), bottom = top + between(17, 48);
  raster_judge::Corners c{{{-1000 * 16 + between(0, 15), top, any_depth(), kWhite},
                           {-1000 * 16, bottom, any_depth(), kWhite},
                           {1000 * 16 + between(0, 15), top, any_depth(), kWhite}}};
  if (raster_judge::area_of(c) < 0) std::swap(c[1], c[2]);
  Canvas canvas;
  raster_judge::draw_spans(canvas, c, true);
  RC_ASSERT(raster_judge::verdict(canvas, c) == "");
}

/// Every pixel shows the nearest of the triangles there, more than a pixel from where that changes.
void expect_nearest_visible(Space& space, const std::vector<std::uint16_t>& colours) {
  const Picture picture = space.draw();
  ASSERT_TRUE(picture.status);
  std::vector<oracle::SpaceTriangle> triangles;
  for (const Triangle& t : space.model.triangles) triangles.push_back(space.exact(t, 0.2L));
  const auto nearest = [&](int x, int y) {
    int best = -1;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const oracle::Verdict verdict = triangles[i].sees(x, y);
      if (verdict == oracle::Verdict::abstains) return -2;
      if (verdict == oracle::Verdict::inside &&
          (best < 0 || triangles[i].distance(x, y) < triangles[static_cast<std::size_t>(best)].distance(x, y))) {
        best = static_cast<int>(i);
      }
    }
    return best;
  };
  std::vector<int> judged(triangles.size(), 0);
  for (int y = 1; y + 1 < space.view.height; ++y) {
    for (int x = 1; x + 1 < space.view.width; ++x) {
      const int expected = nearest(x, y);
      if (expected == -2 || nearest(x - 1, y) != expected || nearest(x + 1, y) != expected ||
          nearest(x, y - 1) != expected || nearest(x, y + 1) != expected) {
        continue;
      }
      ASSERT_EQ(pixel_at(picture, x, y, space.view.width),
                expected < 0 ? 0 : colours[static_cast<std::size_t>(expected)])
          << x << ',' << y;
      if (expected >= 0) ++judged[static_cast<std::size_t>(expected)];
    }
  }
  for (const int pixels : judged) EXPECT_GT(pixels, 20) << "each triangle is seen somewhere";
}

TEST(HardCases, D49_ThreeTrianglesThatOverlapInACycle) {
  // Each lies over the next one: no order of whole triangles is right.
  Space space(2 * kFixedOne, 5 * kFixedOne);
  space.view = {192, 128};
  const std::array<Colour, 3> colours{{{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}}};
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = 2 * M_PI * static_cast<double>(i) / 3;
    const auto corner = [&](double along, double across, int z) {
      const double x = along * std::cos(a) - across * std::sin(a), y = along * std::sin(a) + across * std::cos(a);
      return Position{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), static_cast<std::int16_t>(z)};
    };
    space.add({corner(-26000, -9000, 9000), corner(26000, -9000, -9000), corner(26000, -17000, -9000)}, colours[i]);
  }
  expect_nearest_visible(space, {0xF800, 0x07E0, 0x001F});
}

TEST(HardCases, D49_ThePolygonsOfTheThesis) {
  // A and B, where a painter that sorts by mean depth is wrong; seen along -z as in the text, the box 0..8 around them.
  Space space(8 * kFixedOne, 12 * kFixedOne);
  space.view = {192, 128};
  const auto position = [](double x, double y, double z) {
    const auto coordinate = [](double value) { return static_cast<std::int16_t>(std::lround(value * 4096)); };
    return Position{coordinate(x - 3), coordinate(y - 3), coordinate(z + 2)};
  };
  space.add({position(1, 5, -4), position(3, 4, -2), position(5, 1, 0)}, {255, 0, 0, 255});
  space.add({position(4, 5, -1.5), position(3.5, 2.5, -1), position(1, 0.5, -0.5)}, {0, 0, 255, 255});
  expect_nearest_visible(space, {0xF800, 0x001F});
}

}  // namespace
}  // namespace hard_cases
