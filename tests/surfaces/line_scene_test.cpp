// Lines and points in scenes: order, bounds, strips, what hides them, fog, colour, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "line_world.hpp"
#include "zstrip/base/crc32.hpp"

namespace lines_test {
namespace {

/// Lines of all kinds, some of them behind the eye.
World tangle(Projection projection) {
  World world;
  std::mt19937 random(6);
  world.mesh.half_extent = {fixed(8.0), fixed(6.0), fixed(16.0)};
  world.camera.projection = projection;
  if (projection == Projection::orthographic) world.camera.focal = fixed(0.15);
  for (int i = 0; i < 60; ++i) {
    if (i % 5 == 0) {
      world.point(any_position(random, 12000, 12000));
    } else {
      world.line(any_position(random, 32767, 32767), any_position(random, 32767, 32767));
    }
  }
  for (std::size_t i = 0; i < world.positions.size(); ++i) {
    world.colours.push_back({static_cast<std::uint8_t>(50 + 2 * i), static_cast<std::uint8_t>(random()), 90, 255});
  }
  world.lines.width = 3;
  return world;
}

TEST(Lines, HaveTheirChecksums) {
  for (const auto& [projection, checksum] :
       {std::pair{Projection::perspective, 0x5620BD75U}, std::pair{Projection::orthographic, 0xC84877FEU}}) {
    World world = tangle(projection);
    const Scene scene = world.scene();
    const effects_test::Drawn drawn =
        effects_test::draw_any(effects_of(scene, world.camera), scene, world.camera, kView);
    EXPECT_EQ(crc32(std::as_bytes(std::span(drawn.pixels))), checksum);
  }
}

TEST(Lines, StripsTilesBinsAndMethodsDrawTheSame) {
  using effects_test::draw_any;
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    World world = tangle(projection);
    const Scene scene = world.scene();
    const Effects effects = effects_of(scene, world.camera);
    const effects_test::Drawn whole = draw_any(effects, scene, world.camera, kView);
    EXPECT_GT(std::ranges::count_if(whole.pixels, [](std::uint16_t pixel) { return pixel != 0; }), 1500);
    const effects_test::Drawn exact =
        projection == Projection::perspective
            ? effects_test::draw<effect::lines>(scene, world.camera, kView)
            : effects_test::draw<effect::lines | effect::orthographic>(scene, world.camera, kView);
    EXPECT_EQ(exact, whole) << "the superset's";
    for (const Budget& budget : {Budget{.strip_rows = 1}, Budget{.strip_rows = 7, .strip_columns = 24},
                                 Budget{.strip_rows = 16, .modes = Modes::binned}}) {
      EXPECT_EQ(draw_any(effects | effect::bins, scene, world.camera, kView, budget), whole)
          << budget.strip_rows << 'x' << budget.strip_columns;
    }
    EXPECT_EQ(draw_any(effects | effect::depth_ranges, scene, world.camera, kView, {.strip_rows = 8}), whole);
    for (const Effects method : {method::hierarchical_z, method::front_to_back, method::midpoint_safe}) {
      EXPECT_EQ(draw_any(effects | method, scene, world.camera, kView, {.strip_rows = 16}), whole) << method.methods;
    }
  }
}

/// Vertices, sizes, transforms and cameras at the ends of their ranges: nothing overflows, and strips agree.
TEST(Lines, AtTheEndsOfAllRangesStripsAgree) {
  std::mt19937 random(7);
  int drawn = 0;
  for (int i = 0; i < 300; ++i) {
    World world;
    const Fixed sizes[] = {1, 6554, kFixedOne, fixed(4095.0)};
    const auto size = [&] { return sizes[random() % 4]; };
    world.mesh.half_extent = {size(), size(), size()};
    const Fixed scales[] = {1, kFixedOne, (Fixed{1} << 24) - 1, -((Fixed{1} << 24) - 1)};
    for (auto& row : world.lines.transform.m) {
      for (int column = 0; column < 3; ++column) row[column] = random() % 2 == 0 ? 0 : scales[random() % 4];
    }
    world.camera.near_plane = random() % 2 == 0 ? 1 : 6554;
    world.camera.far_plane = random() % 2 == 0 ? INT32_MAX : fixed(100.0);
    world.camera.focal = random() % 2 == 0 ? fixed(1.7) : fixed(30.0);
    world.camera.fixed_depth_range = random() % 2 == 0;
    if (random() % 3 == 0) world.camera.projection = Projection::orthographic;
    const std::int16_t ends[] = {-32768, 32767, 0, 1, 20000};
    const auto any = [&] { return ends[random() % 5]; };
    for (int k = 0; k < 30; ++k) {
      const Position a{any(), any(), any()}, b{any(), any(), any()};
      if (k % 4 == 0) {
        world.point(a);
      } else {
        world.line(a, b);
      }
    }
    world.lines.width = static_cast<std::uint8_t>(random() % 2 == 0 ? 64 : 1);
    const Scene scene = world.scene();
    ASSERT_TRUE(validate(scene));
    const Effects effects = effects_of(scene, world.camera) | effect::statistics;
    const DepthPicture whole = DepthRenderer(effects, kView, kView.height).draw(scene, world.camera);
    if (!whole.status) {
      EXPECT_EQ(whole.status.error, Error::lines);
      continue;
    }
    drawn += std::ranges::any_of(whole.depth, [](std::uint32_t code) { return code != 0; }) ? 1 : 0;
    const DepthPicture parts = DepthRenderer(effects, kView, 5).draw(scene, world.camera);
    ASSERT_EQ(parts.depth, whole.depth) << i;
    ASSERT_EQ(parts.pixels, whole.pixels) << i;
  }
  EXPECT_GT(drawn, 60);
}

/// A wall of two triangles at z = 0 before and behind which lines pass.
struct Wall {
  Position corners[4] = {{-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}, {-32767, 32767, 0}};
  Triangle triangles[2] = {{0, 1, 2}, {0, 2, 3}};
  Segment edges[5] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}};
  Mesh mesh{
      .positions = corners, .normals = {}, .colours = {}, .texcoords = {}, .triangles = triangles, .meshlets = {}};
  Material materials[2] = {{.colour = {0, 0, 255, 255}, .lit = false}, {.colour = {255, 0, 0, 255}, .lit = false}};
  Instance instance{};
  LineSet lines{.segments = edges, .material = 1};
  Camera camera{};

  Wall() {
    camera.eye = {fixed(1.0), fixed(1.5), fixed(4.0)};
    camera.near_plane = fixed(1.0);
    camera.far_plane = fixed(20.0);
  }
  Scene scene() {
    Scene s;
    s.meshes = {&mesh, 1};
    s.materials = materials;
    s.instances = {&instance, 1};
    s.lines = {&lines, 1};
    return s;
  }
  int red_pixels() {
    const Scene s = scene();
    const effects_test::Drawn drawn = effects_test::draw_any(effects_of(s, camera), s, camera, kView);
    return static_cast<int>(std::ranges::count(drawn.pixels, 0xF800));
  }
};

