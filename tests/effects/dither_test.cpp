// Dithered pictures: in formats with fewer bits than RGB565 what their RGB565 says, and in RGB565 gradients, fog and
// spheres by the definition, whatever the strips.
#include "zstrip/effects/dithering/dither.hpp"
#include "dither_oracle.hpp"
#include "drawn.hpp"
#include "zstrip_scenes/effect_scenes.hpp"
#include "zstrip_scenes/spheres.hpp"
#include "zstrip_scenes/stage.hpp"

namespace effects_test::dither_test {
namespace {

constexpr View kPlain{75, 58, PixelFormat::rgb565};
constexpr View kView{75, 58, PixelFormat::rgb565, true};

View as_dithered(PixelFormat format) { return {kView.width, kView.height, format, true}; }

/// Level of each pixel of a picture in mono or gray4, from strips by the host's pipeline.
std::vector<int> levels(const scenes::Staged& staged, PixelFormat format, const Budget& budget, Effects method = {}) {
  const View view = as_dithered(format);
  const Effects effects = effects_of(staged.scene, staged.camera) | effects_of(view) | effect::bins | method;
  const picture::Picture drawn = picture::draw(effects, staged.scene, staged.camera, view, budget);
  EXPECT_TRUE(drawn.status);
  const int bits = format == PixelFormat::mono ? 1 : 4;
  const auto row_bytes = static_cast<int>(bytes_per_row(view.width, format));
  std::vector<int> levels;
  for (int y = 0; y < view.height; ++y) {
    for (int bit = 0; bit < bits * view.width; bit += bits) {
      const auto byte = std::to_integer<int>(drawn.pixels.at(static_cast<std::size_t>(y * row_bytes + bit / 8)));
      levels.push_back(byte >> (8 - bits - bit % 8) & ((1 << bits) - 1));
    }
  }
  return levels;
}

TEST(Dithering, FormatsWithFewerBitsAreThoseOfTheWholePictureInAnyStrips) {
  scenes::Staged staged;
  scenes::stage(scenes::room, staged, 3, 20, kPlain);
  const Drawn colours = draw_any(effects_of(staged.scene, staged.camera), staged.scene, staged.camera, kPlain);
  for (const PixelFormat format : {PixelFormat::mono, PixelFormat::gray4}) {
    std::vector<int> expected;
    for (int y = 0; y < kPlain.height; ++y) {
      for (int x = 0; x < kPlain.width; ++x) {
        const int pixel = colours.at(x, y), r = pixel / 2048, g = pixel / 32 % 64, b = pixel % 32;
        const int grey = (77 * (r * 8 + r / 4) + 150 * (g * 4 + g / 16) + 29 * (b * 8 + b / 4) + 128) / 256;
        expected.push_back(dither_oracle::level(grey, format == PixelFormat::mono ? 1 : 4, x, y));
      }
    }
    EXPECT_EQ(levels(staged, format, {}), expected);
    EXPECT_EQ(levels(staged, format, {.strip_rows = 1}), expected);
    EXPECT_EQ(levels(staged, format, {.strip_rows = 7, .strip_columns = 24}), expected);
    EXPECT_EQ(levels(staged, format, {.strip_rows = 9, .modes = Modes::binned}), expected);
  }
}

TEST(Dithering, FormatsWithFewerBitsAreDitheredWithMethodsToo) {
  scenes::Staged staged;
  scenes::stage(scenes::knot, staged, 3, 20, kPlain);
  for (const Effects method : {method::front_to_back, method::hierarchical_z, method::culling}) {
    EXPECT_EQ(levels(staged, PixelFormat::mono, {}, method), levels(staged, PixelFormat::mono, {}));
  }
}

Camera facing() {
  Camera camera;
  camera.projection = Projection::orthographic;
  camera.focal = kFixedOne;
  return camera;
}

/// A square that fills a square picture, with colours at its corners.
struct Square {
  Position positions[4] = {{-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}, {-32767, 32767, 0}};
  Colour colours[4];  ///< lower left, lower right, upper right, upper left
  Triangle triangles[2] = {{0, 1, 2}, {0, 2, 3}};
  Mesh mesh;
  Material material{.lit = false};
  Instance instance{};
  Scene scene;

