// Spheres and ellipsoids against rays in long double: silhouette, depth, light, texture; strips and layouts.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "depth_picture.hpp"
#include "ray_oracle.hpp"

namespace {

using namespace zstrip;
using namespace ray_oracle;
using picture::begun;
using picture::DepthPicture;
using picture::DepthRenderer;

constexpr Real kWidened = Real{1} / (1 << 20);  // docs/conventions.md: of the depth range on either side

Transform transform_of(const std::array<V, 3>& axes, V centre) {
  const auto at = [](Real value) { return static_cast<Fixed>(std::lround(value * 65536)); };
  return {{{at(axes[0].x), at(axes[1].x), at(axes[2].x), at(centre.x)},
           {at(axes[0].y), at(axes[1].y), at(axes[2].y), at(centre.y)},
           {at(axes[0].z), at(axes[1].z), at(axes[2].z), at(centre.z)}}};
}
Transform sphere(Real radius, V centre) {
  return transform_of({V{radius, 0, 0}, V{0, radius, 0}, V{0, 0, radius}}, centre);
}

/// Random axes at right angles with these lengths.
std::array<V, 3> any_axes(std::mt19937& random, Real a, Real b, Real c) {
  std::normal_distribution<double> normal;
  const auto any = [&] { return V{normal(random), normal(random), normal(random)}; };
  const V x = unit(any());
  const V y = unit(cross(x, any()));
  return {a * x, b * y, c * cross(x, y)};
}

/// Quadrics and what they need.
struct World {
  std::vector<Quadric> quadrics;
  Material material;
  DirectionalLight light{-10000, 20000, 23000, {200, 190, 180, 255}};
  Texture texture;
  std::vector<std::uint16_t> texels;
  Camera camera;
  View view{96, 72};

