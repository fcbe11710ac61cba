// Environment maps: where on the sphere map a vertex lies, against the definition in floating point; and
// that a picture of it is the picture of a mesh whose texture coordinates somebody has worked out.
#include <cmath>
#include <random>

#include "../oracle/vectors.hpp"
#include "drawn.hpp"
#include "zstrip/effects/environment/environment.hpp"
#include "zstrip/effects/exclusions.hpp"
#include "zstrip/effects/samples/samples.hpp"
#include "zstrip_scenes/effect_scenes.hpp"
#include "zstrip_scenes/knot.hpp"

namespace effects_test::environment_test {
namespace {

using namespace oracle;

/// As docs/conventions.md defines it: right and up on the map, 1 is its rim, and the cosine to the line of sight.
struct Mirrored {
  double x, y, cosine;
};
Mirrored mirrored(const Mesh& mesh, std::size_t vertex, const Transform& t, const Camera& camera) {
  const Point axes[3] = {of_axis(camera.right), of_axis(camera.up), of_axis(camera.back)};
  const Normal& normal = mesh.normals[vertex];
  const Position& p = mesh.positions[vertex];
  const double local[3] = {
      std::ldexp(mesh.centre.x, -16) + std::ldexp(mesh.half_extent.x, -16) * p.x / 32768,
      std::ldexp(mesh.centre.y, -16) + std::ldexp(mesh.half_extent.y, -16) * p.y / 32768,
      std::ldexp(mesh.centre.z, -16) + std::ldexp(mesh.half_extent.z, -16) * p.z / 32768,
  };
  const Point eye = of_place(camera.eye);
  Point world{}, to_eye{};
  for (std::size_t r = 0; r < 3; ++r) {
    const Fixed* const row = t.m[r];
    world[r] =
        std::ldexp(row[0], -16) * normal.x + std::ldexp(row[1], -16) * normal.y + std::ldexp(row[2], -16) * normal.z;
    to_eye[r] = eye[r] - (std::ldexp(row[0], -16) * local[0] + std::ldexp(row[1], -16) * local[1] +
                          std::ldexp(row[2], -16) * local[2] + std::ldexp(row[3], -16));
  }
  Point n{}, e{0, 0, 1};
  for (std::size_t a = 0; a < 3; ++a) n[a] = dot(world, axes[a]);
  n = unit(n);
  if (camera.projection == Projection::perspective) {
    for (std::size_t a = 0; a < 3; ++a) e[a] = dot(to_eye, axes[a]);
    e[2] = std::max(e[2], 0.0);
    e = unit(e);
  }
  // The rotation about e x z that turns e into z (Rodrigues).
  const double cosine = dot(n, e), share = (cosine + n[2]) / (1 + e[2]);
  return {n[0] - e[0] * share, n[1] - e[1] * share, cosine};
}

class Environment : public testing::Test {
 protected:
  double real(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  Fixed number(double low, double high) { return to_fixed(real(low, high)); }
  Camera camera(double distance = 1) {
    Camera camera;
    const auto angle = [this] { return static_cast<Angle>(random_() & 0xFFFF); };
    EXPECT_TRUE(orbit(camera, {number(-distance, distance), number(-distance, distance), number(-distance, distance)},
                      number(2 * distance, 6 * distance), angle(), angle()));
    return camera;
  }
  /// A rotation times `size`, from a random quaternion.
  Transform transform(double size, double away) {
    double q[4], square = 0;
    for (double& c : q) c = real(-1, 1), square += c * c;
    for (double& c : q) c /= std::sqrt(square);
    const auto [w, x, y, z] = q;
    const double rotation[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                                   {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                                   {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
    Transform t{};
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) t.m[r][c] = to_fixed(size * rotation[r][c]);
      t.m[r][3] = number(-away, away);
    }
    return t;
  }

  std::mt19937 random_{1971};
};

/// A bound in parts of the ball's radius, a thirty-second of a texel of 128; 0.00031 was measured.
constexpr double kBound = 1.0 / 2048;

TEST_F(Environment, PointsAreThoseOfTheDefinition) {
  double worst = 0;
  int perspective = 0, faced_away = 0, behind = 0;
  for (int i = 0; i < 20000; ++i) {
    const double size = std::pow(2.0, i % 13 - 6);  // 1/64 to 64
    Camera from = camera(size);
    if (i % 3 == 0) from.projection = Projection::orthographic;
    const Transform t = transform(size, size);
    const auto component = [this] { return static_cast<std::int16_t>(static_cast<int>(random_() % 65535) - 32767); };
    const Position position{component(), component(), component()};
    const Point direction = unit({real(-1, 1), real(-1, 1), real(-1, 1)});
    const auto step = [](double c) { return static_cast<std::int8_t>(std::lround(127 * c)); };
    const Normal normal{step(direction[0]), step(direction[1]), step(direction[2]), 0};
    const Mesh mesh{.positions = {&position, 1},
                    .normals = {&normal, 1},
                    .colours = {},
                    .texcoords = {},
                    .triangles = {},
                    .meshlets = {},
                    .centre = {number(-1, 1), number(-1, 1), number(-1, 1)},
                    .half_extent = {number(0, 2), number(0, 2), number(0, 2)}};
    Mirrored expected = mirrored(mesh, 0, t, from);
    const bool double_sided = i % 4 == 1;
    const detail::EyeForms forms = detail::eye_forms(mesh, t, from);
    const bool orthographic = from.projection == Projection::orthographic;
    perspective += orthographic ? 0 : 1;
    behind += !orthographic && forms.z.at(position) < 0 ? 1 : 0;
    const detail::MirroredPoint got = orthographic
                                          ? detail::mirrored_point<true>(forms, position, normal, double_sided)
                                          : detail::mirrored_point<false>(forms, position, normal, double_sided);
    const double radius = std::hypot(expected.x, expected.y);
    if (double_sided && std::abs(expected.cosine) < 0.01) continue;  // either side
    if (expected.cosine < 0) {
      ++faced_away;
      if (!double_sided && radius < 0.125) continue;  // hardly any direction to the rim
      const double by = double_sided ? -1 : 1 / radius;
      expected.x *= by, expected.y *= by;
    }
    // Away from the rim's middle its direction is as exact as the radius is long.
    const double bound = expected.cosine < 0 && !double_sided ? kBound / radius : kBound;
    const double off = std::hypot(std::ldexp(got.x, -14) - expected.x, std::ldexp(got.y, -14) - expected.y);
    worst = std::max(worst, off / bound * kBound);
    ASSERT_LE(off, bound) << i << ' ' << size << ' ' << expected.cosine << ' ' << orthographic;
  }
  EXPECT_GT(worst, kBound / 2) << "the bound says something";
  EXPECT_GT(perspective, 10000);
  EXPECT_GT(faced_away, 5000);
  EXPECT_GT(behind, 20);
}

TEST_F(Environment, CoordinatesStayBetweenTheMiddlesOfTheTexelsAtTheEdge) {
  for (std::uint8_t log2 = 0; log2 <= 11; ++log2) {
    const double first = std::ldexp(0.5, -log2), last = 1 - first;
    for (const std::int32_t rim : {-16385, -16384, 0, 16384, 16385}) {
      const TexCoord t = detail::texcoord_of({rim, -rim}, log2, log2);
      EXPECT_NEAR(std::ldexp(t.u, -15), rim < 0 ? first : rim > 0 ? last : 0.5, std::ldexp(1.001, -14)) << int{log2};
      EXPECT_EQ(t.v, t.u) << "v grows downwards";
      EXPECT_GE(t.u, 0);
    }
  }
  const TexCoord corner = detail::texcoord_of({-16384, 16384}, 5, 6);
  EXPECT_EQ(corner.u, 512);
  EXPECT_EQ(corner.v, 256);
}

TEST_F(Environment, TwoSamplesSideBySideMirrorAsOneDoes) {
  const Mesh& knot = scenes::kKnotLitMesh[0];
  for (int i = 0; i < 50; ++i) {
    const Camera from = camera();
    Camera halved = from;
    halved.up = {from.up.x >> 1, from.up.y >> 1, from.up.z >> 1};  // as camera_of_samples does
    const Transform t = transform(1, 0.5);
    const detail::EyeForms one = detail::eye_forms(knot, t, from), two = detail::eye_forms(knot, t, halved);
    for (std::size_t v = 0; v < knot.positions.size(); v += 7) {
      const auto a = detail::mirrored_point<false>(one, knot.positions[v], knot.normals[v], false);
      const auto b = detail::mirrored_point<false>(two, knot.positions[v], knot.normals[v], false);
      EXPECT_EQ(a.x, b.x);
      EXPECT_EQ(a.y, b.y);
    }
  }
}

TEST_F(Environment, CamerasWithoutAxesDivideByNothing) {
  Camera none = camera();
  none.right = none.up = none.back = {0, 0, 0};
  ASSERT_TRUE(usable(none));
  const detail::EyeForms forms = detail::eye_forms(scenes::kKnotLitMesh[0], transform(1, 0), none);
  const detail::MirroredPoint point = detail::mirrored_point<false>(forms, {1, 2, 3}, {127, 0, 0, 0}, false);
  EXPECT_EQ(point.x, 0);
  EXPECT_EQ(point.y, 0);
}

/// Texels that all differ from their neighbours.
constexpr auto kMap = [] {
  std::array<std::uint16_t, 1024 + 512> words{};
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = static_cast<std::uint16_t>(i * 40503 + 0x1234);
  return words;
}();

/// Two knots, one mirrors and the other has texels of its own; the second with coordinates of the test.
struct World {
  Mesh meshes[2] = {scenes::kKnotLitMesh[0], scenes::kKnotLitMesh[0]};
  std::vector<TexCoord> coordinates[2];
  Texture textures[2] = {{kMap, 5, 5}, {kMap, 4, 5}};
  Finish finishes[2] = {{.filter = TextureFilter::environment_nearest}, {.filter = TextureFilter::environment_nearest}};
  Material materials[2] = {{.colour = {220, 200, 160, 255}, .texture = 0, .finish = 0},
                           {.texture = 1, .lit = false, .finish = 1}};
  Instance instances[2] = {{.mesh = 0}, {.mesh = 1, .material = 1}};
  Scene scene;

  World() {
    scene.meshes = meshes;
    scene.materials = materials;
    scene.textures = textures;
    scene.instances = instances;
    scene.finishes = finishes;
    scene.lights = scenes::kKeyLight;
  }
  World(const World& other) : World() {
    std::ranges::copy(other.meshes, meshes);
    std::ranges::copy(other.textures, textures);
    std::ranges::copy(other.finishes, finishes);
    std::ranges::copy(other.materials, materials);
    std::ranges::copy(other.instances, instances);
    scene.fog = other.scene.fog;
  }
  World& operator=(const World&) = delete;

  /// The same, with texture coordinates where the camera sees the environment.
  World by_hand(const Camera& camera) const {
    World made(*this);
    for (std::size_t i = 0; i < 2; ++i) {
      Mesh& mesh = made.meshes[i];
      const Texture& texture = textures[materials[i].texture];
      const detail::EyeForms forms = detail::eye_forms(mesh, instances[i].transform, camera);
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const auto point =
            camera.projection == Projection::orthographic
                ? detail::mirrored_point<true>(forms, mesh.positions[v], mesh.normals[v], materials[i].double_sided)
                : detail::mirrored_point<false>(forms, mesh.positions[v], mesh.normals[v], materials[i].double_sided);
        made.coordinates[i].push_back(detail::texcoord_of(point, texture.log2_width, texture.log2_height));
      }
      mesh.texcoords = made.coordinates[i];
      mesh.texcoord_bits = 15;
      made.finishes[i].filter = is_bilinear(finishes[i].filter) ? TextureFilter::bilinear : TextureFilter::nearest;
    }
    return made;
  }
};

constexpr View kView{64, 48, PixelFormat::rgb565};
constexpr Effects kPlain = effect::lighting | effect::gouraud | effect::textures;

TEST_F(Environment, PicturesAreThoseOfMeshesWithTheseCoordinates) {
  std::ptrdiff_t shown = 0;
  for (int i = 0; i < 8; ++i) {
    const Camera from = camera(i % 4 == 3 ? 0.25 : 1);  // among the knots: what is behind the camera is cut off
    World world;
    for (Instance& instance : world.instances) instance.transform = transform(1, 0.6);
    world.materials[0].double_sided = i % 2 == 0;
    const World made = world.by_hand(from);
    ASSERT_EQ(without_shades(effects_of(world.scene, from)), kPlain | effect::environment);
    ASSERT_EQ(without_shades(effects_of(made.scene, from)), kPlain);
    const Drawn expected = draw<kPlain>(made.scene, from, kView);
    shown += std::ranges::count_if(expected.pixels, [](std::uint16_t pixel) { return pixel != 0; });
    constexpr Effects kEffects = kPlain | effect::environment;
    EXPECT_EQ(draw<kEffects>(world.scene, from, kView), expected) << i;
    EXPECT_EQ(draw<kEffects>(world.scene, from, kView, {.strip_rows = 5, .strip_columns = 16}), expected);
    EXPECT_EQ(draw_any(kEffects | effect::bins, world.scene, from, kView, {.strip_rows = 7, .modes = Modes::binned}),
              expected);
  }
  EXPECT_GT(shown, 3000);
}

TEST_F(Environment, SoWithFragmentsFormatsAndParallelRays) {
  for (const Effects more : {effect::orthographic, effect::fog, effect::bilinear, effect::depth_24, effect::alpha_test,
                             effect::perspective_8, effect::texture_alpha | effect::blending}) {
    SCOPED_TRACE(testing::Message() << std::hex << more.bits);
    Camera from = camera();
    World world;
    for (Instance& instance : world.instances) instance.transform = transform(1, 0.6);
    for (Finish& finish : world.finishes) {
      if (more.has(effect::bilinear)) finish.filter = TextureFilter::environment_bilinear;
      if (more.has(effect::alpha_test)) finish.alpha_mode = AlphaMode::mask;
      if (more.has(effect::blending)) finish.alpha_mode = AlphaMode::blend;
    }
    if (more.has(effect::texture_alpha)) {
      for (Texture& texture : world.textures) texture.format = TextureFormat::rgb565_alpha;
    }
    if (more.has(effect::orthographic)) from.projection = Projection::orthographic;
    if (more.has(effect::fog)) world.scene.fog = &scenes::kFog;
    const World made = world.by_hand(from);
    const Effects effects = effects_of(world.scene, from) | more;
    ASSERT_TRUE(effects.has(effect::environment));
    EXPECT_EQ(draw_any(effects, world.scene, from, kView, {.strip_rows = 9}),
              draw_any(effects_of(made.scene, from) | more, made.scene, from, kView));
  }
}

TEST_F(Environment, MethodsDrawIt) {
  // Not a picture of one colour: the same as without the method, or nearly so.
  const Camera from = camera();
  World world;
  world.instances[1].transform = transform(0.5, 0.4);
  const Effects effects = effects_of(world.scene, from);
  const Drawn expected = draw_any(effects, world.scene, from, kView);
  for (const Effects method : {method::front_to_back, method::hierarchical_z, method::midpoint_safe, method::culling}) {
    ASSERT_EQ(refused_by_methods(effects | method), Effects{});
    const Drawn drawn = draw_any(effects | method, world.scene, from, kView, {.strip_rows = 16});
    EXPECT_EQ(drawn, expected) << method.methods;
  }
  for (const Effects method : {method::in_order, method::bsp}) {
    EXPECT_TRUE(refused_by_methods(effects | method::painter | method).has(effect::environment));
  }
}

TEST_F(Environment, MaterialsWithoutMapAndMeshesWithoutNormalsAreRefused) {
  World world;
  ASSERT_TRUE(validate(world.scene));
  world.meshes[1].normals = {};
  Status status = validate(world.scene);
  EXPECT_EQ(status.error, Error::instance);
  EXPECT_EQ(status.needed, 1U);
  world.finishes[1].filter = TextureFilter::nearest;
  EXPECT_TRUE(validate(world.scene));
  world.materials[0].texture = kNoTexture;
  status = validate(world.scene);
  EXPECT_EQ(status.error, Error::material);
  EXPECT_EQ(status.needed, 0U);
  world.materials[0].texture = 0;
  world.finishes[1].filter = TextureFilter{0x12};
  status = validate(world.scene);
  EXPECT_EQ(status.error, Error::finish);
  EXPECT_EQ(status.needed, 1U);
}

TEST_F(Environment, TakesTheBytesThatThePlanSays) {
  World world;
  constexpr Effects kEffects = kPlain | effect::environment;
  const auto knot = static_cast<std::uint32_t>(world.meshes[0].positions.size());
  const Plan whole = zstrip::plan(count(world.scene), kView, kEffects).plan;
  const Plan without = zstrip::plan(count(world.scene), kView, kPlain).plan;
  EXPECT_EQ(whole.vertex_bytes - without.vertex_bytes, 4 * knot);
  EXPECT_EQ(whole.vertex_bytes, 16 * knot);
  EXPECT_EQ(whole.effect_bytes, 160U) << "16, 8 and 2 times 68";
}

}  // namespace
}  // namespace effects_test::environment_test
