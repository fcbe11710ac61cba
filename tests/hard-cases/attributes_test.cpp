// Hard cases F: texture coordinates and colours.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "generators.hpp"
#include "space.hpp"

namespace hard_cases {
namespace {

/// A texture of 16 x 8 texels, each its own value.
void number_texels(Model& model) {
  for (int i = 0; i < 128; ++i) model.texels.push_back(static_cast<std::uint16_t>(0x8000 + i));
  model.material.texture = 0;
  model.colours.clear();
}

TEST(HardCases, F59_PerspectiveTextureFromDistanceOneToAHundred) {
  // A floor from 1 to 100 units away: u runs from left to right, v into the distance.
  Space space(128 * kFixedOne, 0);
  space.view = {320, 240};
  space.camera.eye = {0, kFixedOne, 0};
  space.camera.near_plane = kFixedOne;
  const auto z = [](int distance) { return static_cast<std::int16_t>(-256 * distance); };
  const auto x = static_cast<std::int16_t>(256 * 60);
  const auto left = static_cast<std::int16_t>(-x);
  const std::array<Position, 4> corners{{{left, 0, z(1)}, {x, 0, z(1)}, {x, 0, z(100)}, {left, 0, z(100)}}};
  space.add({corners[0], corners[1], corners[2]});
  space.add({corners[0], corners[2], corners[3]});
  number_texels(space.model);
  const TexCoord t[4] = {{0, 0}, {4096, 0}, {4096, 4096}, {0, 4096}};  // 1.0 is 4096
  space.model.texcoords = {t[0], t[1], t[2], t[0], t[2], t[3]};
  const Picture picture = space.draw();
  ASSERT_TRUE(picture.status);
  const double focal = space.camera.focal / 65536.0 * 120;
  double worst = 0;
  long judged = 0;
  for (int row = 122; row < 240; ++row) {
    const double distance = focal / (row + 0.5 - 120);
    if (distance < 1.02 || distance > 99) continue;
    for (int column = 0; column < 320; ++column) {
      const double across = (column + 0.5 - 160) / focal * distance;
      if (std::abs(across) > 59.5) continue;
      const double u = 16 * (across + 60) / 120, v = 8 * (distance - 1) / 99;
      const int texel = pixel_at(picture, column, row, 320) - 0x8000;
      ASSERT_GE(texel, 0) << column << ',' << row;
      const auto outside = [](double low, double at) { return std::max({0.0, low - at, at - low - 1}); };
      worst = std::max({worst, outside(texel % 16, u), outside(texel / 16, v)});
      ++judged;
    }
  }
  EXPECT_GT(judged, 20'000);
  EXPECT_LT(worst, 1.0 / 16) << "texels; along a row of a floor the coordinates are linear, only snapping is seen";
  RecordProperty("worst_in_texels", std::to_string(worst));
}

RC_GTEST_PROP(HardCases, F59_EveryPixelOfATexturedTriangleIsNearTheExactTexel, ()) {
  Space space(4 * kFixedOne, 5 * kFixedOne);
  space.camera.near_plane = kFixedOne / 100;
  std::array<Position, 3> corners;
  for (Position& p : corners) {
    p = {static_cast<std::int16_t>(between(-25000, 25000)), static_cast<std::int16_t>(between(-25000, 25000)),
         static_cast<std::int16_t>(between(-32767, 20000))};
  }
  space.add(corners);
  number_texels(space.model);
  std::array<std::array<long double, 3>, 2> at{};  // texels
  for (std::size_t i = 0; i < 3; ++i) {
    const int u = between(-8192, 8192), v = between(-8192, 8192);
    space.model.texcoords.push_back({static_cast<std::int16_t>(u), static_cast<std::int16_t>(v)});
    at[0][i] = u / 256.0L;
    at[1][i] = v / 512.0L;
  }
  const Picture picture = space.draw();
  const oracle::SpaceTriangle exact = space.exact({0, 1, 2}, 0.5L);
  RC_PRE(!exact.degenerate());
  for (int y = 0; y < kView.height; ++y) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto value = [&](int i, int j) { return exact.value(i, j, at[axis]); };
      const RowOfCurvature curvature = curvature_along(picture, exact, y, value);
      for (int x = 0; x < kView.width; ++x) {
        if (exact.sees(x, y) != oracle::Verdict::inside) continue;
        const int texel = pixel_at(picture, x, y) - 0x8000;
        RC_ASSERT(texel >= 0);
        const int size = axis == 0 ? 16 : 8, shown = axis == 0 ? texel % 16 : texel / 16;
        // Corners are snapped by up to 1/32 pixel, and between two divisions the coordinate is linear.
        const long double slope = std::abs(value(x + 1, y) - value(x, y)) + std::abs(value(x, y + 1) - value(x, y));
        const long double limit = 0.02L + slope / 4 + 40 * largest_near(curvature, x);
        long double wrapped = std::fmod(value(x, y) - shown, static_cast<long double>(size));
        if (wrapped < 0) wrapped += size;
        RC_ASSERT(wrapped <= 1 + limit || wrapped >= size - limit);
      }
    }
  }
}

/// An orthographic square whose texels are `scale` pixels wide, from texel (u, v) on.
Picture textured_square(int scale, int u, int v, int pixels_wide, int pixels_high) {
  Lattice lattice;
  Model& model = lattice.model();
  const std::int64_t w = 16 * pixels_wide, h = 16 * pixels_high;
  lattice.add({{{0, 0}, {0, h}, {w, h}}}).add({{{0, 0}, {w, h}, {w, 0}}});
  number_texels(model);
  model.mesh.texcoord_bits = 8;
  const auto coordinate = [&](int texel, int size) { return static_cast<std::int16_t>(texel * 256 / size); };
  const TexCoord a{coordinate(u, 16), coordinate(v, 8)}, b{coordinate(u, 16), coordinate(v + pixels_high / scale, 8)},
      c{coordinate(u + pixels_wide / scale, 16), coordinate(v + pixels_high / scale, 8)},
      d{coordinate(u + pixels_wide / scale, 16), coordinate(v, 8)};
  model.texcoords = {a, b, c, a, c, d};
  return lattice.draw();
}

TEST(HardCases, F60_PointSamplingTakesExactlyOneTexelAndWrapsNegativeCoordinates) {
  for (const int scale : {1, 2, 4}) {
    for (int u = -40; u <= 40; u += 5) {
      for (int v = -17; v <= 17; v += 3) {
        const Picture picture = textured_square(scale, u, v, 64, 32);
        ASSERT_TRUE(picture.status);
        for (int y = 0; y < 32; ++y) {
          for (int x = 0; x < 64; ++x) {
            const int column = (((u + x / scale) % 16) + 16) % 16, row = (((v + y / scale) % 8) + 8) % 8;
            ASSERT_EQ(pixel_at(picture, x, y), 0x8000 + row * 16 + column)
                << scale << ' ' << u << ' ' << v << " at " << x << ',' << y;
          }
        }
      }
    }
  }
}

TEST(HardCases, F61_AffineWithEqualDistanceIsTheSameAsPerspective) {
  // A facing square, once orthographic and once in perspective at the distance where both have the same size.
  for (int turn = 0; turn < 40; ++turn) {
    Space space(kFixedOne, 3 * kFixedOne);
    const double a = turn * 0.157;
    // Whole sub-pixels, 64 steps each: no corner lies where snapping could go either way.
    const auto corner = [&](double x, double y) {
      const auto step = [](double value) { return static_cast<std::int16_t>(64 * std::lround(312 * value)); };
      return Position{step(x * std::cos(a) - y * std::sin(a)), step(x * std::sin(a) + y * std::cos(a)), 0};
    };
    space.add({corner(-1, -1), corner(1, -1), corner(1, 1)});
    space.add({corner(-1, -1), corner(1, 1), corner(-1, 1)});
    number_texels(space.model);
    space.model.texcoords = {{0, 0}, {4096, 0}, {4096, 4096}, {0, 0}, {4096, 4096}, {0, 4096}};
    space.camera.focal = 3 * kFixedOne;
    const Picture perspective = space.draw();
    space.camera.projection = Projection::orthographic;
    space.camera.focal = kFixedOne;
    const Picture orthographic = space.draw();
    ASSERT_EQ(mask_of(perspective), mask_of(orthographic)) << turn;
    // Both are within 1/256 texel: where a texel border is that close to a pixel centre, in one of 64, they may differ.
    int different = 0, covered = 0;
    for (std::size_t i = 0; i < perspective.pixels.size(); i += 2) {
      different += perspective.pixels[i] != orthographic.pixels[i];
      covered += perspective.pixels[i] != std::byte{0} || perspective.pixels[i + 1] != std::byte{0};
    }
    ASSERT_GT(covered, 500);
    ASSERT_LE(different * 64, covered) << turn;
  }
}

RC_GTEST_PROP(HardCases, F62_ColoursNeverWrapAtSilhouettes, ()) {
  // Channels at both ends of the range, triangles of any shape: the judge allows one of 8 bits, a wrap is 255.
  raster_judge::Corners c = with_attributes(any_triangle(between(1, 1500)));
  RC_PRE(raster_judge::area_of(c) > 0);
  for (raster_judge::Corner& v : c) {
    const auto end = [] { return static_cast<std::uint8_t>(between(0, 1) * 255); };
    v.colour = {end(), end(), end(), 255};
  }
  raster_judge::Canvas spans, small;
  raster_judge::draw_spans(spans, c, true);
  RC_ASSERT(raster_judge::verdict(spans, c) == "");
  if (raster_judge::draw_small(small, c)) RC_ASSERT(raster_judge::verdict(small, c) == "");
}

TEST(HardCases, F62_BrightLightsSaturate) {
  // Four lights of full strength on a white square: white, not a wrapped sum.
  Model model;
  model.positions = {{-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}};
  model.normals.assign(3, {0, 0, 127, 0});
  model.triangles = {{0, 1, 2}};
  Scene scene = model.scene();
  const std::array<DirectionalLight, 4> lights{};
  scene.lights = lights;
  scene.ambient = kWhite;
  const Picture picture = picture::render(scene, Camera{}, kView, kView.height);
  ASSERT_TRUE(picture.status);
  EXPECT_EQ(pixel_at(picture, 52, 36), 0xFFFF);
}

}  // namespace
}  // namespace hard_cases
