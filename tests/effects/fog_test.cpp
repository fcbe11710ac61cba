// Fog against its definition in doubles, at the distance of the ray through each pixel's centre.
#include <array>
#include <cmath>

#include "drawn.hpp"

namespace effects_test::fog_test {
namespace {

constexpr View kView{96, 64, PixelFormat::rgb565};

/// A white square in black fog: what is left of 255 is the visible share.
struct Square {
  std::array<Position, 4> positions;
  std::array<Triangle, 2> triangles{{{0, 1, 2}, {0, 2, 3}}};
  Mesh mesh;
  Material material{.lit = false, .smooth = false, .double_sided = true};
  Instance instance;
  Fog fog{.colour = {0, 0, 0, 255}};

  /// Corners in world units of 1/1000 of the half extent of 20.
  explicit Square(const std::array<std::array<int, 3>, 4>& corners) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto at = [&](std::size_t axis) { return static_cast<std::int16_t>(corners[i][axis] * 32768 / 1000); };
      positions[i] = {at(0), at(1), at(2)};
    }
    mesh.half_extent = {fixed(20), fixed(20), fixed(20)};
  }
  Scene scene() {
    mesh.positions = positions;
    mesh.triangles = triangles;
    Scene scene;
    scene.meshes = {&mesh, 1};
    scene.materials = {&material, 1};
    scene.instances = {&instance, 1};
    scene.background = {0, 0, 0, 255};
    scene.fog = &fog;
    return scene;
  }
  /// World coordinates of a corner.
  std::array<double, 3> corner(std::size_t i) const {
    return {positions[i].x * 20.0 / 32768, positions[i].y * 20.0 / 32768, positions[i].z * 20.0 / 32768};
  }
};

double visible(const Fog& fog, double w) {
  const double density = fog.density / 65536.0, start = fog.start / 65536.0, end = fog.end / 65536.0;
  switch (fog.mode) {
    case FogMode::linear: return std::clamp((end - w) / (end - start), 0.0, 1.0);
    case FogMode::exponential: return std::exp(-density * w);
    case FogMode::exponential_squared: break;
  }
  return std::exp(-density * w * density * w);
}

/// The distance of the square's plane along the viewing direction of the default camera, through (x, y) of the picture.
double distance(const Square& square, const Camera& camera, double x, double y) {
  const auto a = square.corner(0), b = square.corner(1), c = square.corner(2);
  const double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  const double n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double scale = 2.0 / kView.height / (camera.focal / 65536.0);
  const double px = (x + 0.5 - kView.width / 2.0) * scale, py = -(y + 0.5 - kView.height / 2.0) * scale;
  const double eye[3] = {camera.eye.x / 65536.0, camera.eye.y / 65536.0, camera.eye.z / 65536.0};
  const bool parallel = camera.projection == Projection::orthographic;
  const double from[3] = {parallel ? px : eye[0], parallel ? py : eye[1], eye[2]};
  const double along[3] = {parallel ? 0 : px, parallel ? 0 : py, -1};
  double numerator = 0, denominator = 0;
  for (int i = 0; i < 3; ++i) {
    numerator += n[i] * (a[static_cast<std::size_t>(i)] - from[i]);
    denominator += n[i] * along[i];
  }
  return numerator / denominator;
}

constexpr std::array<std::array<int, 3>, 4> kFloor{
    {{-990, -50, 150}, {990, -50, 150}, {990, -50, -990}, {-990, -50, -990}}};
constexpr std::array<std::array<int, 3>, 4> kWall{
    {{-300, -200, 0}, {800, -200, -900}, {800, 200, -900}, {-300, 200, 0}}};