  World() {
    camera.near_plane = fixed(1.0);
    camera.far_plane = fixed(20.0);
    camera.fixed_depth_range = true;
    camera.eye = {0, 0, fixed(8.0)};
    material.lit = false;
  }
  Scene scene() {
    Scene s;
    s.materials = {&material, 1};
    s.quadrics = quadrics;
    s.lights = {&light, 1};
    if (!texels.empty()) {
      texture.texels = texels;
      s.textures = {&texture, 1};
    }
    return s;
  }
  Effects effects(Effects more = {}) { return effects_of(scene(), camera) | effect::statistics | more; }
};

/// The documented mapping of z16 over near..far.
Real exact_code(const Camera& camera, Real w) {
  const Real n = real(camera.near_plane) * (1 - kWidened), f = real(camera.far_plane) * (1 + kWidened);
  if (camera.projection == Projection::orthographic) return 1 + 65533 * (f - w) / (f - n);
  return 1 + 65533 * (1 / w - 1 / f) / (1 / n - 1 / f);
}

struct Judged {
  int pixels = 0, drawn = 0;
  Real worst_depth = 0;
};

/// Compares every pixel with all quadrics; where a ray is within `abstain` (of a radius) of only touching one, or a
/// surface is that near to a plane of the depth range, anything may be.
Judged judge(World& world, const DepthPicture& picture, Real abstain) {
  Judged judged;
  const Real near = real(world.camera.near_plane), far = real(world.camera.far_plane);
  for (int y = 0; y < world.view.height; ++y) {
    for (int x = 0; x < world.view.width; ++x) {
      const Ray ray = ray_through(world.camera, world.view, x + Real{0.5}, y + Real{0.5});
      std::optional<Hit> first;
      bool unsure = false;
      for (const Quadric& quadric : world.quadrics) {
        const Crossing crossing = cross_quadric(ray, quadric.transform);
        unsure |= std::abs(crossing.clearance) < abstain;
        for (const Hit& hit : {crossing.enter, crossing.leave}) {
          if (crossing.clearance > 0) unsure |= std::abs(hit.w - near) < abstain || std::abs(hit.w - far) < abstain;
        }
        const auto hit = seen(crossing, near, far, world.material.double_sided);
        if (hit && (!first || hit->w < first->w)) first = hit;
      }
      if (unsure) continue;
      ++judged.pixels;
      const std::uint32_t code = picture.depth[static_cast<std::size_t>(y * world.view.width + x)];
      EXPECT_EQ(code != 0, first.has_value()) << x << ',' << y;
      if (code == 0 || !first) continue;
      ++judged.drawn;
      judged.worst_depth = std::max(judged.worst_depth, std::abs(code - exact_code(world.camera, first->w)));
    }
  }
  return judged;
}

class QuadricIn : public testing::TestWithParam<Projection> {
 protected:
  QuadricIn() {
    world.camera.projection = GetParam();
    if (GetParam() == Projection::orthographic) world.camera.focal = fixed(0.3);
  }
  DepthPicture draw(std::uint16_t rows = 0) {
    return DepthRenderer(world.effects(), world.view, rows == 0 ? world.view.height : rows)
        .draw(world.scene(), world.camera);
  }
  World world;
};

TEST_P(QuadricIn, RandomEllipsoidsHaveExactSilhouettesAndDepths) {
  std::mt19937 random(10);
  std::uniform_real_distribution<double> place(-3, 3), length(0.05, 2);
  Judged all;
  for (int i = 0; i < 60; ++i) {
    world.quadrics.clear();
    for (int k = 0; k < 3; ++k) {
      world.quadrics.push_back({0, transform_of(any_axes(random, length(random), length(random), length(random)),
                                                {place(random), place(random), place(random)})});
    }
    ASSERT_TRUE(look_at(world.camera, {fixed(5.0), fixed(3.0), fixed(6.0)}, {0, 0, 0}, {0, kFixedOne, 0}));
    const DepthPicture picture = draw();
    ASSERT_TRUE(picture.status) << message(picture.status.error);
    const Judged judged = judge(world, picture, 1e-6L);
    all.drawn += judged.drawn;
    all.worst_depth = std::max(all.worst_depth, judged.worst_depth);
  }
  EXPECT_GT(all.drawn, 10'000);
  EXPECT_LT(all.worst_depth, 0.6L);
}

// Hard case 64.
TEST_P(QuadricIn, H64_TangentRowsAxesOfOneToAThousandAndGrazingRays) {
  std::mt19937 random(11);
  // The edge of the silhouette exactly on, just inside and just outside a row of centres.
  for (const Real radius : {1.0L, 1.5L, 0.01L}) {
    for (int i = -2; i <= 2; ++i) {
      world.quadrics = {{0, sphere(radius, {0, radius * 0.5L + i / Real{65536}, 0})}};
      const DepthPicture picture = draw();
      ASSERT_TRUE(picture.status);
      EXPECT_LT(judge(world, picture, 1e-7L).worst_depth, 0.6L);
    }
  }
  int drawn = 0;
  for (int i = 0; i < 40; ++i) {
    const Real thin = i % 2 == 0 ? 0.002L : 2;
    world.quadrics = {{0, transform_of(any_axes(random, 2, thin, 0.002L), {0.3L, -0.2L, 0})}};
    const DepthPicture picture = draw();
    ASSERT_TRUE(picture.status);
    // Rays that nearly touch a needle: in its own space everything is a thousand times wider.
    const Judged judged = judge(world, picture, 1e-3L);
    drawn += judged.drawn;
    EXPECT_LT(judged.worst_depth, 0.6L) << i;
  }
  EXPECT_GT(drawn, 1000);
}

TEST_P(QuadricIn, H64_CameraInsideSeesTheFarSideOnlyOfDoubleSided) {
  world.quadrics = {{0, sphere(3, {0.2L, 0, 8})}};
  EXPECT_EQ(draw().statistics.depth_passes, 0U) << "its inside is a back face";
  world.material.double_sided = true;
  const Judged judged = judge(world, draw(), 1e-6L);
  EXPECT_GT(judged.drawn, world.view.width * world.view.height / 4);
  EXPECT_LT(judged.worst_depth, 0.6L);
}

TEST_P(QuadricIn, IsCutByTheNearAndFarPlanes) {
  int drawn = 0;
  for (const bool inside : {false, true}) {
    world.material.double_sided = inside;
    for (const Real z : {6.4L, 6.9L, 7.3L, -11.6L, -12.4L}) {
      world.quadrics = {{0, sphere(0.8L, {0.1L, 0.05L, z})}, {0, sphere(0.3L, {-0.4L, -0.1L, 6.5L})}};
      const DepthPicture picture = draw();
      ASSERT_TRUE(picture.status);
      const Judged judged = judge(world, picture, 1e-5L);
      drawn += judged.drawn;
      EXPECT_LT(judged.worst_depth, 1.0L) << static_cast<double>(z);
    }
  }
  EXPECT_GT(drawn, 1000);
}

TEST_P(QuadricIn, LightIsThatOfItsNormal) {
  std::mt19937 random(12);
  world.material = {.colour = {250, 200, 150, 255}};
  world.quadrics = {{0, transform_of(any_axes(random, 2, 1.2L, 0.5L), {0.5L, 0, 0})}};
  const DepthPicture picture = draw();
  ASSERT_TRUE(picture.status);
  const V light = unit({Real(world.light.x), Real(world.light.y), Real(world.light.z)});
  int judged = 0;
  for (int y = 0; y < world.view.height; ++y) {
    for (int x = 0; x < world.view.width; ++x) {
      const Ray ray = ray_through(world.camera, world.view, x + Real{0.5}, y + Real{0.5});
      const Crossing crossing = cross_quadric(ray, world.quadrics[0].transform);
      if (crossing.clearance < 1e-3L) continue;
      const Real cosine = std::max(Real{0}, dot(crossing.enter.normal, light));
      const int pixel = picture::pixel_of(picture, x, y, world.view.width);
      const Real red = 250 * (48 + 200 * cosine) / 255, green = 200 * (48 + 190 * cosine) / 255;
      EXPECT_NEAR(pixel >> 11, static_cast<double>(std::min(red, Real{255}) / 8 - 0.5L), 1.0) << x << ',' << y;
      EXPECT_NEAR((pixel >> 5) & 63, static_cast<double>(std::min(green, Real{255}) / 4 - 0.5L), 1.4) << x << ',' << y;
      ++judged;
    }
  }
  EXPECT_GT(judged, 150);
}

TEST_P(QuadricIn, TexturesAreMappedByLongitudeAndLatitude) {
  std::mt19937 random(13);
  constexpr int kColumns = 64, kRows = 32;
  for (int i = 0; i < kColumns * kRows; ++i) world.texels.push_back(static_cast<std::uint16_t>(i + 1));
  world.texture.log2_width = 6;
  world.texture.log2_height = 5;
  world.material.texture = 0;
  world.quadrics = {{0, transform_of(any_axes(random, 2, 1.5L, 1), {0, 0, 0})}};
  const DepthPicture picture = draw();
  ASSERT_TRUE(picture.status);
  int judged = 0;
  for (int y = 0; y < world.view.height; ++y) {
    for (int x = 0; x < world.view.width; ++x) {
      const Ray ray = ray_through(world.camera, world.view, x + Real{0.5}, y + Real{0.5});
      const Crossing crossing = cross_quadric(ray, world.quadrics[0].transform);
      if (crossing.clearance < 1e-3L) continue;
      const V p = crossing.enter.surface;
      const Real u = (0.5L + std::atan2(p.x, p.z) / (2 * std::numbers::pi_v<Real>)) * kColumns;
      const Real v = std::acos(std::clamp(p.y, Real{-1}, Real{1})) / std::numbers::pi_v<Real> * kRows;
      const auto fraction = [](Real c) { return c - std::floor(c); };
      // Close to a texel's border either may be; longitudes crowd at the poles.
      const Real slack = 0.02L / std::max(Real{0.05}, std::hypot(p.x, p.z));
      if (std::abs(fraction(u) - 0.5L) > 0.5L - slack || std::abs(fraction(v) - 0.5L) > 0.48L) continue;
      const int texel = static_cast<int>(v) * kColumns + (static_cast<int>(u) & (kColumns - 1));
      EXPECT_EQ(picture::pixel_of(picture, x, y, world.view.width), texel + 1) << x << ',' << y;
      ++judged;
    }
  }
  EXPECT_GT(judged, 150);
}

TEST_P(QuadricIn, StripsAndGarbageChangeNothing) {
  std::mt19937 random(14);
  std::uniform_real_distribution<double> place(-3, 3), length(0.2, 2);
  world.material = {.colour = {250, 200, 150, 255}, .double_sided = true};
  for (int i = 0; i < 20; ++i) {
    world.quadrics.clear();
    for (int k = 0; k < 3; ++k) {
      world.quadrics.push_back({0, transform_of(any_axes(random, length(random), length(random), length(random)),
                                                {place(random), place(random), place(random) + 3})});
    }
    const DepthPicture whole = draw();
    ASSERT_TRUE(whole.status);
    for (const std::uint16_t rows : std::array<std::uint16_t, 3>{1, 5, 16}) {
      const DepthPicture strips =
          DepthRenderer(world.effects(), world.view, rows, 0x3C).draw(world.scene(), world.camera);
      EXPECT_EQ(strips.pixels, whole.pixels);
      EXPECT_EQ(strips.depth, whole.depth);
      EXPECT_EQ(strips.statistics.depth_passes, whole.statistics.depth_passes);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Both, QuadricIn, testing::Values(Projection::perspective, Projection::orthographic),
                         [](const auto& projection) {
                           return projection.param == Projection::perspective ? "Perspective" : "Orthographic";
                         });

/// A sphere as a mesh of 2 n^2 triangles or so, at the same place.
picture::Model tessellated(int n) {
  picture::Model model;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double polar = std::numbers::pi * j / n, azimuth = 2 * std::numbers::pi * i / n;
      const auto grid = [](double value) { return static_cast<std::int16_t>(std::lround(32767 * value)); };
      model.positions.push_back({grid(std::sin(polar) * std::sin(azimuth)), grid(std::cos(polar)),
                                 grid(std::sin(polar) * std::cos(azimuth))});
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const auto v = [n](int column, int row) { return static_cast<std::uint16_t>(row * (n + 1) + column); };
      model.triangles.push_back({v(i, j), v(i, j + 1), v(i + 1, j + 1)});
      model.triangles.push_back({v(i, j), v(i + 1, j + 1), v(i + 1, j)});
    }
  }
  model.mesh.half_extent = {65538, 65538, 65538};
  model.material.lit = false;
  return model;
}

// Hard case 65.
TEST(Quadric, H65_EqualsItsTwentyThousandTrianglesButForTheirError) {
  World world;
  world.view = {160, 160};
  world.camera.eye = {fixed(0.3), fixed(-0.2), fixed(4.0)};
  world.quadrics = {{0, Transform::identity()}};
  picture::Model model = tessellated(100);
  Scene triangles = model.scene();
  ASSERT_EQ(triangles.meshes[0].triangles.size(), 20000U);
  const DepthPicture exact = DepthRenderer(world.effects(), world.view, 160).draw(world.scene(), world.camera);
  const DepthPicture approximated =
      DepthRenderer(effects_of(triangles, world.camera) | effect::statistics, world.view, 160)
          .draw(triangles, world.camera);
  ASSERT_TRUE(exact.status && approximated.status);
  // Chords of 3.6 degrees lie up to 1 - cos(1.8 degrees) = 0.0005 below the sphere, twice that between two directions:
  // in codes, at the distance 3 and more and along the ray as steep as 1 / 0.2.
  int both = 0, one = 0;
  const auto at = [&](const DepthPicture& p, int x, int y) { return p.depth[static_cast<std::size_t>(y * 160 + x)]; };
  for (int y = 1; y < 159; ++y) {
    for (int x = 1; x < 159; ++x) {
      const std::uint32_t a = at(exact, x, y), b = at(approximated, x, y);
      if ((a == 0) != (b == 0)) {
        ++one;
        const bool is_rim = at(exact, x - 1, y) == 0 || at(exact, x + 1, y) == 0 || at(exact, x, y - 1) == 0 ||
                            at(exact, x, y + 1) == 0 || a == 0;
        EXPECT_TRUE(is_rim) << x << ',' << y;
        continue;
      }
      const Ray ray = ray_through(world.camera, world.view, x + Real{0.5}, y + Real{0.5});
      const Crossing crossing = cross_quadric(ray, world.quadrics[0].transform);
      if (a == 0 || crossing.clearance < 0.04L) continue;
      ++both;
      const Real slope = 0.002L / std::sqrt(crossing.clearance);
      const Real allowed =
          exact_code(world.camera, crossing.enter.w) - exact_code(world.camera, crossing.enter.w + slope) + 1;
      EXPECT_NEAR(a, b, static_cast<double>(allowed)) << x << ',' << y;
    }
  }
  EXPECT_GT(both, 3500);
  EXPECT_LE(one, 12) << "within a pixel of the silhouette";
}

TEST(Quadric, MeetsTrianglesWhereTheyCross) {
  // The plane z = 0.25 cuts the unit sphere in a circle of radius sqrt(1 - 1/16).
  World world;
  world.camera.projection = Projection::orthographic;
  world.camera.focal = fixed(0.5);
  world.view = {128, 128};
  world.material = {.colour = {255, 0, 0, 255}, .lit = false};
  picture::Model plane = picture::grid(1, fixed(1.9));
  plane.instance.transform.m[2][3] = fixed(0.25);
  plane.material.colour = {0, 255, 0, 255};
  Scene scene = plane.scene();
  const Material materials[] = {plane.material, world.material};
  const Quadric ball{1, Transform::identity()};
  scene.materials = materials;
  scene.quadrics = {&ball, 1};
  const DepthPicture picture =
      DepthRenderer(effects_of(scene, world.camera) | effect::statistics, world.view, 9).draw(scene, world.camera);
  ASSERT_TRUE(picture.status);
  const Real circle = std::sqrt(1 - 1 / Real{16});
  int red = 0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      const Real distance = std::hypot(x - 63.5L, y - 63.5L) / 32;
      if (std::abs(distance - circle) < 0.002L || distance > 1.8L) continue;
      const int pixel = picture::pixel_of(picture, x, y, 128);
      EXPECT_EQ(pixel, distance < circle ? 0xF800 : 0x07E0) << x << ',' << y;
      red += pixel == 0xF800;
    }
  }
  EXPECT_GT(red, 2000);
}

