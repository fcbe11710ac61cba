// CSG against rays in double precision, and against pictures of the same surfaces without products.
#include "csg_world.hpp"
#include "zstrip/effects/exclusions.hpp"
#include "zstrip/layer.hpp"

namespace effects_test {
namespace {

/// A block within a ball, less a ring and a ball: faces of all four, concave ones among them.
void make_part(CsgWorld& world) {
  const std::uint16_t block = world.add(CsgWorld::kBox, posed(0, 0, 0, 1, 0.4, 0.2));
  const std::uint16_t hull = world.add(CsgWorld::kBall, posed(0.1, 0, 0, 1.35));
  const std::uint16_t groove = world.add(CsgWorld::kRing, posed(0, 0.2, 0.1, 1.5, 0.3, 1.2));
  const std::uint16_t bore = world.add(CsgWorld::kBall, posed(0.8, 0.6, 0.7, 0.7));
  world.intersect(block);
  world.subtract(groove);
  world.intersect(hull);
  world.subtract(bore);
}

TEST(Csg, ProductsAreWhatRaysSee) {
  for (int turn = 0; turn < 8; ++turn) {
    SCOPED_TRACE(turn);
    CsgWorld world;
    make_part(world);
    world.look(static_cast<Angle>(8192 * turn), static_cast<Angle>(4000 + 3500 * turn));
    expect_right(world, draw<effect::csg>(world.whole(), world.camera, kCsgView), "z16");
  }
}

TEST(Csg, OfAnyCameraAndDepth) {
  CsgWorld world;
  make_part(world);
  world.look(5000, 9000);
  const Scene& scene = world.whole();
  expect_right(world, draw<effect::csg | effect::depth_24>(scene, world.camera, kCsgView), "z24");
  expect_right(world, draw<effect::csg | effect::depth_float>(scene, world.camera, kCsgView), "3.13");
  expect_right(world, draw<effect::csg | effect::depth_ranges>(scene, world.camera, kCsgView, {.strip_rows = 16}),
               "sub-ranges");
  world.camera.projection = Projection::orthographic;
  world.camera.focal = fixed(0.4);
  expect_right(world, draw<effect::csg | effect::orthographic>(scene, world.camera, kCsgView), "parallel rays");
  expect_right(world, draw<effect::csg | effect::orthographic | effect::depth_24>(scene, world.camera, kCsgView),
               "parallel rays, z24");
}

TEST(Csg, AUnionIsSeveralProductsThatShareOperands) {
  // (ring | box) - ball, and beside it what one of two solids has and the other not.
  CsgWorld world;
  const std::uint16_t box = world.add(CsgWorld::kBox, posed(-0.6, 0, 0, 0.6, 0.5, 0.3));
  const std::uint16_t hoop = world.add(CsgWorld::kRing, posed(-0.3, 0.1, 0, 0.9, 0.2, 0.4));
  const std::uint16_t hole = world.add(CsgWorld::kBall, posed(-0.5, 0.4, 0.5, 0.5));
  const std::uint16_t one = world.add(CsgWorld::kBox, posed(1.1, 0.2, 0, 0.5, 0.3, 0.9));
  const std::uint16_t other = world.add(CsgWorld::kBall, posed(1.2, 0.5, 0.2, 0.55));
  world.intersect(box, 2);
  world.subtract(hole, 2);
  world.intersect(hoop, 3);
  world.subtract(hole, 3);
  world.intersect(one, 7);
  world.subtract(other, 7);
  world.subtract(one, 8);
  world.intersect(other, 8);
  for (int turn = 0; turn < 6; ++turn) {
    world.look(static_cast<Angle>(10923 * turn), static_cast<Angle>(5000 + 4000 * turn));
    expect_right(world, draw<effect::csg>(world.whole(), world.camera, kCsgView), "union");
  }
}

// Dots, where its code was that of another product's surface.
TEST(Csg, AFaceThatIsCutAwayDoesNotShowOnAnotherProduct) {
  // A ring, and through it a ball, whose surface crosses that of a smaller one, which touches nothing of the ring that
  // it is subtracted from.
  const auto drawn_with = [](bool smaller, int turn) {
    CsgWorld world;
    world.intersect(world.add(CsgWorld::kBall, posed(0, 0, 0, 1)), 0);
    world.intersect(world.add(CsgWorld::kRing, posed(0, 0, 1.5, 1.2)), 1);
    if (smaller) world.subtract(world.add(CsgWorld::kBall, posed(0, 0, 1.3, 0.4)), 1);
    EXPECT_TRUE(look_at(world.camera, {kFixedOne / 8 * turn, kFixedOne / 5, 6 * kFixedOne}, {0, 0, kFixedOne},
                        {0, kFixedOne, 0}));
    world.camera.focal = 4 * kFixedOne;
    world.camera.fixed_depth_range = true;
    world.camera.near_plane = kFixedOne / 16;  // a code is a 160th of a unit there
    return draw<effect::csg>(world.whole(), world.camera, kCsgView);
  };
  for (int turn = 0; turn < 5; ++turn) EXPECT_EQ(drawn_with(true, turn), drawn_with(false, turn)) << turn;
}

TEST(Csg, WhatIsConcaveHasSeveralLayers) {
  // Rings seen along their planes, which rays enter twice; only the far part of the first is left.
  CsgWorld world;
  const std::uint16_t outer = world.add(CsgWorld::kRing, posed(0, 0, 0, 1.3, 0, 1.3));
  const std::uint16_t inner = world.add(CsgWorld::kRing, posed(0.2, 0, 0, 1.2, 0, 1.4));
  const std::uint16_t near_half = world.add(CsgWorld::kBall, posed(0, 0, 1.4, 1.3));
  world.intersect(outer);
  world.subtract(inner);
  world.subtract(near_half);
  for (int turn = 0; turn < 4; ++turn) {
    world.look(static_cast<Angle>(2000 * turn), static_cast<Angle>(14000 + 800 * turn));
    expect_right(world, draw<effect::csg>(world.whole(), world.camera, kCsgView), "rings", 150);
  }
}

TEST(Csg, TheCameraMayBeInsideOfOperands) {
  // In a hollow ball inside a block: it is seen from inside, and through the hole that a box has cut.
  CsgWorld world;
  const std::uint16_t block = world.add(CsgWorld::kBox, posed(0, 0, 0, 3, 0.3));
  const std::uint16_t hollow = world.add(CsgWorld::kBall, posed(0, 0, 0, 2.5));
  const std::uint16_t window = world.add(CsgWorld::kBox, posed(0, 0, -3, 0.8, 0.2));
  const std::uint16_t post = world.add(CsgWorld::kBall, posed(0.7, 0.3, -1, 0.4));
  world.intersect(block);
  world.subtract(hollow);
  world.subtract(window);
  world.intersect(post, 1);
  ASSERT_TRUE(look_at(world.camera, {0, 0, kFixedOne / 2}, {0, 0, -kFixedOne}, {0, kFixedOne, 0}));
  world.camera.focal = kFixedOne;
  world.camera.near_plane = kFixedOne / 16;
  expect_right(world, draw<effect::csg>(world.whole(), world.camera, kCsgView), "from inside", 5000);
}

TEST(Csg, TheFarPlaneMayCutWhatTheNearPlaneDoesNot) {
  // What says that the surface is one lies behind the plane.
  CsgWorld world;
  make_part(world);
  world.look(5000, 9000);
  world.camera.far_plane = fixed(6.2);
  expect_right(world, draw<effect::csg>(world.whole(), world.camera, kCsgView), "cut");
}

TEST(Csg, AreTheSameInStripsAndBins) {
  CsgWorld world;
  make_part(world);
  world.add(CsgWorld::kBox, posed(-0.9, -0.6, 0.8, 0.3));  // and something that is no operand
  const Scene& scene = world.whole();
  for (const std::uint8_t samples : {std::uint8_t{1}, std::uint8_t{4}}) {
    const View view{kCsgView.width, kCsgView.height, PixelFormat::rgb565, false, samples};
    constexpr Effects kEffects = effect::csg | effect::supersampled | effect::bins;
    const Drawn whole = draw<kEffects>(scene, world.camera, view, {.modes = Modes::streamed});
    if (samples == 1) expect_right(world, whole, "whole");
    for (const Modes modes : {Modes::streamed, Modes::binned}) {
      for (const std::uint16_t rows : {std::uint16_t{1}, std::uint16_t{7}, std::uint16_t{96}}) {
        EXPECT_EQ((draw<kEffects>(scene, world.camera, view, {.strip_rows = rows, .modes = modes})), whole) << rows;
      }
      EXPECT_EQ((draw<kEffects>(scene, world.camera, view, {.strip_rows = 20, .strip_columns = 24, .modes = modes})),
                whole);
    }
  }
}

// Meshlets were counted in the scene's order, but their strips were noted in that of drawing, in which what blends is
// last.
TEST(Csg, WhatBlendsLeavesOperandsInTheirStrips) {
  const Finish finishes[] = {{.alpha_mode = AlphaMode::blend}};
  CsgWorld world;
  const std::uint16_t glass = world.add(CsgWorld::kBox, posed(0, 1.2, 0, 0.2));
  world.materials[glass].finish = 0;
  world.materials[glass].colour.a = 100;
  make_part(world);
  world.scene.finishes = finishes;
  const Scene& scene = world.whole();
  constexpr Effects kEffects = effect::csg | effect::blending | effect::bins;
  const Drawn whole = draw_any(kEffects, scene, world.camera, kCsgView, {.strip_rows = 96, .modes = Modes::streamed});
  for (const Modes modes : {Modes::streamed, Modes::binned}) {
    EXPECT_EQ(draw_any(kEffects, scene, world.camera, kCsgView, {.strip_rows = 7, .modes = modes}), whole);
  }
}

TEST(Csg, OneOperandIsTheInstance) {
  CsgWorld world;
  const std::uint16_t hoop = world.add(CsgWorld::kRing, posed(0, 0, 0, 1.3, 0.5, 0.8));
  world.add(CsgWorld::kBall, posed(0.5, 0.2, 0.3, 0.6));
  const Drawn plain = draw<effect::csg>(world.whole(), world.camera, kCsgView);
  world.intersect(hoop);
  EXPECT_EQ((draw<effect::csg>(world.whole(), world.camera, kCsgView)), plain);
}

TEST(Csg, WhatCoincidesIsJustBehindItsSurface) {
  CsgWorld world;
  const std::uint16_t box = world.add(CsgWorld::kBox, posed(0, 0, 0, 1, 0.5, 0.3));
  const std::uint16_t same = world.add(CsgWorld::kBox, posed(0, 0, 0, 1, 0.5, 0.3));
  world.materials[same].colour = world.materials[box].colour;
  const std::vector<std::uint16_t> nothing(std::size_t{kCsgView.width} * kCsgView.height,
                                           detail::rgb565(world.scene.background));
  const Drawn plain = draw<effect::csg>(world.whole(), world.camera, kCsgView);
  ASSERT_NE(plain.pixels, nothing);
  world.intersect(box);
  world.subtract(same);
  EXPECT_EQ((draw<effect::csg>(world.whole(), world.camera, kCsgView).pixels), nothing) << "A - A";
  world.operands[1].use = CsgUse::intersected;
  EXPECT_EQ((draw<effect::csg>(world.whole(), world.camera, kCsgView)), plain) << "A & A";
}

TEST(Csg, TheOrderOfOperandsDoesNotMatter) {
  CsgWorld world;
  make_part(world);
  const Drawn drawn = draw<effect::csg>(world.whole(), world.camera, kCsgView);
  std::swap(world.operands[0], world.operands[3]);
  std::swap(world.operands[1], world.operands[2]);
  EXPECT_EQ((draw<effect::csg>(world.whole(), world.camera, kCsgView)), drawn);
}

TEST(Csg, OfMethodsThatFindTheZBuffersPixelsAreTheZBuffers) {
  CsgWorld world;
  make_part(world);
  world.add(CsgWorld::kBox, posed(-0.9, -0.6, 0.8, 0.3));
  world.add(CsgWorld::kRing, posed(0.5, 0.4, -1.2, 0.9));
  const Scene& scene = world.whole();
  const Drawn plain = draw_any(effect::csg, scene, world.camera, kCsgView);
  expect_right(world, plain, "the z-buffer");
  for (const Effects how : {method::front_to_back, method::hierarchical_z,
                            method::front_to_back | method::hierarchical_z, method::midpoint_safe, method::culling}) {
    for (const Modes modes : {Modes::streamed, Modes::binned}) {
      const Budget budget{.strip_rows = 24, .modes = modes};
      EXPECT_EQ(draw_any(effect::csg | effect::bins | how, scene, world.camera, kCsgView, budget), plain)
          << how.methods << (modes == Modes::binned ? " binned" : "");
    }
  }
  EXPECT_EQ(refused_by_methods(effect::csg | method::painter), effect::csg);
  EXPECT_EQ(refused_by_methods(effect::csg | method::midpoint), effect::csg);
  EXPECT_EQ(refused_by_methods(effect::csg | method::hierarchical_z), Effects{});
}

/// Of RGB565, the largest difference of a channel, of 31.
int difference(std::uint16_t a, std::uint16_t b) {
  const auto apart = [](int one, int other) { return std::abs(one - other); };
  return std::max({apart(a >> 11, b >> 11), apart(a >> 6 & 31, b >> 6 & 31), apart(a & 31, b & 31)});
}

TEST(Csg, WhatASubtractedSolidLeavesIsLitAsThatSurfaceFromInside) {
  // The camera and a ball in a block: of the block less the ball the far side of the ball is seen.
  const DirectionalLight lights[] = {{.x = 20000, .y = 22000, .z = 14000}, {.x = -30000, .y = 0, .z = -13000}};
  const PunctualLight punctual[] = {{.colour = {255, 120, 60, 255}, .position = {0, kFixedOne / 2, kFixedOne / 4}}};
  const Finish finishes[] = {{.specular = {200, 200, 200, 255}, .shininess = 12},
                             {.filter = TextureFilter::environment_nearest}};
  std::vector<std::uint16_t> texels(64);
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::uint16_t>(i * 1021);
  const Texture textures[] = {{.texels = texels, .log2_width = 3, .log2_height = 3}};
  const Material materials[] = {{.colour = {230, 220, 200, 255}},
                                {.colour = {230, 220, 200, 255}, .finish = 0},
                                {.colour = {230, 220, 200, 255}, .smooth = Shading::pixel, .finish = 0},
                                {.colour = {230, 220, 200, 255}, .smooth = Shading::pixel},
                                {.texture = 0, .lit = false, .finish = 1}};
  for (const bool is_local : {false, true}) {
    for (std::size_t i = 0; i < std::size(materials); ++i) {
      SCOPED_TRACE(i);
      CsgWorld world;
      const OwnMesh inside_out = turned_inside_out(world.ball);
      world.intersect(world.add(CsgWorld::kBox, posed(0, 0, 0, 20)));
      world.subtract(world.add(CsgWorld::kBall, posed(0.1, 0, 0, 1.5)));
      world.materials[1] = materials[i];
      world.camera.fixed_depth_range = true;
      world.scene.lights = lights;
      world.scene.finishes = finishes;
      world.scene.textures = textures;
      if (is_local) world.scene.punctual_lights = punctual;
      const Scene& product = world.whole();
      Scene surface = product;
      const Mesh mesh = inside_out.mesh();
      const Instance instance{0, 1, world.instances[1].transform};
      surface.meshes = {&mesh, 1};
      surface.instances = {&instance, 1};
      surface.csg = {};
      ASSERT_TRUE(validate(product));
      const Drawn drawn = draw_any(effects_of(product, world.camera), product, world.camera, kCsgView);
      const Drawn wanted = draw_any(effects_of(surface, world.camera), surface, world.camera, kCsgView);
      int most = 0, colours = 0;
      for (std::size_t at = 0; at < drawn.pixels.size(); ++at) {
        most = std::max(most, difference(drawn.pixels[at], wanted.pixels[at]));
        colours += at != 0 && wanted.pixels[at] != wanted.pixels[at - 1] ? 1 : 0;
      }
      EXPECT_GT(colours, 300);
      EXPECT_LE(most, 1);  // small triangles have planes of fewer bits
    }
  }
}

TEST(Csg, PlansHaveRoomForTheLayersOfAStrip) {
  CsgWorld world;
  make_part(world);
  const Scene& scene = world.whole();
  const auto bytes = [&](Effects effects, const View& view) {
    return plan(count(scene), view, effects, {.strip_rows = 11}).plan.effect_bytes;
  };
  constexpr std::uint32_t kCells = 11 * 128;
  EXPECT_EQ(bytes(effect::csg, kCsgView), 16 + 8 + 4 * 16 + kCells * 6);
  EXPECT_EQ(bytes(effect::csg | effect::depth_24, kCsgView), 16 + 8 + 4 * 16 + kCells * 10);
  EXPECT_EQ(bytes(effect::csg | effect::supersampled, {128, 96, PixelFormat::rgb565, false, 4}),
            16 + 8 + 4 * 16 + 4 * kCells * 6);
}

TEST(Csg, WhatCannotBeCombinedIsRefused) {
  const auto status_with = [](const auto& change) {
    CsgWorld world;
    make_part(world);
    world.whole();
    change(world);
    world.scene.csg = world.operands;
    return validate(world.scene);
  };
  const auto refused_at = [](std::uint32_t operand) { return Status{.error = Error::csg, .needed = operand}; };
  EXPECT_TRUE(status_with([](CsgWorld&) {}));
  EXPECT_EQ(status_with([](CsgWorld& w) { w.operands[2].instance = 4; }), refused_at(2)) << "no instance";
  EXPECT_EQ(status_with([](CsgWorld& w) { w.operands[1].use = static_cast<CsgUse>(2); }), refused_at(1)) << "no use";
  EXPECT_EQ(status_with([](CsgWorld& w) { w.operands[0].product = 1; }), refused_at(1)) << "descending";
  EXPECT_EQ(status_with([](CsgWorld& w) { w.operands[3].product = 1; }), refused_at(3)) << "nothing to subtract from";
  EXPECT_EQ(status_with([](CsgWorld& w) { w.meshes[CsgWorld::kRing].billboard = Billboard::viewer; }), refused_at(1));
  EXPECT_EQ(status_with([](CsgWorld& w) { w.materials[1].depth_bias = 1; }), refused_at(2));
  static const Finish kBlended[] = {{.alpha_mode = AlphaMode::blend}};
  EXPECT_EQ(status_with([](CsgWorld& w) { w.scene.finishes = kBlended, w.materials[3].finish = 0; }), refused_at(3));
  static const Outline kOutline[] = {{}};
  EXPECT_EQ(status_with([](CsgWorld& w) { w.scene.outlines = kOutline, w.meshes[CsgWorld::kBox].outline = 1; }),
            refused_at(0));
  EXPECT_EQ(status_with([](CsgWorld& w) { w.operands.resize(kMaxCsgOperands + 1); }).error, Error::csg) << "too many";
  static const Shadow kShadow{};
  static const DirectionalLight kLights[] = {{}};
  EXPECT_EQ(status_with([](CsgWorld& w) { w.scene.shadow = &kShadow, w.scene.lights = kLights; }).error, Error::csg);
}

TEST(Csg, WhatIsDrawnOverALayerIsRefused) {
  CsgWorld world;
  make_part(world);
  const Scene& scene = world.whole();
  EXPECT_EQ(without_shades(effects_of(scene, world.camera)), effect::csg);
  const Plan whole = plan(count(scene), kCsgView, effect::csg, {}).plan;
  std::vector<std::byte> arena = lent(whole.bytes());
  Renderer<effect::csg> renderer;
  ASSERT_TRUE(renderer.begin_frame(scene, world.camera, kCsgView, whole, arena));
  std::vector<std::uint16_t> pixels(64), depth(64);
  EXPECT_EQ(renderer.draw_over({0, 0, 8, 8}, pixels, depth), (Status{.error = Error::csg, .needed = 4}));
}

TEST(Csg, AStaticLayerKeepsProducts) {
  CsgWorld world;
  make_part(world);
  const Scene& scene = world.whole();
  const PlanResult planned =
      plan(count(scene), kCsgView, effect::csg, {.strip_rows = 96, .layer = layer_bytes_worst(kCsgView)});
  ASSERT_TRUE(planned.status);
  std::vector<std::byte> arena = lent(planned.plan.bytes());
  Renderer<effect::csg> renderer;
  const picture::Picture drawn = picture::draw(renderer, scene, world.camera, kCsgView, planned.plan, {.arena = arena});
  ASSERT_TRUE(drawn.status);
  std::vector<std::byte> depth_pool(layer_bytes_worst(kCsgView).depth), colour_pool(depth_pool.size());
  std::vector<std::uint32_t> dirty(dirty_tile_words(128, 96));
  StaticLayer layer;
  ASSERT_TRUE(layer.reset({depth_pool, colour_pool, dirty}, kCsgView));
  ASSERT_TRUE(layer.keep(renderer.frame(), 0, drawn.pixels));
  std::vector<std::uint16_t> kept(std::size_t{128} * 96), depth(kept.size());
  ASSERT_TRUE(layer.restore({0, 0, 128, 96}, kept, depth));
  EXPECT_EQ(kept, rgb565_of(drawn));
  const std::uint16_t background = detail::rgb565(scene.background);
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(depth[i] != 0, kept[i] != background) << i;
}

}  // namespace
}  // namespace effects_test
