// Shadows against rays in double precision: every pixel is that of the picture with the light or that of the picture
// without it, and the rays say which, but within a texel or so of a shadow's edge.
#include <algorithm>
#include <cmath>
#include <random>

#include "shadow_world.hpp"
#include "zstrip/effects/exclusions.hpp"

namespace effects_test {
namespace {

TEST(Shadows, AreWhereRaysDoNotReachTheLight) {
  int at_edge = 0, shadowed = 0;
  for (int turn = 0; turn < 8; ++turn) {
    World world;
    const double angle = turn * 0.785398;
    world.lights[0] = light_from(std::cos(angle) * (0.3 + 0.2 * turn), 1, std::sin(angle) * (0.3 + 0.2 * turn));
    SCOPED_TRACE(turn);
    const Judged judged = judged_with<kShadowed>(world);
    EXPECT_EQ(judged.neither, 0);
    EXPECT_EQ(judged.wrong, 0);
    EXPECT_GT(judged.shadowed, 100);
    at_edge += judged.at_edge;
    shadowed += judged.shadowed;
  }
  EXPECT_GT(shadowed, 4000);
  EXPECT_LT(at_edge, shadowed / 40) << "of " << shadowed;
}

TEST(Shadows, OfAnyLightCameraAndDepth) {
  World world;
  const auto expect_right = [](const Judged& judged, const char* what) {
    EXPECT_EQ(judged.neither, 0) << what;
    EXPECT_EQ(judged.wrong, 0) << what;
    EXPECT_GT(judged.shadowed, 100) << what;
  };
  expect_right(judged_with<kShadowed | effect::depth_24>(world), "z24");
  expect_right(judged_with<kShadowed | effect::depth_float>(world), "3.13");
  expect_right(judged_with<kShadowed | effect::bins>(world), "bins");
  world.shadow.light = 1;
  expect_right(judged_with<kShadowed>(world), "the second light");
  world.shadow.light = 0;
  world.shadow.log2_size = 6;
  expect_right(judged_with<kShadowed>(world), "a small map");
  world.shadow.log2_size = 10;
  expect_right(judged_with<kShadowed>(world), "a large map");
  world.camera.projection = Projection::orthographic;
  world.camera.focal = fixed(0.4);
  expect_right(judged_with<kShadowed | effect::orthographic>(world), "parallel rays");
  expect_right(judged_with<kShadowed | effect::orthographic | effect::depth_24>(world), "parallel rays, z24");
}

TEST(Shadows, OfWhatIsConvexDoNotLieOnIt) {
  // From all sides, by light from all sides: also where it only grazes a face.
  std::mt19937 random(7);
  std::uniform_real_distribution between(-1.0, 1.0);
  for (int i = 0; i < 120; ++i) {
    World world;
    world.scene.quadrics = {};
    world.scene.instances = std::span(world.instances).subspan(1 + static_cast<std::size_t>(i) % 2, 1);
    world.instances[1].transform = placed(0, 0, 0, 1.5, between(random) * 4);
    world.instances[2].transform = placed(0, 0, 0, 1);
    // Each face as bright as it faces the light: what faces away is the same with and without.
    world.materials[1].smooth = false;
    world.meshes[2] = world.ball.mesh();
    world.lights[0] = light_from(between(random), between(random), between(random));
    ASSERT_TRUE(orbit(world.camera, {0, 0, 0}, to_fixed(4.5), static_cast<Angle>(random() & 0xFFFF),
                      16384 + static_cast<Angle>(8000 * between(random))));
    world.shadow.log2_size = static_cast<std::uint8_t>(5 + i % 5);
    const Drawn drawn = draw<kShadowed>(world.scene, world.camera, kView);
    const Drawn lit = draw<without(kShadowed, effect::shadows)>(world.with_all_light(), world.camera, kView);
    int most = 0;
    for (std::size_t at = 0; at < drawn.pixels.size(); ++at) {
      most = std::max(most, difference(drawn.pixels[at], lit.pixels[at]));
    }
    // Light of 180 that grazes a face at less than a 32nd. Facets of the ball take the brightness of a corner, which
    // may face the light where they do not.
    EXPECT_LE(most, i % 2 == 0 ? 1 : 6) << i;
  }
}

TEST(Shadows, AreTheSameInStripsBinsAndSupersets) {
  for (const std::uint8_t samples : {std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{4}}) {
    World world;
    const View view{kView.width, kView.height, PixelFormat::rgb565, false, samples};
    constexpr Effects kSampled = kShadowed | effect::supersampled;
    const Drawn whole = draw<kSampled>(world.scene, world.camera, view);
    EXPECT_NE(draw<kSampled>(world.with_all_light(), world.camera, view), whole);
    EXPECT_EQ(draw<kSampled>(world.scene, world.camera, view, {.strip_rows = 7, .strip_columns = 40}), whole);
    EXPECT_EQ(draw<kSampled>(world.scene, world.camera, view, {.strip_rows = 1}), whole);
    EXPECT_EQ(draw_any(kSampled, world.scene, world.camera, view, {.strip_rows = 16}), whole);
    for (const std::uint16_t rows : {std::uint16_t{96}, std::uint16_t{9}}) {
      EXPECT_EQ((draw<kSampled | effect::bins>(world.scene, world.camera, view,
                                               {.strip_rows = rows, .modes = Modes::binned})),
                whole);
    }
  }
}

TEST(Shadows, OfMethodsThatFindTheZBuffersPixelsAreTheZBuffers) {
  World world;
  world.scene.quadrics = {};
  const Drawn plain = draw_any(kShadowed, world.scene, world.camera, kView);
  for (const Effects how : {method::front_to_back, method::hierarchical_z,
                            method::front_to_back | method::hierarchical_z, method::midpoint_safe, method::culling}) {
    for (const Modes modes : {Modes::streamed, Modes::binned}) {
      const Budget budget{.strip_rows = 24, .modes = modes};
      EXPECT_EQ(draw_any(kShadowed | effect::bins | how, world.scene, world.camera, kView, budget), plain)
          << how.methods << (modes == Modes::binned ? " binned" : "");
    }
  }
  EXPECT_EQ(refused_by_methods(effect::shadows | method::painter), effect::shadows);
  EXPECT_EQ(refused_by_methods(effect::shadows | method::midpoint), effect::shadows);
  EXPECT_EQ(refused_by_methods(effect::shadows | method::hierarchical_z), Effects{});
}

TEST(Shadows, WhatIsLitAtPixelsLosesTheLightAndItsHighlight) {
  const Finish finishes[] = {{.specular = {200, 200, 200, 255}, .shininess = 20}};
  for (const bool shines : {false, true}) {
    World world;
    for (Material& material : world.materials) {
      material.smooth = Shading::pixel;
      if (shines) material.finish = 0;
    }
    world.scene.finishes = finishes;
    world.scene.quadrics = {};
    constexpr Effects kLitAtPixels = effect::pixel_shading | effect::shadows;
    const Judged judged =
        shines ? judged_with<kLitAtPixels | effect::specular>(world) : judged_with<kLitAtPixels>(world);
    EXPECT_EQ(judged.neither, 0) << shines;
    EXPECT_EQ(judged.wrong, 0) << shines;
    EXPECT_GT(judged.shadowed, 100) << shines;
    EXPECT_TRUE(effects_of(world.scene, world.camera).has(kLitAtPixels));
  }
}

TEST(Shadows, FallFromWhatCastsOnWhatReceives) {
  World world;
  constexpr Effects kPlain = without(kShadowed, effect::shadows);
  const Drawn lit = draw<kPlain>(world.with_all_light(), world.camera, kView);
  const auto differ = [&](const Drawn& drawn) {
    int different = 0;
    for (std::size_t at = 0; at < lit.pixels.size(); ++at) different += drawn.pixels[at] != lit.pixels[at] ? 1 : 0;
    return different;
  };
  const int all = differ(draw<kShadowed>(world.scene, world.camera, kView));
  EXPECT_GT(all, 100);
  world.meshes[0].shadow = ShadowRole::none;
  EXPECT_EQ(differ(draw<kShadowed>(world.scene, world.camera, kView)), 0) << "all shadows fall on the floor";
  world.meshes[0].shadow = ShadowRole::only_receives;
  world.meshes[1].shadow = world.meshes[2].shadow = ShadowRole::only_receives;
  const int of_the_sphere = differ(draw<kShadowed>(world.scene, world.camera, kView));
  EXPECT_LT(of_the_sphere, all);
  EXPECT_GT(of_the_sphere, 20);
  world.scene.quadrics = {};
  EXPECT_EQ(draw<kShadowed>(world.scene, world.camera, kView),
            draw<kPlain>(world.with_all_light(), world.camera, kView))
      << "nothing casts";
}

TEST(Shadows, OfNothingAreNotShadedInBins) {
  World world;
  world.scene.quadrics = {};
  for (Mesh& mesh : world.meshes) mesh.shadow = ShadowRole::only_receives;
  const Budget binned{.strip_rows = 8, .modes = Modes::binned};
  EXPECT_EQ(draw_any(kShadowed | effect::bins, world.scene, world.camera, kView, binned),
            draw_any(without(kShadowed, effect::shadows), world.with_all_light(), world.camera, kView));
}

TEST(Shadows, TakeThePoolThatTheyAreGivenOrSayHowMuchTheyNeed) {
  World world;
  const SceneCounts worst = count(world.scene);
  EXPECT_EQ(worst.shadow_side, 256U);
  EXPECT_EQ(worst.shadow_pool, store_bytes_worst(256, 256));
  const Drawn drawn = draw<kShadowed>(world.scene, world.camera, kView);
  const auto begun_with = [&](std::uint32_t pool) {
    world.shadow.pool = pool;
    const Plan plan = zstrip::plan(count(world.scene), kView, kShadowed).plan;
    return begun(Renderer<kShadowed>(), world.scene, world.camera, kView, plan);
  };
  Status status = begun_with(8);
  EXPECT_EQ(status.error, Error::store_full) << "no room for the index";
  EXPECT_EQ(status.purpose, Purpose::effects);
  std::uint32_t enough = 2048;
  while (!(status = begun_with(enough))) {
    EXPECT_EQ(status.error, Error::store_full);
    EXPECT_EQ(status.purpose, Purpose::effects);
    ASSERT_LT(enough, worst.shadow_pool);
    enough += 1024;
  }
  EXPECT_LT(enough, worst.shadow_pool / 4) << "it is compressed";
  world.shadow.pool = enough;
  EXPECT_EQ(draw<kShadowed>(world.scene, world.camera, kView), drawn);
}

TEST(Shadows, TakeTheBytesThatThePlanSays) {
  World world;
  world.shadow.pool = 9000;
  for (const Modes modes : {Modes::streamed, Modes::binned}) {
    const Plan right =
        zstrip::plan(count(world.scene), kView, kShadowed | effect::bins, {.strip_rows = 8, .modes = modes}).plan;
    EXPECT_EQ(right.effect_bytes, 9000U + 2656 + 16);
    EXPECT_EQ(right.depth_bytes, 256U * 9 * 2) << "a strip of the map is larger than one of the picture";
    EXPECT_EQ(right.extent_bytes, 16U) << "three, rounded up";
  }
}

TEST(Shadows, WhatCannotBeIsRefused) {
  World world;
  ASSERT_TRUE(validate(world.scene));
  EXPECT_EQ(without_shades(effects_of(world.scene, world.camera)), kShadowed);
  EXPECT_EQ(without_shades(effects_of(world.with_all_light(), world.camera)), without(kShadowed, effect::shadows));
  const auto refused = [&] { return validate(world.scene).error == Error::shadow; };
  world.shadow.light = 2;
  EXPECT_TRUE(refused()) << "no such light";
  world.shadow.light = 1;
  EXPECT_FALSE(refused());
  for (const int log2 : {3, 11, 255}) {
    world.shadow.log2_size = static_cast<std::uint8_t>(log2);
    EXPECT_TRUE(refused()) << log2;
  }
  world.shadow.log2_size = 4;
  EXPECT_FALSE(refused());
  world.shadow.slope_bias = -1;
  EXPECT_TRUE(refused());
  world.shadow.slope_bias = 0;
  world.materials[1].depth_test = DepthTest::always;
  EXPECT_TRUE(refused()) << "a code nearer than any would not hide it";
  world.materials[1].depth_test = DepthTest::nearer_or_equal;
  EXPECT_FALSE(refused());
  world.meshes[0].shadow = static_cast<ShadowRole>(4);
  EXPECT_EQ(validate(world.scene).error, Error::mesh);
  world.meshes[0].shadow = ShadowRole::none;
  EXPECT_FALSE(effects_agree(effect::shadows | effect::depth_ranges));
  const Budget layer{.strip_rows = 8, .layer = {.depth = 4096, .colour = 4096}};
  EXPECT_EQ(plan(count(world.scene), kView, kShadowed, layer).status.error, Error::shadow);
  world.materials[1].depth_test = DepthTest::nearer;
  const Plan plan = zstrip::plan(count(world.scene), kView, kShadowed).plan;
  std::vector<std::byte> arena = lent(plan.bytes());
  Renderer<kShadowed> renderer;
  ASSERT_TRUE(renderer.begin_frame(world.scene, world.camera, kView, plan, arena));
  std::vector<std::uint16_t> pixels(64), depth(64);
  EXPECT_EQ(renderer.draw_over({0, 0, 8, 8}, pixels, depth).error, Error::shadow);
  EXPECT_FALSE(renderer.frame().has_plain_depth());
}

// The frame had begun in spite of the error, and drew without its shadow.
TEST(Shadows, TooSmallForThePictureDrawNothing) {
  World world;
  world.scene.instances = std::span(world.instances).first(2);
  world.scene.quadrics = {};
  world.meshes[0].half_extent = {fixed(4000), fixed(0.1), fixed(4000)};
  world.meshes[1].half_extent = {0, 0, 0};
  world.camera.far_plane = fixed(8000);
  world.shadow.log2_size = 10;
  const Plan plan = zstrip::plan(count(world.scene), kView, kShadowed).plan;
  Renderer<kShadowed> renderer;
  EXPECT_EQ(begun(renderer, world.scene, world.camera, kView, plan).error, Error::shadow);
  std::vector<std::byte> pixels = lent(plan.strip_pixel_bytes(kView));
  EXPECT_EQ(renderer.draw_strip(0, pixels).error, Error::not_begun);
}

TEST(Shadows, OfLightFromAnywhereAndOfNothing) {
  // Straight down, along an axis, without a direction; what casts is a point, a sheet, far away.
  World world;
  for (const auto& [x, y, z] :
       {std::array{0, 32767, 0}, {0, -32767, 0}, {32767, 0, 0}, {0, 0, -32767}, {0, 0, 0}, {1, 0, 0}}) {
    world.lights[0].x = static_cast<std::int16_t>(x);
    world.lights[0].y = static_cast<std::int16_t>(y);
    world.lights[0].z = static_cast<std::int16_t>(z);
    for (const Fixed thickness : {0, 1, kFixedOne}) {
      world.meshes[1].half_extent.y = thickness;
      const Drawn whole = draw<kShadowed>(world.scene, world.camera, kView);
      EXPECT_EQ(draw<kShadowed>(world.scene, world.camera, kView, {.strip_rows = 10}), whole);
    }
  }
  world.scene.instances = std::span(world.instances).first(2);
  world.scene.quadrics = {};
  world.meshes[1].half_extent = {0, 0, 0};
  static_cast<void>(draw<kShadowed>(world.scene, world.camera, kView));
}

}  // namespace
}  // namespace effects_test
