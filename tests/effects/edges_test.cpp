// Anti-aliased edges: pixels against exact areas, pictures against larger ones, and what is hidden.
#include <array>
#include <cmath>
#include <random>

#include "edges_scene.hpp"
#include "edges_world.hpp"
#include "zstrip/fingerprints.hpp"
#include "zstrip_scenes/stage.hpp"

namespace effects_test {
namespace {

using Point = std::array<double, 2>;

/// What of a convex polygon lies in x below `limit` (axis 0) or y, or above it.
std::vector<Point> cut(const std::vector<Point>& polygon, std::size_t axis, double limit, double sign) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double dp = sign * (limit - p[axis]), dq = sign * (limit - q[axis]);
    if (dp >= 0) kept.push_back(p);
    if ((dp < 0) != (dq < 0)) {
      const double t = dp / (dp - dq);
      kept.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])});
    }
  }
  return kept;
}

/// The part of pixel (x, y) that a convex polygon covers.
double area_in_pixel(std::vector<Point> polygon, int x, int y) {
  polygon = cut(cut(polygon, 0, x, -1), 0, x + 1, 1);
  polygon = cut(cut(polygon, 1, y, -1), 1, y + 1, 1);
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    twice += p[0] * q[1] - q[0] * p[1];
  }
  return std::abs(twice) / 2;
}

TEST(Edges, PixelsAreTheAreaThatTheEdgeLeavesThem) {
  // Where an edge crosses a pixel's row, its height in the middle of the pixel is the area; where it leaves the pixel
  // at the top or bottom, a corner of at most 1/8 is not counted. Beside that: ends that are snapped to 1/16 pixels,
  // weights of 1/32, green in 6 bits.
  constexpr double kRounding = 1.0 / 32 + 1.0 / 64 + 1.0 / 63;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-0.3, 0.3), angles(0, kPi);
  double error = 0, error_without = 0;
  int pixels = 0;
  for (int i = 0; i < 60; ++i) {
    const double angle = angles(random), dx = place(random), dy = place(random);
    World world(square(), false);
    world.add({0, 255, 0, 255}, turned_flat(angle, 1.2, dx, dy, 0));
    const Drawn with = draw<kFlatEdges>(world.scene, parallel_camera(), kSquare);
    const Drawn without = draw<kFlatEdges>(world.without_edges(), parallel_camera(), kSquare);
    std::vector<Point> polygon;
    for (const auto& [x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      polygon.push_back({32 + (1.2 * (x * std::cos(angle) - y * std::sin(angle)) + dx) / kPixel,
                         32 - (1.2 * (x * std::sin(angle) + y * std::cos(angle)) + dy) / kPixel});
    }
    for (int y = 0; y < kSquare.height; ++y) {
      for (int x = 0; x < kSquare.width; ++x) {
        bool is_corner = false;
        for (const Point& p : polygon) is_corner |= std::hypot(p[0] - x - 0.5, p[1] - y - 0.5) < 2;
        const double area = area_in_pixel(polygon, x, y);
        const double drawn = (with.at(x, y) >> 5 & 0x3F) / 63.0, plain = (without.at(x, y) >> 5 & 0x3F) / 63.0;
        if (!is_corner) {
          EXPECT_NEAR(drawn, area, 1.0 / 8 + kRounding) << "angle " << angle << ", pixel " << x << ", " << y;
        }
        if (area == 0 || area == 1) continue;
        ++pixels;
        error += std::abs(drawn - area);
        error_without += std::abs(plain - area);
      }
    }
  }
  EXPECT_LT(error / pixels, 0.04);
  EXPECT_GT(error_without / pixels, 0.15);
}

TEST(Edges, UprightAndLevelEdgesBetweenPixelsStay) {
  World world(square(), false);
  world.add({0, 255, 0, 255}, turned_flat(0, 1, 0, 0, 0));
  const Drawn with = draw<kFlatEdges>(world.scene, parallel_camera(), kSquare);
  EXPECT_EQ(with, draw<kFlatEdges>(world.without_edges(), parallel_camera(), kSquare));
  EXPECT_EQ(with.green(16, 16), 252);
  EXPECT_EQ(with.green(15, 16), 0);
}

constexpr Effects kLitEdges = effect::lighting | effect::edges | effect::bins;
constexpr DirectionalLight kLights[] = {{.x = 13000, .y = 26000, .z = 14500}};

TEST(Edges, ACubeIsNearerToATruePicture) {
  for (int i = 0; i < 12; ++i) {
    World world(zstrip::test::faceted_box(), true);
    world.scene.lights = kLights;
    world.add({255, 220, 90, 255}, turned_about_x_and_y(0.2 + 0.5 * i, 0.7 + 0.3 * i), true);
    EXPECT_LT(share_of_error<kLitEdges>(world.scene, near_camera(5), {80, 60}), 0.35) << i;
  }
}

TEST(Edges, AKnotIsNearerToATruePicture) {
  constexpr Effects kEffects = effects_of(scenes::edges.scene, scenes::edges.camera) | effect::bins;
  for (std::uint32_t frame = 0; frame < 6; ++frame) {
    scenes::Staged staged;
    scenes::stage(scenes::edges, staged, frame, 18, {160, 120});
    EXPECT_LT(share_of_error<kEffects>(staged.scene, staged.camera, {160, 120}), 0.65) << frame;
  }
}