TEST(Quadric, EveryDepthFormatKeepsItsOwnMapping) {
  // Against a square that stands at the same distance as the sphere's nearest point and a little before and behind it.
  for (const picture::DepthKind& kind : picture::kDepthKinds) {
    World world;
    world.view = {65, 65};
    world.material = {.colour = {255, 0, 0, 255}, .lit = false};
    for (const int before : {-1, 1}) {
      picture::Model plane = picture::grid(1, fixed(0.2));
      plane.instance.transform.m[2][3] = kFixedOne + before * fixed(0.01);
      plane.material.colour = {0, 255, 0, 255};
      Scene scene = plane.scene();
      const Material materials[] = {plane.material, world.material};
      const Quadric ball{1, Transform::identity()};
      scene.materials = materials;
      scene.quadrics = {&ball, 1};
      DepthRenderer renderer(effects_of(scene, world.camera) | effect::statistics | kind.effect, world.view, 20);
      const DepthPicture picture = renderer.draw(scene, world.camera);
      ASSERT_TRUE(picture.status) << kind.name << ": " << message(picture.status.error);
      EXPECT_EQ(picture::pixel_of(picture, 32, 32, 65), before > 0 ? 0x07E0 : 0xF800) << kind.name;
    }
  }
}

TEST(Quadric, WhatItCannotBeIsRefused) {
  World world;
  world.quadrics = {{0, sphere(1, {0, 0, 0})}, {0, sphere(1, {0, 0, 0})}};
  const auto status = [&] {
    return DepthRenderer(world.effects(), world.view, 8).draw(world.scene(), world.camera).status;
  };
  ASSERT_TRUE(status());
  world.quadrics[1].transform.m[1][1] = 0;
  EXPECT_EQ(status(), (Status{.error = Error::quadric, .needed = 1})) << "flat";
  world.quadrics[1] = {1, Transform::identity()};
  EXPECT_EQ(validate(world.scene()), (Status{.error = Error::quadric, .needed = 1})) << "no such material";
  world.quadrics[1] = {0, sphere(300, {0, 0, 0})};
  EXPECT_EQ(validate(world.scene()), (Status{.error = Error::quadric, .needed = 1})) << "scale";
  world.quadrics.pop_back();
  world.material.depth_slope_bias = 1;
  EXPECT_EQ(validate(world.scene()), (Status{.error = Error::quadric, .needed = 0})) << "slope bias";
}

