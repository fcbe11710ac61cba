// Anti-aliased edges: what strips, bins, meshlets, formats, memory and any numbers must not change.
#include <array>
#include <cmath>
#include <random>

#include "edges_scene.hpp"
#include "edges_world.hpp"
#include "zstrip/effects/exclusions.hpp"
#include "zstrip_scenes/stage.hpp"

namespace effects_test {
namespace {

TEST(Edges, NeitherStripsNorBinsChangeAPixel) {
  constexpr Effects kEffects = effects_of(scenes::edges.scene, scenes::edges.camera) | effect::bins;
  const View view{75, 58};
  scenes::Staged staged;
  scenes::stage(scenes::edges, staged, 3, 20, view);
  const Drawn whole = draw<kEffects>(staged.scene, staged.camera, view);
  Scene plain = staged.scene;
  plain.edges = {};
  EXPECT_NE(whole, draw<kEffects>(plain, staged.camera, view));
  for (const int rows : {1, 2, 7, 29, 58}) {
    for (const int columns : {8, 40, 75}) {
      for (const Modes mode : {Modes::streamed, Modes::binned}) {
        EXPECT_EQ(draw<kEffects>(staged.scene, staged.camera, view,
                                 {.strip_rows = static_cast<std::uint16_t>(rows),
                                  .strip_columns = static_cast<std::uint16_t>(columns),
                                  .modes = mode}),
                  whole)
            << rows << " rows, " << columns << " columns, " << (mode == Modes::binned ? "binned" : "streamed");
      }
    }
  }
}

TEST(Edges, MeshletsChangeNoPixel) {
  // Runs of triangles; edges between two runs look for one face's corner elsewhere, and some come in the wrong order.
  World world(zstrip::test::sphere(12, 16), false);
  world.add({0, 255, 0, 255}, turned_about_x_and_y(0.4, 0.2));
  const View view{64, 48};
  const Drawn whole = draw<effect::edges | effect::bins>(world.scene, near_camera(4), view, {.strip_rows = 9});
  std::vector<Meshlet> meshlets;
  for (std::uint16_t ring = 0; ring < 12; ++ring) {
    meshlets.push_back({.first_triangle = static_cast<std::uint32_t>(ring * 32),
                        .first_vertex = static_cast<std::uint16_t>(ring * 16),
                        .vertex_count = 32,
                        .triangle_count = 32,
                        .radius = 65535,
                        .centre = {}});
  }
  world.meshes[0].meshlets = meshlets;
  std::sort(world.edges.begin(), world.edges.end(), [](const Edge& a, const Edge& b) { return a.left < b.left; });
  for (const bool in_order : {true, false}) {
    if (!in_order) std::shuffle(world.edges.begin(), world.edges.end(), std::mt19937(3));
    for (const Modes mode : {Modes::streamed, Modes::binned}) {
      EXPECT_EQ(draw<effect::edges | effect::bins>(world.scene, near_camera(4), view, {.strip_rows = 9, .modes = mode}),
                draw<effect::edges | effect::bins>(world.scene, near_camera(4), view));
    }
    if (in_order) {
      world.sets[0].edges = world.edges;
    }
  }
  EXPECT_LT(share_of_error<effect::edges | effect::bins>(world.scene, near_camera(4), view), 0.6);
  EXPECT_FALSE(whole.pixels.empty());
}

TEST(Edges, OtherFormatsAreMadeOfTheBlendedPixels) {
  constexpr Effects kEffects = effects_of(scenes::edges.scene, scenes::edges.camera) | effect::bins;
  scenes::Staged staged;
  scenes::stage(scenes::edges, staged, 3, 20, kPixels);
  const Drawn pixels = draw<kEffects>(staged.scene, staged.camera, kPixels);
  for (const PixelFormat format :
       {PixelFormat::rgb565, PixelFormat::rgb565_swapped, PixelFormat::gray4, PixelFormat::mono, PixelFormat::rgb666,
        PixelFormat::rgb444, PixelFormat::xrgb8888}) {
    const View view = with_samples(kPixels, 1, format);
    std::vector<std::uint16_t> all = pixels.pixels;
    std::vector<std::uint8_t> expected(std::size_t{bytes_per_row(view.width, format)} * view.height);
    if (format == PixelFormat::rgb565 || format == PixelFormat::rgb565_swapped) {
      convert_pixels(format, view.width, view.height, all.data(), reinterpret_cast<std::byte*>(all.data()));
      std::memcpy(expected.data(), all.data(), expected.size());
    } else {
      convert_pixels(format, view.width, view.height, all.data(), reinterpret_cast<std::byte*>(expected.data()));
    }
    for (const std::uint16_t rows : {std::uint16_t{5}, view.height}) {
      const PlanResult planned = plan(count(staged.scene), view, kEffects, {.strip_rows = rows});
      ASSERT_TRUE(planned.status);
      Renderer<kEffects> renderer;
      EXPECT_EQ(bytes_by(renderer, staged.scene, staged.camera, view, planned.plan), expected)
          << static_cast<int>(format) << ", " << rows << " rows";
    }
  }
}

TEST(Edges, WhatDoesNotGoWithThemIsRefused) {
  constexpr Effects kOwn = effects_of(scenes::edges.scene, scenes::edges.camera);
  for (const Effects other : {effect::depth_24, effect::depth_float, effect::depth_ranges}) {
    EXPECT_FALSE(effects_agree(kOwn | other));
    EXPECT_EQ(plan(count(scenes::edges.scene), {75, 58}, kOwn | other).status.error, Error::edges);
  }
  for (const Effects way : {method::painter, method::front_to_back, method::hierarchical_z, method::midpoint,
                            method::midpoint_safe, method::culling}) {
    EXPECT_FALSE(methods_agree(kOwn | way));
  }
  EXPECT_EQ(plan(count(scenes::edges.scene), {75, 58, PixelFormat::rgb565, false, 2}, kOwn | effect::supersampled)
                .status.error,
            Error::edges);
  EXPECT_EQ(plan(count(scenes::edges.scene), {80, 56}, kOwn, {.layer = layer_bytes_worst({80, 56})}).status.error,
            Error::edges);

  static constexpr Effects kMore =
      without_shades(kOwn) | effect::lighting | effect::supersampled | effect::outlines | effect::csg;
  const Outline outline{};
  const CsgOperand operand{};
  const auto refused = [](const Scene& scene, const View& view) {
    Plan large = plan(count(scene), view, without(kMore, effect::edges)).plan;
    large.effect_bytes += 8192;  // room for the edges
    return begun(Renderer<kMore>(), scene, scenes::edges.camera, view, large).error;
  };
  Scene scene = scenes::edges.scene;
  EXPECT_EQ(refused(scene, {75, 58, PixelFormat::rgb565, false, 4}), Error::edges);
  scene.csg = {&operand, 1};
  EXPECT_EQ(refused(scene, {75, 58}), Error::edges);
  scene.csg = {};
  Mesh mesh = scene.meshes[0];
  mesh.outline = 1;
  scene.meshes = {&mesh, 1};
  scene.outlines = {&outline, 1};
  EXPECT_EQ(refused(scene, {75, 58}), Error::edges);
}

TEST(Edges, OnlyStripsThatWereDrawnWholeAreKept) {
  constexpr Effects kEffects = effects_of(scenes::edges.scene, scenes::edges.camera);
  const View view{80, 56};
  const Plan planned = plan(count(scenes::edges.scene), view, kEffects, {.strip_rows = 8}).plan;
  std::vector<std::byte> arena = lent(planned.bytes());
  Renderer<kEffects> renderer;
  ASSERT_TRUE(renderer.begin_frame(scenes::edges.scene, scenes::edges.camera, view, planned, arena));
  EXPECT_FALSE(renderer.frame().has_plain_depth());
  std::vector<std::uint16_t> pixels(std::size_t{80} * 56), depth(pixels.size());
  EXPECT_EQ(renderer.draw_over({0, 0, 80, 56}, pixels, depth).error, Error::edges);
}

TEST(Edges, WhatIsWrongWithASetIsFound) {
  const auto error_of = [](const Edge& edge, std::uint16_t mesh) {
    Scene scene = scenes::edges.scene;
    const EdgeSet set{{&edge, 1}, mesh};
    scene.edges = {&set, 1};
    return validate(scene).error;
  };
  constexpr auto kBeyond = static_cast<std::uint16_t>(scenes::kKnotVertices);
  EXPECT_EQ(error_of({0, 1, 2, 3}, 0), Error::none);
  EXPECT_EQ(error_of({0, 1, 2, kNoFace}, 0), Error::none);
  EXPECT_EQ(error_of({kBeyond, 1, 2, 3}, 0), Error::edges);
  EXPECT_EQ(error_of({0, kBeyond, 2, 3}, 0), Error::edges);
  EXPECT_EQ(error_of({0, 1, kBeyond, 3}, 0), Error::edges);
  EXPECT_EQ(error_of({0, 1, 2, kBeyond}, 0), Error::edges);
  EXPECT_EQ(error_of({0, 1, 2, 3}, 1), Error::edges);
  Scene twice = scenes::edges.scene;
  const EdgeSet sets[2] = {scenes::kKnotEdges[0], scenes::kKnotEdges[0]};
  twice.edges = sets;
  EXPECT_EQ(validate(twice), (Status{.error = Error::edges, .needed = 1}));
}

/// From the nearest code to the farthest in a sixteenth of a pixel: what comes behind its only middle left 32 bits.
TEST(Edges, DepthBehindAnEdgeThatIsSeenEndOnLeft32Bits) {
  std::array<std::uint16_t, 9> pixels{}, own{}, depth{};
  own.fill(0x7BEF);
  pixels = own;
  constexpr Rect kArea{0, 0, 3, 3};
  const detail::EdgeTarget target{kArea, pixels.data(), kArea, own.data(), kArea, depth.data()};
  detail::EdgeBlend<std::int32_t>::draw(target, {.a = {15, 20, 0x10000},
                                                 .b = {16, 21, 0xFFFE0000},
                                                 .third = {{40, 44, 0x10000}},
                                                 .faces = 1,
                                                 .crease = false,
                                                 .narrow = true});
  EXPECT_EQ(pixels, own);
}

/// Draws random edges into a picture, and into its strips: both have the same pixels, and visit the same number of
/// them.
template <class Int>
void expect_only_pixels_in_strips(std::int32_t reach) {
  constexpr Rect kPicture{-32, -24, 32, 24};
  constexpr std::size_t kPixels = 64 * 48;
  std::mt19937 random(17);
  std::vector<std::uint16_t> own(kPixels), whole(kPixels), parts(kPixels);
  const std::vector<std::uint16_t> depth(kPixels, 0x8000);
  for (std::uint16_t& pixel : own) pixel = static_cast<std::uint16_t>(random());
  std::uint32_t visited = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto place = [&] {
      const auto range = static_cast<std::uint32_t>(i % 2 == 0 ? reach : 900);
      return static_cast<std::int32_t>(random() % (2 * range)) - static_cast<std::int32_t>(range);
    };
    const auto corner = [&] { return detail::WidePosition{place(), place(), 0x80000000}; };
    const detail::SeenEdge edge{.a = corner(),
                                .b = corner(),
                                .third = {corner(), corner()},
                                .faces = 1,
                                .crease = false,
                                .narrow = sizeof(Int) == 4};
    if (edge.a.x == edge.b.x && edge.a.y == edge.b.y) continue;
    whole = parts = own;
    const auto draw = [&](const Rect& area, std::uint16_t* pixels) {
      return detail::EdgeBlend<Int>::draw({area, pixels, kPicture, own.data(), kPicture, depth.data()}, edge);
    };
    const std::uint32_t all = draw(kPicture, whole.data());
    std::uint32_t sum = 0;
    const int rows = i % 3 == 0 ? 1 : i % 3 == 1 ? 3 : 16;
    for (int top = 0; top < 48; top += rows) {
      sum += draw({-32, top - 24, 32, top + rows - 24}, parts.data() + top * 64);
    }
    ASSERT_EQ(sum, all) << i;
    ASSERT_EQ(parts, whole) << i;
    visited += all;
  }
  EXPECT_GT(visited, 10000U);
}

TEST(Edges, OnlyPixelsInTheStripAreVisited) {
  expect_only_pixels_in_strips<std::int32_t>(1 << 14);
  expect_only_pixels_in_strips<std::int64_t>(1 << 20);
}

TEST(Edges, EndsMayBeAnywhere) {
  // Random triangles and edges that need not be theirs, near and far, in and out of the picture: nothing may be read or
  // written beyond what is lent.
  std::mt19937 random(11);
  const auto anywhere = [&random] { return static_cast<std::int16_t>(random()); };
  for (int i = 0; i < 200; ++i) {
    World world(square(), false);
    for (Position& p : world.own.positions) p = {anywhere(), anywhere(), anywhere()};
    for (Edge& edge : world.edges) {
      const auto vertex = [&random] { return static_cast<std::uint16_t>(random() % 4); };
      edge = {vertex(), vertex(), vertex(), random() % 3 == 0 ? kNoFace : vertex()};
    }
    const double scale = std::pow(2.0, static_cast<double>(random() % 10) - 2);
    world.add({0, 255, 0, 255}, turned_about_x_and_y(0.1 * i, 0.3 * i, scale));
    world.materials[0].double_sided = i % 2 == 0;
    const View view{33, 21};
    const Camera camera = near_camera(std::pow(2.0, static_cast<double>(random() % 6) - 2));
    const Drawn whole = draw<effect::edges | effect::bins>(world.scene, camera, view);
    EXPECT_EQ(draw<effect::edges | effect::bins>(world.scene, camera, view, {.strip_rows = 4, .strip_columns = 16}),
              whole)
        << i;
    Camera parallel = camera;
    parallel.projection = Projection::orthographic;
    const Drawn flat = draw<kFlatEdges>(world.scene, parallel, view);
    EXPECT_EQ(draw<kFlatEdges>(world.scene, parallel, view, {.strip_rows = 4, .strip_columns = 16}), flat) << i;
  }
}

}  // namespace
}  // namespace effects_test
