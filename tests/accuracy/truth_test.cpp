// The truth on scenes whose pictures can be said without drawing them.
#include "accuracy/truth.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "accuracy/measure.hpp"

namespace zstrip::sim {
namespace {

constexpr View kView{16, 16};

/// The unit square in z = 0, counter-clockwise, seen by a camera at distance 4 whose picture is 2 high there.
struct Square {
  std::array<Position, 4> positions{{{-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}, {-32767, 32767, 0}}};
  std::array<Colour, 4> colours{{{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {255, 255, 255, 255}}};
  std::array<TexCoord, 4> texcoords{{{0, 4096}, {4096, 4096}, {4096, 0}, {0, 0}}};
  std::array<Triangle, 2> triangles{{{0, 1, 2}, {0, 2, 3}}};
  std::array<std::uint16_t, 4> texels{{0xF800, 0x07E0, 0x001F, 0xFFFF}};
  std::array<Texture, 1> textures{{{texels, 1, 1}}};
  std::array<Material, 1> materials{{{.lit = false}}};
  std::array<Mesh, 1> meshes{};
  std::array<Instance, 1> instances{};
  Camera camera;
  Scene scene;

  Square() {
    meshes[0].positions = positions;
    meshes[0].colours = colours;
    meshes[0].triangles = triangles;
    camera.eye = {0, 0, 4 * kFixedOne};
    camera.focal = 4 * kFixedOne;
    scene.meshes = meshes;
    scene.materials = materials;
    scene.instances = instances;
  }
  Square(const Square&) = delete;
  Square& operator=(const Square&) = delete;
  TruthPicture draw() const { return *draw_truth(scene, camera, kView, 1); }
};

TEST(Truth, ABillboardIsSeenFromTheFrontFromEverywhere) {
  Square square;
  const TruthPicture front = square.draw();
  for (const Billboard billboard : {Billboard::viewer, Billboard::upright}) {
    square.meshes[0].billboard = billboard;
    for (int step = 0; step < 5; ++step) {
      const Angle theta = billboard == Billboard::viewer ? 3000 + 5000 * step : kFullTurn / 4;
      ASSERT_TRUE(orbit(square.camera, {0, 0, 0}, 4 * kFixedOne, 9000 * step, theta));
      const TruthPicture picture = square.draw();
      for (std::uint32_t y = 1; y < 15; ++y) {
        for (std::uint32_t x = 1; x < 15; ++x) {
          if (x + y == 15) continue;  // the diagonal
          ASSERT_EQ(picture.at(x, y).triangle, front.at(x, y).triangle) << step << ' ' << x << ' ' << y;
          EXPECT_NEAR(picture.at(x, y).rgb[0], front.at(x, y).rgb[0], 1);
        }
      }
    }
  }
}

TEST(Truth, FillsThePictureOnceAlongTheDiagonal) {
  Square square;
  const TruthPicture picture = square.draw();
  for (std::uint32_t y = 0; y < 16; ++y) {
    for (std::uint32_t x = 0; x < 16; ++x) {
      const TruthSample& sample = picture.at(x, y);
      ASSERT_NE(sample.triangle, kNoTriangle);
      // The diagonal goes from the lower left to the upper right corner: below it is the first triangle.
      if (x + y != 15) {
        EXPECT_EQ(sample.triangle, x + y > 15 ? 0U : 1U) << x << ' ' << y;
      }
      EXPECT_NEAR(sample.w, 4, 1e-9);
    }
  }
}

TEST(Truth, ColoursAreLinearWhereThereIsNoPerspective) {
  Square square;
  const TruthSample& sample = square.draw().at(12, 14);  // 12.5/16 to the right, 1.5/16 above the lower side
  const double x = (12.5 / 16 * 2 - 1) * 32768 / 32767, y = (1.5 / 16 * 2 - 1) * 32768 / 32767;
  const double to_green = (x + 1) / 2 - (y + 1) / 2, to_blue = (y + 1) / 2;
  EXPECT_NEAR(sample.rgb[0], 255 * (1 - to_green - to_blue), 0.01);
  EXPECT_NEAR(sample.rgb[1], 255 * to_green, 0.01);
  EXPECT_NEAR(sample.rgb[2], 255 * to_blue, 0.01);
}

TEST(Truth, PlacesInATextureAreThoseOfThePlaneSeenAtAnAngle) {
  Square square;
  square.materials[0].texture = 0;
  square.meshes[0].colours = {};
  square.meshes[0].texcoords = square.texcoords;
  square.scene.textures = square.textures;
  // Turned by 60 degrees about y: x becomes x / 2, z becomes -x sin.
  const double sine = std::sqrt(3.0) / 2;
  square.instances[0].transform.m[0][0] = kFixedOne / 2;
  square.instances[0].transform.m[0][2] = static_cast<Fixed>(sine * kFixedOne);
  square.instances[0].transform.m[2][0] = -static_cast<Fixed>(sine * kFixedOne);
  square.instances[0].transform.m[2][2] = kFixedOne / 2;
  const TruthPicture picture = square.draw();
  int seen = 0;
  for (std::uint32_t x = 0; x < 16; ++x) {
    const TruthSample& sample = picture.at(x, 7);
    if (sample.triangle == kNoTriangle) continue;
    ++seen;
    // The ray through the pixel: picture = local / 2 * 4 / (4 + local sin), solved for local.
    const double at = (x + 0.5) / 8 - 1;
    const double local = 4 * at / (2 - at * sine);
    EXPECT_NEAR(sample.u, (local + 1), 1e-3) << x;  // of a texture of 2 texels
    EXPECT_NEAR(sample.w, 4 + local * sine, 1e-3) << x;
  }
  EXPECT_GT(seen, 4);
}

TEST(Truth, TheNearestSurfaceIsVisibleWhateverTheOrder) {
  for (const bool near_first : {true, false}) {
    Square square;
    std::array<Instance, 2> instances{};
    instances[near_first ? 0 : 1].transform.m[2][3] = kFixedOne;
    square.scene.instances = instances;
    const TruthPicture picture = square.draw();
    EXPECT_NEAR(picture.at(8, 8).w, 3, 1e-9);
    EXPECT_EQ(picture.at(8, 8).triangle / 2, near_first ? 0U : 1U);
  }
}

TEST(Truth, BackFacesAreNotThere) {
  Square square;
  std::swap(square.triangles[0].b, square.triangles[0].c);
  EXPECT_EQ(square.draw().at(14, 14).triangle, kNoTriangle);
  square.materials[0].double_sided = true;
  EXPECT_EQ(square.draw().at(14, 14).triangle, 0U);
}

TEST(Truth, MeansOfSixteenSamplesShowHalfCoveredPixels) {
  Square square;
  square.colours.fill({255, 255, 255, 255});
  square.camera.focal = 2 * kFixedOne + kFixedOne / 4;  // the square covers 4.5 pixels to each side of the middle
  const Truth truth = *find_truth(square.scene, square.camera, kView);
  EXPECT_NEAR(truth.mean[8 * 16 + 8][0], 255, 0.01);
  EXPECT_NEAR(truth.mean[8 * 16 + 12][0], 127.5, 0.01);
  EXPECT_NEAR(truth.mean[8 * 16 + 13][0], 0, 0.01);
  EXPECT_NEAR(truth.mean[12 * 16 + 12][0], 63.75, 0.01);
}

TEST(Truth, FogIsThatOfTheDistance) {
  Square square;
  square.colours.fill({200, 200, 200, 255});
  Fog fog{.colour = {100, 0, 0, 255}, .mode = FogMode::linear, .start = 2 * kFixedOne, .end = 10 * kFixedOne};
  square.scene.fog = &fog;
  EXPECT_NEAR(square.draw().at(8, 8).rgb[0], 0.75 * 200 + 0.25 * 100, 0.01);
  EXPECT_NEAR(square.draw().at(8, 8).rgb[1], 0.75 * 200, 0.01);
  fog.mode = FogMode::exponential;
  fog.density = kFixedOne / 4;
  EXPECT_NEAR(square.draw().at(8, 8).rgb[1], 200 * std::exp(-1), 0.01);
  fog.mode = FogMode::exponential_squared;
  fog.density = kFixedOne / 2;
  EXPECT_NEAR(square.draw().at(8, 8).rgb[1], 200 * std::exp(-4), 0.01);
}

/// A unit sphere around the origin alone, seen as the square is.
struct Sphere : Square {
  std::array<Quadric, 1> quadrics{};
  Sphere() {
    scene.instances = {};
    scene.quadrics = quadrics;
    scene.textures = textures;
  }
};

TEST(Truth, SpheresHaveTheirDepthAndSilhouette) {
  Sphere sphere;
  const TruthPicture picture = *draw_truth(sphere.scene, sphere.camera, {256, 256}, 1);
  EXPECT_NEAR(picture.at(128, 128).w, 3, 1e-4);
  std::uint32_t covered = 0;
  for (const TruthSample& sample : picture.samples) covered += sample.triangle == 0 ? 1 : 0;
  // The tangents from distance 4: 1 / sqrt(15) of the distance, times 4 of half the picture.
  const double radius = 128 * 4 / std::sqrt(15.0);
  double expected = 0;  // cut off by the picture's sides
  for (int y = 0; y < 256; ++y) expected += 2 * std::min(std::sqrt(radius * radius - std::pow(y - 127.5, 2)), 128.0);
  EXPECT_NEAR(covered, expected, 200);
}

TEST(Truth, SpheresShowTheMiddleOfTheirTextureInFront) {
  Sphere sphere;
  sphere.materials[0].texture = 0;
  const TruthPicture picture = *draw_truth(sphere.scene, sphere.camera, {257, 257}, 1);
  const TruthSample& middle = picture.at(128, 128);
  EXPECT_NEAR(middle.u, 1, 1e-9);  // of 2x2 texels
  EXPECT_NEAR(middle.v, 1, 1e-9);
  EXPECT_GT(picture.at(200, 128).u, 1.1);  // to the right is +x
  EXPECT_LT(picture.at(128, 60).v, 0.9);   // the upper edge is +y
  EXPECT_EQ(picture.at(200, 60).rgb, (std::array<float, 3>{0, 255, 0}));
}

TEST(Truth, SpheresAreLitByTheirNormals) {
  Sphere sphere;
  sphere.materials[0].lit = true;
  const std::array<DirectionalLight, 1> lights{{{0, 0, 32767, {200, 200, 200, 255}}}};
  sphere.scene.lights = lights;
  sphere.scene.ambient = {20, 20, 20, 255};
  const TruthPicture picture = *draw_truth(sphere.scene, sphere.camera, {257, 257}, 1);
  EXPECT_NEAR(picture.at(128, 128).rgb[0], 220, 0.01);
  const TruthSample& aside = picture.at(200, 128);
  // Where it is: w along the ray, so z = 4 - w is the cosine.
  EXPECT_NEAR(aside.rgb[0], 20 + 200 * (4 - aside.w), 0.01);
}

TEST(Truth, PixelsAreLitByTheNormalThere) {
  Square square;
  // The normals of the left side lean to the left, those of the right side to the right, by 45 degrees.
  const std::array<Normal, 4> normals{{{-90, 0, 90, 0}, {90, 0, 90, 0}, {90, 0, 90, 0}, {-90, 0, 90, 0}}};
  const std::array<DirectionalLight, 1> lights{{{0, 0, 32767, {200, 200, 200, 255}}}};
  square.meshes[0].normals = normals;
  square.meshes[0].colours = {};
  square.materials[0] = {.colour = {255, 255, 255, 255}, .smooth = Shading::gouraud};
  square.scene.lights = lights;
  square.scene.ambient = {20, 20, 20, 255};
  const TruthPicture picture = square.draw();
  for (std::uint32_t x = 0; x < 16; ++x) {
    const double lean = (x + 0.5) / 8 - 1;  // of the normal's x over its z
    EXPECT_NEAR(picture.at(x, 3).rgb[0], 20 + 200 / std::sqrt(1 + lean * lean), 0.1) << x;
  }
  // Whether the material asks for that or for light at vertices; a flat one has its first vertex' light.
  square.materials[0].smooth = Shading::pixel;
  EXPECT_EQ(square.draw().at(5, 3).rgb, picture.at(5, 3).rgb);
  square.materials[0].smooth = Shading::flat;
  EXPECT_NEAR(square.draw().at(5, 3).rgb[0], 20 + 200 / std::sqrt(2), 0.1);
  square.materials[0].smooth = Shading::gouraud;
  // Vertex colours are multiplied with it.
  square.meshes[0].colours = square.colours;
  EXPECT_NEAR(square.draw().at(12, 14).rgb[1], picture.at(12, 14).rgb[1] * 0.6875, 1);
}

TEST(Truth, RefusesWhatItDoesNotKnow) {
  Square square;
  const std::array<Finish, 1> finishes{{{.alpha_mode = AlphaMode::mask}}};
  square.scene.finishes = finishes;
  square.materials[0].finish = 0;
  const Result<TruthPicture> picture = draw_truth(square.scene, square.camera, kView, 1);
  ASSERT_FALSE(picture);
  EXPECT_NE(picture.failure().message.find("alpha"), std::string::npos);
}

TEST(Truth, RefusesASceneByWhatItHasAndWhere) {
  for (const std::string effect : {"outlines", "shadows", "csg", "lines"}) {
    const std::string file = fmt::format("{}/host-sim/scenes/{}.toml", ZSTRIP_ROOT, effect);
    const auto opened = AccuracyScene::open({.scene = file, .view = kView, .frames = 1, .firmware = ""});
    ASSERT_FALSE(opened) << effect;
    EXPECT_EQ(opened.failure().status, ExitStatus::input);
    const std::string& message = opened.failure().message;
    EXPECT_NE(message.find(fmt::format("{0} ({0}.toml line ", effect)), std::string::npos) << message;
  }
}

TEST(Truth, RefusesMaterialsWhoseDepthIsTheirOwn) {
  Square square;
  square.materials[0].depth_bias = 5;
  EXPECT_FALSE(draw_truth(square.scene, square.camera, kView, 1));
}

}  // namespace
}  // namespace zstrip::sim
