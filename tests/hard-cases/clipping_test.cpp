// Hard cases C: near plane, far plane and guard band cut triangles without moving what is left of them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "generators.hpp"
#include "space.hpp"

namespace hard_cases {
namespace {

/// Vertices are snapped to 1/16 pixel, new ones of a clipped edge too: each edge moves by less than this.
constexpr long double kTolerance = 0.15L;

Position any_position(int low_z = -32767, int high_z = 32767) {
  return {static_cast<std::int16_t>(between(-32767, 32767)), static_cast<std::int16_t>(between(-32767, 32767)),
          static_cast<std::int16_t>(between(low_z, high_z))};
}

/// A cube of +-4 around the origin, the eye inside it at z = 0, near 0.25, far 3.5: a step of the grid is 1/8192.
Space room() {
  Space space(4 * kFixedOne, 0);
  space.camera.near_plane = kFixedOne / 4;
  space.camera.far_plane = 7 * kFixedOne / 2;
  return space;
}
constexpr int kNear = -8192 / 4;     ///< z of the near plane in steps
constexpr int kFar = -8192 * 7 / 2;  ///< of the far plane

RC_GTEST_PROP(HardCases, C26_OneAndTwoVerticesBehindTheNearPlane, ()) {
  Space space = room();
  const int behind = between(1, 2);
  std::array<Position, 3> corners;
  for (int i = 0; i < 3; ++i) {
    corners[static_cast<std::size_t>(i)] = i < behind ? any_position(kNear + 1, 32767) : any_position(kFar, kNear);
  }
  space.add(corners);
  const Picture picture = space.draw();
  RC_TAG(picture.statistics.fragments > 0 ? "seen" : "not in the picture");
  RC_ASSERT(space.verdict(picture, kTolerance) == "");
}

TEST(HardCases, C27_AllThreeExactlyOnTheNearPlane) {
  Space space = room();
  space.add({{{-1000, -1000, kNear}, {1000, -1000, kNear}, {0, 1000, kNear}}});
  const Picture picture = space.draw();
  EXPECT_GT(picture.statistics.fragments, 100U) << "the near plane belongs to the view";
  EXPECT_EQ(space.verdict(picture, kTolerance), "");
  Space behind = room();
  behind.add({{{-1000, -1000, kNear + 1}, {1000, -1000, kNear + 1}, {0, 1000, kNear + 1}}});
  EXPECT_EQ(behind.draw().statistics.fragments, 0U);
}

RC_GTEST_PROP(HardCases, C28_WhollyInFrontOfNearOrBeyondFarIsEmpty, ()) {
  Space space = room();
  const bool in_front = between(0, 1) == 0;
  std::array<Position, 3> corners;
  for (Position& p : corners) p = in_front ? any_position(kNear + 1, 32767) : any_position(-32767, kFar - 1);
  space.add(corners);
  RC_ASSERT(space.draw().statistics.fragments == 0U);
}

RC_GTEST_PROP(HardCases, C29_NeighboursClippedOnTheSameEdgeShareTheNewVertex, ()) {
  // One edge through the near plane, a corner on either side of a plane that holds it: the two pictures never overlap,
  // and no pixel near the edge is left out.
  Space space = room();
  const Position a = any_position(kNear + 1, 20000), b = any_position(kFar, kNear - 1);
  const Position c = any_position(kFar, 20000), d = any_position(kFar, 20000);
  space.model.positions = {a, b, c, d};
  space.model.colours.assign(4, kWhite);
  const auto draw = [&](std::vector<Triangle> triangles) {
    space.model.triangles = std::move(triangles);
    return space.draw();
  };
  const Picture left = draw({{0, 1, 2}}), right = draw({{1, 0, 3}}), both = draw({{0, 1, 2}, {1, 0, 3}});
  RC_ASSERT(both.statistics.fragments == left.statistics.fragments + right.statistics.fragments);
  // In either direction, and whichever corner comes first.
  RC_ASSERT(draw({{1, 2, 0}}).pixels == left.pixels);
  RC_ASSERT(mask_of(draw({{1, 0, 2}})) == mask_of(left));
  const oracle::SpaceTriangle exact_left = space.exact({0, 1, 2}, kTolerance);
  const oracle::SpaceTriangle exact_right = space.exact({1, 0, 3}, kTolerance);
  RC_PRE(!exact_left.degenerate() && !exact_right.degenerate());
  if (exact_left.front_facing() != exact_right.front_facing()) return;
  // Both fronts or both backs: they lie on opposite sides of the edge.
  const std::vector<bool> in_left = mask_of(left), in_right = mask_of(right);
  int twice = 0;
  for (std::size_t i = 0; i < in_left.size(); ++i) twice += in_left[i] && in_right[i];
  RC_TAG(twice == 0 ? "apart" : "overlapping");
  // On opposite sides of the edge's line nothing can be drawn twice.
  RC_ASSERT(twice == 0);
}

RC_GTEST_PROP(HardCases, C30_NearFarAndGuardBandTogether, ()) {
  // Coordinates up to the guard band and beyond: a narrow view of a wide scene.
  Space space = room();
  space.camera.focal = kFixedOne * between(1, 3000);
  space.camera.near_plane = between(16, kFixedOne);
  const std::array<Position, 3> corners{any_position(), any_position(), any_position()};
  space.add(corners);
  const Picture picture = space.draw();
  RC_ASSERT(picture.status);
  RC_TAG(picture.statistics.clipped == 0     ? "not clipped"
         : picture.statistics.fragments == 0 ? "clipped away"
                                             : "clipped");
  RC_ASSERT(space.verdict(picture, 0.2L) == "");
  RC_ASSERT(space.draw(5).pixels == picture.pixels);
}

RC_GTEST_PROP(HardCases, C31_AttributesAfterClipping, ()) {
  // Texture coordinates are perspective-correct: clipping may not move a texel. One texel a colour, 2048 of them along
  // x; the triangle is cut by the near plane.
  Space space = room();
  std::array<Position, 3> corners{any_position(kFar, kNear), any_position(kFar, kNear), any_position(kNear + 1, 20000)};
  space.add(corners);
  Model& model = space.model;
  model.colours.clear();
  for (int i = 0; i < 128; ++i) model.texels.push_back(static_cast<std::uint16_t>(0x8000 + i));
  model.material.texture = 0;
  // The texture is 16 x 8 texels; u runs over 1, v over 1.
  const std::array<std::array<int, 2>, 3> coordinates{{{0, 0}, {4096, 0}, {0, 4096}}};
  for (const auto& c : coordinates)
    model.texcoords.push_back({static_cast<std::int16_t>(c[0]), static_cast<std::int16_t>(c[1])});
  const Picture picture = space.draw();
  RC_ASSERT(picture.status);
  const oracle::SpaceTriangle exact = space.exact({0, 1, 2}, 0.5L);
  RC_PRE(!exact.degenerate());
  int checked = 0;
  const auto u = [&](int i, int j) { return 16 * exact.value(i, j, {0, 1, 0}); };
  const auto v = [&](int i, int j) { return 8 * exact.value(i, j, {0, 0, 1}); };
  for (int y = 0; y < kView.height; ++y) {
    // Between two divisions the coordinate is linear: off by at most 16 * 16 / 8 of its curvature.
    const RowOfCurvature curvature_u = curvature_along(picture, exact, y, u),
                         curvature_v = curvature_along(picture, exact, y, v);
    for (int x = 0; x < kView.width; ++x) {
      if (exact.sees(x, y) != oracle::Verdict::inside) continue;
      const std::uint16_t texel = pixel_at(picture, x, y);
      RC_ASSERT(texel >= 0x8000);
      // The texture coordinate that the middle of the pixel has, and how much it changes over a pixel: a span divides
      // every 16 pixels, the corners are snapped by up to 1/32 pixel.
      const auto distance_between = [](long double low, long double high, long double at) {
        return at < low ? low - at : at > high ? at - high : 0;
      };
      const long double slope_u = std::abs(u(x + 1, y) - u(x, y)) + std::abs(u(x, y + 1) - u(x, y));
      const long double slope_v = std::abs(v(x + 1, y) - v(x, y)) + std::abs(v(x, y + 1) - v(x, y));
      const int column = (texel - 0x8000) % 16, row = (texel - 0x8000) / 16;
      RC_ASSERT(distance_between(column, column + 1, u(x, y)) <= 0.1L + slope_u + 40 * largest_near(curvature_u, x));
      RC_ASSERT(distance_between(row, row + 1, v(x, y)) <= 0.1L + slope_v + 40 * largest_near(curvature_v, x));
      ++checked;
    }
  }
  RC_TAG(checked > 0 ? "seen" : "not in the picture");
}

TEST(HardCases, C32_VeryLargePolygonInACornerOfThePicture) {
  // A floor of 8000 x 8000 units seen from a height of 0.01 to 100: every pixel below the horizon, once.
  for (const int height : {655, 6554, kFixedOne, 10 * kFixedOne, 100 * kFixedOne}) {
    for (const View view : {View{96, 64}, View{1, 1}, View{2048, 2}, View{2, 2048}}) {
      Space space(4000 * kFixedOne, 0);
      space.view = view;
      space.camera.eye = {0, height, 0};
      space.camera.near_plane = 655;
      space.camera.far_plane = 32000 * kFixedOne;
      space.add({{{-32767, 0, 32767}, {32767, 0, 32767}, {32767, 0, -32767}}});
      space.add({{{-32767, 0, 32767}, {32767, 0, -32767}, {-32767, 0, -32767}}});
      const Picture picture = space.draw();
      ASSERT_TRUE(picture.status);
      ASSERT_EQ(picture.statistics.fragments, picture.statistics.depth_passes);
      // The floor ends 4000 units away, height / 4000 below the horizon.
      const double focal = space.camera.focal / 65536.0 * view.height / 2;
      const double end = view.height / 2.0 + focal * height / 65536.0 / 4000;
      for (int y = 0; y < view.height; ++y) {
        if (std::abs(y + 0.5 - end) < 0.1) continue;
        for (int x : {0, view.width / 2, view.width - 1}) {
          const double distance = focal * height / 65536.0 / (y + 0.5 - view.height / 2.0);
          if (std::abs(x + 0.5 - view.width / 2.0) * distance / focal > 3999) continue;  // beside the floor
          ASSERT_EQ(pixel_at(picture, x, y, view.width) != 0, y + 0.5 > end) << height << ' ' << view.width << ' ' << y;
        }
      }
    }
  }
}

TEST(HardCases, C33_DepthIsClippedAtNearAndFarNotClamped) {
  // A floor from behind the eye to beyond the far plane: what is nearer than near or farther than far is not there.
  Space space = room();
  space.camera.eye.y = kFixedOne / 2;
  space.add({{{-32767, 0, 32767}, {32767, 0, 32767}, {32767, 0, -32767}}});
  space.add({{{-32767, 0, 32767}, {32767, 0, -32767}, {-32767, 0, -32767}}});
  // A little of the floor is nearer than the near plane only where the picture ends: look down.
  space.camera.focal = kFixedOne / 4;
  const Picture picture = space.draw();
  const double focal = 0.25 * kView.height / 2, middle = kView.height / 2.0;
  int seen = 0;
  for (int y = 0; y < kView.height; ++y) {
    const double below = y + 0.5 - middle, distance = below > 0 ? focal * 0.5 / below : 1e9;
    if (std::abs(focal * 0.5 / 0.25 - below) < 0.1 || std::abs(focal * 0.5 / 3.5 - below) < 0.1) continue;
    const bool inside = distance > 0.25 && distance < 3.5;
    ASSERT_EQ(pixel_at(picture, 48, y) != 0, inside) << y;
    seen += inside;
  }
  EXPECT_GT(seen, 5);
}

RC_GTEST_PROP(HardCases, C34_FlatColourIsTheFirstVertexsWhateverIsClipped, ()) {
  Space space = room();
  std::array<Position, 3> corners{any_position(), any_position(), any_position()};
  space.add(corners);
  space.model.colours = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}};
  const Picture picture = space.draw();
  for (int y = 0; y < kView.height; ++y) {
    for (int x = 0; x < kView.width; ++x) RC_ASSERT(pixel_at(picture, x, y) == 0 || pixel_at(picture, x, y) == 0xF800);
  }
}

}  // namespace
}  // namespace hard_cases
