// Light on one vertex, shown by a flat triangle, against its definition in doubles.
#include <array>
#include <cmath>
#include <random>

#include "../oracle/vectors.hpp"
#include "drawn.hpp"

namespace effects_test::light_test {
namespace {

using namespace oracle;

constexpr View kView{8, 8, PixelFormat::rgb565};
constexpr double kHalf = 4;

/// A square that fills the picture and has the colour of its first vertex.
struct Sheet {
  std::array<Position, 4> positions{{{-16000, -16000, 0}, {16000, -16000, 0}, {16000, 16000, 0}, {-16000, 16000, 0}}};
  std::array<Normal, 4> normals{};
  std::array<Triangle, 2> triangles{{{0, 1, 2}, {0, 2, 3}}};
  Mesh mesh;
  Material material{.colour = {0, 0, 0, 255}, .lit = true, .smooth = false, .double_sided = true, .finish = 0};
  Finish finish;
  Instance instance;
  DirectionalLight directional;
  PunctualLight punctual;

  Scene scene(bool has_directional, bool has_punctual) {
    mesh.half_extent = {fixed(4), fixed(4), fixed(4)};
    mesh.positions = positions;
    mesh.normals = normals;
    mesh.triangles = triangles;
    Scene scene;
    scene.meshes = {&mesh, 1};
    scene.materials = {&material, 1};
    scene.instances = {&instance, 1};
    scene.finishes = {&finish, 1};
    scene.ambient = {0, 0, 0, 255};
    if (has_directional) scene.lights = {&directional, 1};
    if (has_punctual) scene.punctual_lights = {&punctual, 1};
    return scene;
  }
  /// World coordinates of the first vertex; the instance is at most moved.
  Point vertex() const {
    const auto at = [this](int axis, std::int16_t p) {
      return p * kHalf / 32768 + instance.transform.m[axis][3] / 65536.0;
    };
    return {at(0, positions[0].x), at(1, positions[0].y), at(2, positions[0].z)};
  }
  /// Puts the punctual light at `distance` from the first vertex.
  void put_light(const Point& away, double distance) {
    const Point at = vertex();
    const auto place = [&](std::size_t axis) {
      return static_cast<Fixed>(std::lround((at[axis] + away[axis] * distance) * 65536));
    };
    punctual.position = {place(0), place(1), place(2)};
  }
  Point normal() const { return unit({normals[0].x / 127.0, normals[0].y / 127.0, normals[0].z / 127.0}); }
};

struct Samples {
  std::mt19937 random{20};
  int between(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }
  Sheet sheet() {
    Sheet sheet;
    sheet.positions[0] = {static_cast<std::int16_t>(between(-20000, -9000)),
                          static_cast<std::int16_t>(between(-20000, -9000)),
                          static_cast<std::int16_t>(between(-4000, 4000))};
    const Point n = unit({between(-60, 60) / 100.0, between(-60, 60) / 100.0, 1});
    sheet.normals.fill({static_cast<std::int8_t>(std::lround(n[0] * 127)),
                        static_cast<std::int8_t>(std::lround(n[1] * 127)),
                        static_cast<std::int8_t>(std::lround(n[2] * 127)), 0});
    return sheet;
  }
  Point direction() { return unit({between(-80, 80) / 100.0, between(-80, 80) / 100.0, between(30, 100) / 100.0}); }
};

/// RGB565 drops up to 3 of 255; up to 4 more are rounded on the way, most where a narrow cone magnifies a cosine.
void expect_near(const Drawn& drawn, double expected) {
  const double within = std::min(expected, 255.0);
  EXPECT_LT(drawn.green(4, 4), within + 2);
  EXPECT_GT(drawn.green(4, 4), within - 7);
}

/// Regression: planes start at the vertex that is least in y and x, and unclipped triangles took its colour.
TEST(EffectsLight, FlatTextureHasTheColourOfItsFirstVertex) {
  const std::uint16_t white[4] = {0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF};
  const std::array<TexCoord, 4> texcoords{};
  const Texture texture{.texels = white, .log2_width = 1, .log2_height = 1};
  Sheet sheet;
  sheet.material.colour = {255, 255, 255, 255};
  sheet.normals = {Normal{0, 0, 127, 0}, Normal{0, 76, 101, 0}, Normal{0, 110, 63, 0}, Normal{0, 0, 127, 0}};
  sheet.directional = {0, 0, 32767, {255, 255, 255, 255}};
  std::vector<int> greens;
  for (const Triangle& triangle : {Triangle{0, 1, 2}, Triangle{1, 2, 0}, Triangle{2, 0, 1}}) {
    sheet.triangles.fill(triangle);
    sheet.mesh.texcoords = {};
    sheet.material.texture = kNoTexture;
    const Drawn plain = draw<effect::lighting>(sheet.scene(true, false), {}, kView);
    Scene scene = sheet.scene(true, false);
    sheet.mesh.texcoords = texcoords;
    sheet.material.texture = 0;
    scene.textures = {&texture, 1};
    const Drawn textured = draw<effect::lighting | effect::textures>(scene, {}, kView);
    EXPECT_EQ(textured.green(5, 4), plain.green(5, 4));
    greens.push_back(plain.green(5, 4));
  }
  EXPECT_GT(greens[0], greens[1] + 20);
  EXPECT_GT(greens[1], greens[2] + 20);
}

TEST(EffectsLight, EmissionIsAddedToLight) {
  Samples samples;
  for (int i = 0; i < 50; ++i) {
    Sheet sheet = samples.sheet();
    sheet.material.colour = {200, 200, 200, 255};
    sheet.finish.emissive = {0, static_cast<std::uint8_t>(samples.between(1, 255)), 0, 255};
    sheet.directional = {0, 0, 32767, {200, 200, 200, 255}};
    const Drawn drawn = draw<effect::lighting | effect::emissive>(sheet.scene(true, false), {}, kView);
    const double lit = 200 * 200 / 255.0 * sheet.normal()[2];
    expect_near(drawn, lit + sheet.finish.emissive.g);
  }
}

template <Effects more>
void expect_highlights(const Camera& camera) {
  Samples samples;
  int bright = 0;
  for (int i = 0; i < 300; ++i) {
    Sheet sheet = samples.sheet();
    const Point towards = samples.direction();
    const auto part = [&](std::size_t axis) { return static_cast<std::int16_t>(std::lround(towards[axis] * 32767)); };
    sheet.directional = {part(0), part(1), part(2), {255, 200, 255, 255}};
    sheet.finish.specular = {0, 240, 0, 255};
    sheet.finish.shininess = static_cast<std::uint8_t>(samples.between(1, 60));
    const Drawn drawn = draw<effect::lighting | effect::specular | more>(sheet.scene(true, false), camera, kView);
    const bool parallel = camera.projection == Projection::orthographic;
    const Point view = parallel ? Point{0, 0, 1} : unit(of_place(camera.eye) - sheet.vertex());
    const double cosine = std::max(0.0, dot(sheet.normal(), unit(view + towards)));
    const double expected =
        dot(sheet.normal(), towards) > 0 ? 200 * 240 / 255.0 * std::pow(cosine, sheet.finish.shininess) : 0;
    expect_near(drawn, expected);
    if (expected > 60) ++bright;
  }
  EXPECT_GT(bright, 50);
}

TEST(EffectsLight, HighlightsAreBlinnAndPhongs) {
  expect_highlights<Effects{}>({});
  Camera parallel;
  parallel.projection = Projection::orthographic;
  parallel.focal = fixed(0.6);
  expect_highlights<effect::orthographic>(parallel);
}

/// Regression: a cosine had 14 bits and each product of its power was rounded down. With an exponent of 255, a
/// highlight was up to 16 of 255 too dark.
TEST(EffectsLight, ASharpHighlightHasItsStrength) {
  Samples samples;
  Camera parallel;
  parallel.projection = Projection::orthographic;
  parallel.focal = fixed(0.6);
  for (int i = 0; i < 500; ++i) {
    Sheet sheet = samples.sheet();
    const Point normal = sheet.normal();
    const auto mirrored = [&](std::size_t axis) {  // the eye's direction, and up to 4 degrees off
      return 2 * normal[2] * normal[axis] - (axis == 2 ? 1 : 0) + samples.between(-40, 40) / 1000.0;
    };
    const Point light = unit({mirrored(0), mirrored(1), mirrored(2)});
    const auto part = [&](std::size_t axis) { return static_cast<std::int16_t>(std::lround(light[axis] * 32767)); };
    sheet.directional = {part(0), part(1), part(2), {255, 255, 255, 255}};
    if (dot(normal, light) < 0.1) continue;
    sheet.finish.specular = {255, 255, 255, 255};
    sheet.finish.shininess = 255;
    const double cosine = dot(normal, unit(Point{0, 0, 1} + light));
    expect_near(
        draw<effect::lighting | effect::specular | effect::orthographic>(sheet.scene(true, false), parallel, kView),
        255 * std::pow(cosine, 255));
  }
}

TEST(EffectsLight, PunctualLightIsAsKhrLightsPunctualSays) {
  Samples samples;
  int bright = 0;
  for (int i = 0; i < 600; ++i) {
    Sheet sheet = samples.sheet();
    const bool spot = i % 2 == 1;
    sheet.material.colour = {255, 230, 255, 255};
    sheet.instance.transform.m[0][3] = samples.between(-20000, 20000);
    const Point away = samples.direction();
    const double distance = std::exp(samples.between(-20, 15) / 10.0);
    const Point at = sheet.vertex();
    sheet.put_light(away, distance);
    PunctualLight& light = sheet.punctual;
    light.intensity = static_cast<Fixed>(distance * distance * samples.between(6000, 90000));
    light.colour = {0, 220, 0, 255};
    if (samples.between(0, 1) == 1) light.range = static_cast<Fixed>(distance * samples.between(50000, 200000));
    double angular = 1;
    const Point real = of_place(light.position);
    const Point to_light = real - at;
    if (spot) {
      light.type = PunctualLightType::spot;
      const Point shines = unit(
          Point{-away[0] + samples.between(-40, 40) / 100.0, -away[1] + samples.between(-40, 40) / 100.0, -away[2]});
      const auto part = [&](std::size_t axis) { return static_cast<std::int16_t>(std::lround(shines[axis] * 32767)); };
      light.x = part(0), light.y = part(1), light.z = part(2);
      light.cosine_inner = static_cast<std::int16_t>(samples.between(29000, 32767));
      light.cosine_outer = static_cast<std::int16_t>(samples.between(20000, 28000));
      const double c = -dot(shines, unit(to_light));
      angular = std::clamp((c - light.cosine_outer / 32767.0) / ((light.cosine_inner - light.cosine_outer) / 32767.0),
                           0.0, 1.0);
      angular *= angular;
    }
    const double d = length(to_light);
    double share = light.intensity / 65536.0 / (d * d) * angular * std::max(0.0, dot(sheet.normal(), unit(to_light)));
    if (light.range != 0) share *= std::max(0.0, 1 - std::pow(d / (light.range / 65536.0), 4));
    const double expected = 220 * 230 / 255.0 * share;
    expect_near(draw<effect::lighting | effect::punctual_lights>(sheet.scene(false, true), {}, kView), expected);
    if (expected > 60) ++bright;
  }
  EXPECT_GT(bright, 100);
}

/// Regression: the lower word of a product was lost before it was shifted up for a near light. A white surface 0.0228
/// units from a light of intensity 34 / 65536 was black.
TEST(EffectsLight, ANearLightOfSmallIntensityIsNotRoundedToSteps) {
  Samples samples;
  for (int i = 0; i < 100; ++i) {
    Sheet sheet = samples.sheet();
    sheet.material.colour = {255, 230, 255, 255};
    const Point at = sheet.vertex(), away = sheet.normal();
    const double distance = samples.between(25, 100) / 1000.0;
    sheet.put_light(away, distance);
    PunctualLight& light = sheet.punctual;
    light.intensity = static_cast<Fixed>(distance * distance * samples.between(30000, 65000));
    light.colour = {0, 220, 0, 255};
    const Point to_light = of_place(light.position) - at;
    const double d = length(to_light);
    const double share = light.intensity / 65536.0 / (d * d) * dot(sheet.normal(), unit(to_light));
    expect_near(draw<effect::lighting | effect::punctual_lights>(sheet.scene(false, true), {}, kView),
                220 * 230 / 255.0 * share);
  }
}

/// Regression: cosines had 14 bits, of which a cone of 1 degree takes two. Spots of up to 5 degrees were too dark or
/// too wide, some completely dark on their axis.
TEST(EffectsLight, ANarrowSpotHasTheWidthOfItsCone) {
  Samples samples;
  for (int i = 0; i < 200; ++i) {
    Sheet sheet = samples.sheet();
    sheet.material.colour = {255, 230, 255, 255};
    const Point at = sheet.vertex(), away = sheet.normal();
    sheet.put_light(away, 1);
    PunctualLight& light = sheet.punctual;
    light.type = PunctualLightType::spot;
    light.colour = {0, 220, 0, 255};
    const double outer = samples.between(10, 50) / 10.0 * 3.14159265 / 180;
    const double off = i % 4 == 0 ? 0 : outer;  // every fourth spot points at the vertex
    const auto aim = [&] { return off * samples.between(-60, 60) / 100; };
    const Point shines = unit({-away[0] + aim(), -away[1] + aim(), -away[2] + aim()});
    const auto part = [&](std::size_t axis) { return static_cast<std::int16_t>(std::lround(shines[axis] * 32767)); };
    light.x = part(0), light.y = part(1), light.z = part(2);
    light.cosine_inner = static_cast<std::int16_t>(std::lround(32767 * std::cos(outer / 2)));
    light.cosine_outer = static_cast<std::int16_t>(std::lround(32767 * std::cos(outer)));
    const Point to_light = of_place(light.position) - at;
    const double c = -dot(unit({light.x / 32767.0, light.y / 32767.0, light.z / 32767.0}), unit(to_light));
    const double angular = std::clamp(
        (c - light.cosine_outer / 32767.0) / ((light.cosine_inner - light.cosine_outer) / 32767.0), 0.0, 1.0);
    const double d = length(to_light);
    const double share = angular * angular / (d * d) * dot(sheet.normal(), unit(to_light));
    expect_near(draw<effect::lighting | effect::punctual_lights>(sheet.scene(false, true), {}, kView),
                220 * 230 / 255.0 * share);
  }
}

TEST(EffectsLight, WhatIsNoLightIsRefused) {
  Sheet sheet;
  const auto error = [&] { return validate(sheet.scene(false, true)).error; };
  EXPECT_EQ(error(), Error::none);
  sheet.punctual.intensity = -1;
  EXPECT_EQ(error(), Error::punctual_light);
  sheet.punctual = {.range = -1};
  EXPECT_EQ(error(), Error::punctual_light);
  sheet.punctual = {.cosine_inner = 5, .cosine_outer = 5};
  EXPECT_EQ(error(), Error::punctual_light);
  sheet.punctual = {.type = PunctualLightType{2}};
  EXPECT_EQ(error(), Error::punctual_light);
  sheet.punctual = {};
  sheet.finish.filter = TextureFilter{2};
  EXPECT_EQ(error(), Error::finish);
  sheet.finish = {.alpha_mode = AlphaMode{3}};
  EXPECT_EQ(error(), Error::finish);
  sheet.finish = {};
  sheet.material.finish = 1;
  EXPECT_EQ(error(), Error::material);
}

}  // namespace
}  // namespace effects_test::light_test