TEST(Lines, AreHiddenByWhatIsNearer) {
  Wall wall;
  ASSERT_TRUE(look_at(wall.camera, wall.camera.eye, {0, 0, 0}, {0, kFixedOne, 0}));
  wall.instance.transform.m[2][3] = fixed(-1.0);  // the wall is behind its lines
  const int all = wall.red_pixels();
  EXPECT_GT(all, 100);
  wall.instance.transform.m[2][3] = fixed(0.5);  // before
  wall.lines.transform.m[0][0] = wall.lines.transform.m[1][1] = fixed(0.5);
  EXPECT_EQ(wall.red_pixels(), 0);
}

TEST(Lines, WithABiasLieInFrontOfTheirOwnSurface) {
  Wall wall;
  ASSERT_TRUE(look_at(wall.camera, wall.camera.eye, {0, 0, 0}, {0, kFixedOne, 0}));
  const Scene alone = [&] {
    Scene s = wall.scene();
    s.instances = {};
    return s;
  }();
  wall.camera.fixed_depth_range = true;
  const effects_test::Drawn free = effects_test::draw_any(effects_of(alone, wall.camera), alone, wall.camera, kView);
  const auto visible = static_cast<int>(std::ranges::count(free.pixels, 0xF800));
  EXPECT_LT(wall.red_pixels(), visible) << "the surface covers some pixels of its own edges";
  wall.materials[1].depth_bias = 300;
  EXPECT_EQ(wall.red_pixels(), visible);
}