template <Effects effects>
void expect_all_modes(const std::array<std::array<int, 3>, 4>& corners, const Camera& camera, double tolerance,
                      int at_least) {
  const Fog fogs[] = {
      {.colour = {0, 0, 0, 255}, .mode = FogMode::linear, .start = fixed(2), .end = fixed(19)},
      {.colour = {0, 0, 0, 255}, .mode = FogMode::exponential, .density = fixed(0.11)},
      {.colour = {0, 0, 0, 255}, .mode = FogMode::exponential_squared, .density = fixed(0.09)},
  };
  for (const Fog& fog : fogs) {
    SCOPED_TRACE(static_cast<int>(fog.mode));
    Square square(corners);
    square.fog = fog;
    const Drawn drawn = draw<effects>(square.scene(), camera, kView, {.strip_rows = 7});
    const Fog none{.colour = {}, .start = INT32_MAX - 1, .end = INT32_MAX};
    Scene clear = square.scene();
    clear.fog = &none;
    const Drawn covered = draw<effects>(clear, camera, kView);
    int compared = 0;
    for (int y = 0; y < kView.height; ++y) {
      for (int x = 0; x < kView.width; ++x) {
        if (covered.at(x, y) == 0) continue;
        ASSERT_EQ(covered.at(x, y), 0xFFFF) << x << ", " << y;
        const double expected = 255 * visible(fog, distance(square, camera, x, y));
        EXPECT_LT(drawn.green(x, y), expected + tolerance) << x << ", " << y;
        EXPECT_GT(drawn.green(x, y), expected - tolerance - 4) << x << ", " << y;  // RGB565 drops up to 3 of 255
        ++compared;
      }
    }
    EXPECT_GE(compared, at_least);
  }
}

// All of a row is equally far: nothing but the curve and the table can err.
TEST(EffectsFog, AFloorFadesByItsDistance) { expect_all_modes<effect::fog>(kFloor, Camera{}, 1, 1000); }

// Visibility is linear between every 16th pixel only, which rounds off where linear fog ends within a run.
TEST(EffectsFog, AWallFadesByThePixelNotByTheVertex) { expect_all_modes<effect::fog>(kWall, Camera{}, 14, 1000); }

/// Regression: the density times log2 e was rounded down to 16.16. In the thinnest fog, 12 % of 255 was visible too
/// much.
TEST(EffectsFog, ThinFogOverALargeSceneHasItsDensity) {
  for (const Fixed density : {1, 2, 3, 5, 10}) {
    SCOPED_TRACE(density);
    Square square({{{-990, -990, 0}, {990, -990, 0}, {990, 990, 0}, {-990, 990, 0}}});
    square.mesh.half_extent = {fixed(4000), fixed(4000), fixed(4000)};
    for (int i = 0; i < 3; ++i) square.instance.transform.m[i][i] = 25 * kFixedOne;
    square.fog.mode = FogMode::exponential;
    square.fog.density = density;
    Camera camera;
    camera.eye = {0, 0, fixed(30000)};
    camera.near_plane = fixed(20000);  // with codes that are fine enough for the distance
    camera.far_plane = fixed(32000);
    const Drawn drawn = draw<effect::fog>(square.scene(), camera, kView);
    const double expected = 255 * visible(square.fog, 30000);
    EXPECT_LT(drawn.green(48, 32), expected + 2);
    EXPECT_GT(drawn.green(48, 32), expected - 6);
  }
}

TEST(EffectsFog, DepthFormatsAndParallelProjectionHaveTheSameFog) {
  expect_all_modes<effect::fog | effect::depth_float>(kWall, Camera{}, 14, 1000);
  expect_all_modes<effect::fog | effect::depth_24>(kWall, Camera{}, 14, 1000);
  expect_all_modes<effect::fog | effect::depth_ranges>(kWall, Camera{}, 14, 1000);
  Camera parallel;
  parallel.projection = Projection::orthographic;
  parallel.focal = fixed(0.1);
  expect_all_modes<effect::fog | effect::orthographic>(kWall, parallel, 14, 1000);
  expect_all_modes<effect::fog | effect::orthographic | effect::depth_24>(kWall, parallel, 14, 1000);
  expect_all_modes<effect::fog | effect::orthographic | effect::depth_ranges>(kWall, parallel, 14, 1000);
}

TEST(EffectsFog, WhatIsNoFogIsRefused) {
  Square square(kFloor);
  const auto error = [&] { return validate(square.scene()).error; };
  EXPECT_EQ(error(), Error::none);
  square.fog.start = square.fog.end;
  EXPECT_EQ(error(), Error::fog);
  square.fog = {.start = -1};
  EXPECT_EQ(error(), Error::fog);
  square.fog = {.density = -1};
  EXPECT_EQ(error(), Error::fog);
  square.fog = {.mode = FogMode{3}};
  EXPECT_EQ(error(), Error::fog);
}

}  // namespace
}  // namespace effects_test::fog_test