// A face narrower than a pixel lies between the crease and the outline: the crease was blended with the background, and
// then the outline once more.
TEST(Edges, CreasesBesideAnOutlineWereBlendedWithTheBackground) {
  OwnMesh own = square();
  for (const auto& [x, y, z] :
       {std::array{-32767, 24000, 0}, {32767, 24000, 0}, {32767, 24300, -200}, {-32767, 24300, -200}}) {
    own.positions.push_back({static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), static_cast<std::int16_t>(z)});
    own.normals.push_back({0, 100, 80, 0});
  }
  own.positions[2].y = own.positions[3].y = 24000;
  own.triangles.push_back({4, 5, 6});
  own.triangles.push_back({4, 6, 7});
  for (const double angle : {0.03, 0.1, 0.4, 1.2, 1.7, 2.4}) {
    World world(own, true);
    world.add({255, 220, 90, 255}, turned_flat(angle, 1.2, 0.1, 0, 0));
    EXPECT_LT(share_of_error<kFlatEdges>(world.scene, parallel_camera(), kSquare), 0.35) << angle;
  }
}

TEST(Edges, WhatTheNearPlaneCutsIsBlendedToo) {
  // A floor that reaches from behind the viewer to the horizon, turned.
  for (int i = 0; i < 8; ++i) {
    World world(square(), false);
    world.add({255, 255, 255, 255}, turned_about_x_and_y(-1.3, 0.15 * i, 20));
    world.instances[0].transform.m[1][3] = to_fixed(-1);
    EXPECT_LT(share_of_error<effect::edges | effect::bins>(world.scene, near_camera(3), {80, 60}), 0.3) << i;
  }
}

TEST(Edges, OfASheetAreSeenFromItsFront) {
  World world(square(), false);
  world.add({0, 255, 0, 255}, turned_flat(0.3, 1, 0, 0, 0));
  world.instances[0].transform.m[0][0] = -world.instances[0].transform.m[0][0];
  world.instances[0].transform.m[1][0] = -world.instances[0].transform.m[1][0];
  const Drawn empty = draw<kFlatEdges>(world.scene, parallel_camera(), kSquare);
  EXPECT_EQ(empty, draw<kFlatEdges>(world.without_edges(), parallel_camera(), kSquare));
  world.materials[0].double_sided = true;
  EXPECT_LT(share_of_error<kFlatEdges>(world.scene, parallel_camera(), kSquare), 0.2);
}

/// The lower edge of a sheet that stands still is blended with what moves in the strip below.
TEST(Edges, AStripAboveWhatMovesHasAnotherFingerprint) {
  constexpr std::uint16_t kRows = 8, kStrips = kSquare.height / kRows, kAbove = kStrips / 2 - 1;
  using Strip = std::array<std::uint16_t, kSquare.width * kRows>;
  World world(square(), false);
  world.add({0, 255, 0, 255}, turned_flat(0, 1, 0, 1 + 0.3 * kPixel, 0));
  world.add({255, 0, 0, 255}, turned_flat(0, 1, 0, -1 - 0.45 * kPixel, -1));
  const Plan plan = zstrip::plan(count(world.scene), kSquare, kFlatEdges, {.strip_rows = kRows}).plan;
  std::vector<std::uint64_t> arena(plan.bytes() / sizeof(std::uint64_t) + 1);
  Renderer<kFlatEdges> renderer;
  std::vector<Strip> seen[2]{std::vector<Strip>(kStrips), std::vector<Strip>(kStrips)};
  std::vector<StripFingerprints<kStrips>> prints;
  for (std::vector<Strip>& strips : seen) {
    ASSERT_TRUE(
        renderer.begin_frame(world.scene, parallel_camera(), kSquare, plan, std::as_writable_bytes(std::span(arena))));
    prints.emplace_back(renderer.frame(), parallel_camera());
    for (std::uint16_t strip = 0; strip < kStrips; ++strip) {
      ASSERT_TRUE(renderer.draw_strip(strip, std::as_writable_bytes(std::span(strips[strip]))));
    }
    world.instances[1].transform.m[0][3] = to_fixed(0.5);
  }
  EXPECT_EQ(prints[0][0], prints[1][0]) << "nothing moves near the first strip";
  EXPECT_NE(seen[0][kAbove], seen[1][kAbove]);
  EXPECT_NE(prints[0][kAbove], prints[1][kAbove]);
}

TEST(Edges, HiddenOnesAreNotBlended) {
  // Behind a sheet of narrow stripes, which any blending would change.
  std::vector<std::uint16_t> texels;
  for (int i = 0; i < 64; ++i) texels.push_back(i % 2 == 0 ? 0xFFFF : 0x0000);
  const Texture textures[1] = {{.texels = texels, .log2_width = 6, .log2_height = 0}};
  std::vector<TexCoord> texcoords = {{0, 0}, {4096, 0}, {4096, 0}, {0, 0}};
  for (int i = 0; i < 6; ++i) {
    World world(square(), false);
    world.meshes[0].texcoords = texcoords;
    world.scene.textures = textures;
    world.add({255, 255, 255, 255}, turned_flat(0, 1.9, 0, 0, 1));
    world.materials[0].texture = 0;
    const Drawn alone = draw<kFlatEdges | effect::textures>(world.scene, parallel_camera(), kSquare);
    world.add({0, 255, 0, 255}, turned_flat(0.3 + i, 0.8, 0, 0, i < 3 ? 0 : 0.9));
    EXPECT_EQ(draw<kFlatEdges | effect::textures>(world.scene, parallel_camera(), kSquare), alone) << i;
  }
}

}  // namespace
}  // namespace effects_test