// Any numbers: an error or a picture, but nothing undefined.
TEST(Quadric, HostileTransformsAreHarmless) {
  std::mt19937 random(15);
  World world;
  world.material.double_sided = true;
  int drawn = 0;
  for (int i = 0; i < 3000; ++i) {
    Quadric quadric;
    for (auto& row : quadric.transform.m) {
      for (Fixed& value : row) value = static_cast<Fixed>(random()) >> (8 + random() % 24);
      row[3] = static_cast<Fixed>(random()) >> (random() % 32);
    }
    world.quadrics = {quadric};
    world.camera.projection = i % 2 == 0 ? Projection::perspective : Projection::orthographic;
    world.camera.near_plane = 1 + static_cast<Fixed>(random() >> (2 + random() % 29));
    world.camera.far_plane = world.camera.near_plane + 1 + static_cast<Fixed>(random() >> (2 + random() % 29));
    world.camera.fixed_depth_range = i % 4 < 2;
    world.camera.focal = 1 + static_cast<Fixed>(random() >> (1 + random() % 30));
    const DepthPicture picture = DepthRenderer(world.effects(), world.view, 24).draw(world.scene(), world.camera);
    EXPECT_TRUE(picture.status || picture.status.error == Error::quadric);
    drawn += picture.statistics.fragments != 0;
  }
  EXPECT_GT(drawn, 100);
}