TEST(Lines, FadeIntoFogByTheirDistance) {
  World world = World::in_pixels();
  world.material.colour = {240, 160, 80, 255};
  world.line({-640, 0, -32767}, {640, 0, 32767});
  const Fog fog{.colour = {16, 96, 240, 255}, .start = fixed(3.0), .end = fixed(13.0)};
  Scene scene = world.scene();
  scene.fog = &fog;
  const Effects effects = effects_of(scene, world.camera);
  EXPECT_EQ(effects, effect::lines | effect::fog | effect::orthographic);
  const effects_test::Drawn drawn = effects_test::draw_any(effects, scene, world.camera, kView);
  for (int x = 10; x < 86; ++x) {
    const Real w = 8 - 4 * (x + 0.5L - 48) / 40;
    const Real share = std::clamp((13 - w) / 10, Real{0}, Real{1});
    EXPECT_NEAR(drawn.green(x, 32) + 2, static_cast<double>(160 * share + 96 * (1 - share)), 2.6) << x;
  }
}

TEST(Lines, HaveTheColourOfTheirFirstVertex) {
  World world = World::in_pixels();
  world.material.colour = {255, 128, 255, 255};
  world.line({-160, 8, 0}, {160, 8, 0});
  world.point({0, 200, 0});
  world.colours = {{255, 255, 0, 255}, {0, 0, 255, 255}, {0, 0, 255, 255}};
  const Scene scene = world.scene();
  const effects_test::Drawn drawn = effects_test::draw_any(effects_of(scene, world.camera), scene, world.camera, kView);
  EXPECT_EQ(drawn.at(48, 31), (255 >> 3 << 11) | (128 >> 2 << 5));
  EXPECT_EQ(drawn.at(48, 19), 255 >> 3);
}

TEST(Lines, AreRefusedWhereTheyWouldBeDrawnOtherwiseThanAskedFor) {
  const auto refused = [](auto change) {
    World world = World::in_pixels();
    world.line({0, 0, 0}, {100, 0, 0});
    world.scene();
    static constexpr Finish kFinish[1] = {};
    static constexpr std::uint16_t kTexel[1] = {};
    static constexpr Texture kTexture[1] = {{kTexel, 0, 0}};
    change(world);
    Scene scene = world.scene();
    scene.finishes = kFinish;
    scene.textures = kTexture;
    const Status status = validate(scene);
    return status.error == Error::lines && status.needed == 0;
  };
  EXPECT_FALSE(refused([](World&) {}));
  EXPECT_TRUE(refused([](World& w) { w.lines.width = 0; }));
  EXPECT_TRUE(refused([](World& w) { w.lines.width = kMaxLineWidth + 1; }));
  EXPECT_TRUE(refused([](World& w) { w.lines.mesh = 1; }));
  EXPECT_TRUE(refused([](World& w) { w.lines.material = 1; }));
  EXPECT_TRUE(refused([](World& w) { w.lines.transform.m[1][1] = Fixed{1} << 24; }));
  EXPECT_TRUE(refused([](World& w) { w.segments[0].a = 2; }));
  EXPECT_TRUE(refused([](World& w) { w.segments[0].b = 2; }));
  EXPECT_TRUE(refused([](World& w) { w.material.texture = 0; }));
  EXPECT_TRUE(refused([](World& w) { w.material.finish = 0; }));
  EXPECT_TRUE(refused([](World& w) { w.material.depth_slope_bias = 1; }));
  EXPECT_FALSE(refused([](World& w) { w.material.depth_bias = 5; }));
}

TEST(Lines, TakeMemoryOnlyWhereThereAreAny) {
  World world = World::in_pixels();
  world.line({0, 0, 0}, {100, 0, 0});
  Scene scene = world.scene();
  const auto bytes = [&] { return plan(count(scene), kView, effects_of(scene, world.camera)).plan.instance_bytes; };
  EXPECT_EQ(bytes(), kLineSetBytes);
  scene.lines = {};
  EXPECT_EQ(bytes(), 0U);
  EXPECT_EQ(without_shades(effects_of(scene, world.camera)), effect::orthographic);
}

}  // namespace
}  // namespace lines_test