  Square(const Colour& left, const Colour& right) : colours{left, right, right, left} {
    mesh.positions = positions;
    mesh.colours = colours;
    mesh.triangles = triangles;
    mesh.half_extent = {fixed(1.00004), fixed(1.00004), 0};
    scene.meshes = {&mesh, 1};
    scene.materials = {&material, 1};
    scene.instances = {&instance, 1};
  }
};

constexpr View kSquare{64, 64, PixelFormat::rgb565};
constexpr View kSquareDithered{64, 64, PixelFormat::rgb565, true};
constexpr Effects kGradient = effect::orthographic | effect::gouraud | effect::vertex_colours;

void expect_pattern(const Drawn& drawn, const Colour& c) {
  for (int y = 0; y < drawn.height; ++y) {
    for (int x = 0; x < drawn.width; ++x) {
      ASSERT_EQ(drawn.at(x, y), dither_oracle::rgb565(c.r, c.g, c.b, x, y)) << x << ", " << y;
    }
  }
}

TEST(Dithering, OneColourIsItsPattern) {
  for (const Colour colour : {Colour{0, 0, 0, 255}, {255, 255, 255, 255}, {100, 101, 102, 255}, {3, 250, 129, 255}}) {
    Square square(colour, colour);
    expect_pattern(draw<kGradient | effect::dithered_colours>(square.scene, facing(), kSquareDithered), colour);
  }
}

TEST(Dithering, AGradientsMeansAreThoseOfTheGradient) {
  Square square({40, 60, 80, 255}, {72, 76, 96, 255});  // half a step of 8 bits a pixel: four of RGB565's in all
  const Drawn dithered = draw<kGradient | effect::dithered_colours>(square.scene, facing(), kSquareDithered);
  const Drawn plain = draw<kGradient>(square.scene, facing(), kSquare);
  double worst = 0, worst_plain = 0;
  for (int left = 0; left < 64; left += 8) {
    const auto error = [&](const Drawn& drawn) {
      double sum = 0;
      for (int y = 0; y < 8; ++y) {
        for (int x = left; x < left + 8; ++x) sum += (drawn.at(x, y) >> 11) * 255 / 31.0;
      }
      return std::abs(sum / 64 - (40 + 32 * (left + 4) / 64.0));
    };
    worst = std::max(worst, error(dithered));
    worst_plain = std::max(worst_plain, error(plain));
  }
  // The scale on which both ends are levels rounds v / 32 down, and vertices have 8 bits.
  EXPECT_LT(worst, 1.25);
  EXPECT_GT(worst_plain, 3);
}

TEST(Dithering, PicturesAreTheSameInStripsBinsAndSupersets) {
  const auto check = [](const scenes::BuiltIn& built_in, const auto& exact, bool changes) {
    SCOPED_TRACE(built_in.name);
    scenes::Staged staged;
    scenes::stage(built_in, staged, 3, 20, kView);
    const Effects effects = effects_of(staged.scene, staged.camera) | effects_of(kView);
    const Drawn whole = exact(staged, Budget{});
    EXPECT_EQ(exact(staged, {.strip_rows = 1}), whole);
    EXPECT_EQ(exact(staged, {.strip_rows = 7, .strip_columns = 24}), whole);
    EXPECT_EQ(draw_any(effects, staged.scene, staged.camera, kView, {.strip_rows = 11}), whole);
    EXPECT_EQ(
        draw_any(effects | effect::bins, staged.scene, staged.camera, kView, {.strip_rows = 9, .modes = Modes::binned}),
        whole);
    // A pipeline that can dither draws what is not to be dithered as ever, and what has no gradient.
    const Drawn plain = draw_any(without(effects, effect::dithered_colours), staged.scene, staged.camera, kPlain);
    EXPECT_EQ(draw_any(effects, staged.scene, staged.camera, kPlain), plain);
    EXPECT_EQ(whole != plain, changes);
  };
  const auto knot = [](const scenes::Staged& staged, const Budget& budget) {
    return draw<effects_of(scenes::knot.scene, scenes::knot.camera) | effects_of(kView)>(staged.scene, staged.camera,
                                                                                         kView, budget);
  };
  const auto fog = [](const scenes::Staged& staged, const Budget& budget) {
    return draw<effects_of(scenes::fog.scene, scenes::fog.camera) | effects_of(kView)>(staged.scene, staged.camera,
                                                                                       kView, budget);
  };
  const auto spheres = [](const scenes::Staged& staged, const Budget& budget) {
    return draw<effects_of(scenes::spheres.scene, scenes::spheres.camera) | effects_of(kView)>(
        staged.scene, staged.camera, kView, budget);
  };
  const auto cube = [](const scenes::Staged& staged, const Budget& budget) {
    return draw<effects_of(scenes::cube.scene, scenes::cube.camera) | effects_of(kView)>(staged.scene, staged.camera,
                                                                                         kView, budget);
  };
  check(scenes::knot, knot, true);
  check(scenes::fog, fog, true);
  check(scenes::spheres, spheres, true);
  check(scenes::cube, cube, false);  // flat, without fog
}

TEST(Dithering, WhatFogHidesMeetsTheBackground) {
  const Colour grey{101, 102, 107, 255};
  Square square({255, 0, 0, 255}, {0, 255, 0, 255});
  square.instance.transform.m[0][0] = square.instance.transform.m[1][1] = fixed(0.5);
  const Fog fog{.colour = grey, .start = 0, .end = fixed(0.01)};
  square.scene.fog = &fog;
  square.scene.background = grey;
  expect_pattern(draw<kGradient | effect::fog | effect::dithered_colours>(square.scene, facing(), kSquareDithered),
                 grey);
}

TEST(Dithering, SpheresOfOneColourAreItsPattern) {
  const Colour colour{101, 202, 59, 255};
  const Material material{.colour = colour, .lit = false};
  const Quadric sphere{.transform = {{{fixed(3), 0, 0, 0}, {0, fixed(3), 0, 0}, {0, 0, fixed(0.5), 0}}}};
  Scene scene;
  scene.materials = {&material, 1};
  scene.quadrics = {&sphere, 1};
  constexpr Effects kSphere = effect::orthographic | effect::quadrics | effect::dithered_colours;
  expect_pattern(draw<kSphere>(scene, facing(), kSquareDithered), colour);
  const Fog fog{.colour = colour, .start = 0, .end = fixed(0.01)};
  const Material black{.colour = {0, 0, 0, 255}, .lit = false};
  scene.materials = {&black, 1};
  scene.fog = &fog;
  expect_pattern(draw<kSphere | effect::fog>(scene, facing(), kSquareDithered), colour);
}

TEST(Dithering, ChangedRectanglesMeetThePictureWithoutASeam) {
  Square square({40, 60, 80, 255}, {72, 76, 96, 255});
  constexpr Effects kEffects = kGradient | effect::dithered_colours;
  const Drawn whole = draw<kEffects>(square.scene, facing(), kSquareDithered);
  const Plan plan = zstrip::plan(count(square.scene), kSquareDithered, kEffects, {.strip_rows = 16}).plan;
  std::vector<std::byte> arena = lent(plan.bytes());
  Renderer<kEffects> renderer;
  ASSERT_TRUE(renderer.begin_frame(square.scene, facing(), kSquareDithered, plan, arena));
  const Rect area{13, 10, 42, 37};
  std::vector<std::uint16_t> pixels(static_cast<std::size_t>(area.width() * area.height()));
  std::vector<std::uint16_t> depth(pixels.size());
  ASSERT_TRUE(renderer.draw_over(area, pixels, depth));
  for (int y = area.top; y < area.bottom; ++y) {
    for (int x = area.left; x < area.right; ++x) {
      ASSERT_EQ(pixels[static_cast<std::size_t>((y - area.top) * area.width() + x - area.left)], whole.at(x, y));
    }
  }
}

TEST(Dithering, ARendererWithoutTheEffectDrawsThePictureUndithered) {
  Square square({40, 60, 80, 255}, {72, 76, 96, 255});
  EXPECT_EQ(effects_of(kSquare), Effects{});
  EXPECT_EQ(effects_of(kSquareDithered), effect::dithered_colours);
  EXPECT_EQ(effects_of(View{64, 64, PixelFormat::mono, true}), effect::dithered_format);
  const Drawn plain = draw<kGradient>(square.scene, facing(), kSquare);
  EXPECT_EQ(draw<kGradient>(square.scene, facing(), kSquareDithered), plain);
  EXPECT_NE(draw<kGradient | effect::dithered_colours>(square.scene, facing(), kSquareDithered), plain);
}

}  // namespace
}  // namespace effects_test::dither_test