// Flat ones, without an inverse, of which a camera's rotation leaves one by rounding: what was divided by was 0 then.
TEST(Quadric, FlatOnesDivideByNothingThatIsZero) {
  std::mt19937 random(16);
  World world;
  world.material.double_sided = true;
  const auto entry = [&random] { return random() % 2 == 0 ? 0 : 255 * kFixedOne; };
  int refused = 0;
  for (int i = 0; i < 20000; ++i) {
    Quadric quadric;
    for (auto& row : quadric.transform.m) {
      for (Fixed& value : row) value = entry();
      row[3] = static_cast<Fixed>(random() % 200000) - 100000;
    }
    for (int column = 0; column < 3; ++column) quadric.transform.m[i % 3][column] = 0;
    world.quadrics = {quadric};
    ASSERT_TRUE(orbit(world.camera, {0, 0, 0}, 3 * kFixedOne, static_cast<Angle>(random()),
                      static_cast<Angle>(random() % 4 * 16384)));
    world.camera.projection = i % 4 == 0 ? Projection::perspective : Projection::orthographic;
    world.camera.focal = 1 + static_cast<Fixed>(random() >> (8 + random() % 16));
    const DepthPicture picture = DepthRenderer(world.effects(), world.view, 24).draw(world.scene(), world.camera);
    EXPECT_TRUE(picture.status || picture.status.error == Error::quadric);
    refused += picture.status ? 0 : 1;
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
