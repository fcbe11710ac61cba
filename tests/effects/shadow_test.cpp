// Shadows against rays in double precision: every pixel is that of the picture with the light or that of the picture
// without it, and the rays say which, but within a texel or so of a shadow's edge.
#include <algorithm>
#include <cmath>
#include <random>

#include "drawn.hpp"
#include "shadow_oracle.hpp"

namespace effects_test {
namespace {

Fixed to_fixed(double value) { return static_cast<Fixed>(std::lround(std::ldexp(value, 16))); }

/// A mesh that owns its memory.
struct OwnMesh {
  std::vector<Position> positions;
  std::vector<Normal> normals;
  std::vector<Triangle> triangles;

  Mesh mesh(ShadowRole role = ShadowRole::casts_and_receives) const {
    return {.positions = positions,
            .normals = normals,
            .colours = {},
            .texcoords = {},
            .triangles = triangles,
            .meshlets = {},
            .shadow = role};
  }
};

OwnMesh sphere(int rings, int segments) {
  OwnMesh own;
  for (int ring = 0; ring <= rings; ++ring) {
    for (int segment = 0; segment < segments; ++segment) {
      const double down = 3.14159265358979 * ring / rings, around = 2 * 3.14159265358979 * segment / segments;
      const std::array n{std::sin(down) * std::cos(around), std::cos(down), std::sin(down) * std::sin(around)};
      const auto place = [&n](std::size_t axis) { return static_cast<std::int16_t>(std::lround(32767 * n[axis])); };
      const auto normal = [&n](std::size_t axis) { return static_cast<std::int8_t>(std::lround(127 * n[axis])); };
      own.positions.push_back({place(0), place(1), place(2)});
      own.normals.push_back({normal(0), normal(1), normal(2), 0});
      if (ring == rings) continue;
      const int right = (segment + 1) % segments;
      const auto vertex = [segments](int r, int s) { return static_cast<std::uint16_t>(r * segments + s); };
      own.triangles.push_back({vertex(ring, segment), vertex(ring, right), vertex(ring + 1, right)});
      own.triangles.push_back({vertex(ring, segment), vertex(ring + 1, right), vertex(ring + 1, segment)});
    }
  }
  return own;
}

/// Each face has corners of its own.
OwnMesh box() {
  OwnMesh own;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      const auto first = static_cast<std::uint16_t>(own.positions.size());
      for (const auto& [u, v] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        std::array<int, 3> p{};
        p[axis] = side;
        p[(axis + 1) % 3] = side * u;
        p[(axis + 2) % 3] = v;
        const auto place = [&p](std::size_t i) { return static_cast<std::int16_t>(32767 * p[i]); };
        own.positions.push_back({place(0), place(1), place(2)});
        std::array<std::int8_t, 3> n{};
        n[axis] = static_cast<std::int8_t>(127 * side);
        own.normals.push_back({n[0], n[1], n[2], 0});
      }
      const auto corner = [first](int i) { return static_cast<std::uint16_t>(first + i); };
      own.triangles.push_back({corner(0), corner(1), corner(2)});
      own.triangles.push_back({corner(0), corner(2), corner(3)});
    }
  }
  return own;
}

/// Turned about the vertical axis.
Transform placed(double x, double y, double z, double scale, double turn = 0) {
  const double c = scale * std::cos(turn), s = scale * std::sin(turn);
  return {{{to_fixed(c), 0, to_fixed(s), to_fixed(x)},
           {0, to_fixed(scale), 0, to_fixed(y)},
           {to_fixed(-s), 0, to_fixed(c), to_fixed(z)}}};
}

Transform stretched(Transform transform, double x, double y, double z) {
  const double factors[3] = {x, y, z};
  for (auto& row : transform.m) {
    for (int column = 0; column < 3; ++column)
      row[column] = static_cast<Fixed>(std::lround(row[column] * factors[column]));
  }
  return transform;
}

DirectionalLight light_from(double x, double y, double z, Colour colour = {180, 170, 150, 255}) {
  const double length = std::sqrt(x * x + y * y + z * z);
  const auto component = [length](double c) { return static_cast<std::int16_t>(std::lround(32767 * c / length)); };
  return {component(x), component(y), component(z), colour};
}

constexpr Effects kShadowed = effect::lighting | effect::gouraud | effect::shadows | effect::quadrics;
constexpr View kView{128, 96, PixelFormat::rgb565};
constexpr double kPixel =
    6 / (2.2 * 48);  ///< of World's camera, at what it looks at; vertices are snapped to sixteenths

/// A floor with a box, a ball of triangles and a sphere on it.
struct World {
  OwnMesh cube = box(), ball = sphere(24, 48);
  Mesh meshes[3];
  Material materials[2] = {{.colour = {220, 220, 220, 255}}, {.colour = {240, 120, 80, 255}, .smooth = true}};
  Instance instances[3];
  Quadric quadrics[1];
  DirectionalLight lights[2] = {light_from(0.4, 1, 0.3), light_from(-1, 0.4, 0.5, {60, 60, 90, 255})};
  Shadow shadow{.light = 0, .log2_size = 8};
  Scene scene;
  Camera camera;

  World() {
    // Scaled in the mesh: light wants transforms of one scale.
    meshes[0] = cube.mesh(ShadowRole::only_receives);
    meshes[0].half_extent = {fixed(3), fixed(0.1), fixed(3)};
    meshes[1] = cube.mesh();
    meshes[1].half_extent = {fixed(0.4), fixed(0.5), fixed(0.6)};
    meshes[2] = ball.mesh();
    materials[0].smooth = false;
    instances[0] = {0, 0, placed(0, -0.1, 0, 1)};
    instances[1] = {1, 1, placed(-0.9, 0.5, 0.1, 1, 0.5)};
    instances[2] = {2, 1, placed(0.7, 0.8, -0.5, 0.5)};
    quadrics[0] = {1, stretched(placed(0.5, 0.45, 0.9, 1, 0.7), 0.6, 0.4, 0.35)};
    scene.meshes = meshes;
    scene.materials = materials;
    scene.instances = instances;
    scene.quadrics = quadrics;
    scene.lights = lights;
    scene.shadow = &shadow;
    scene.ambient = {50, 50, 60, 255};
    EXPECT_TRUE(orbit(camera, {0, to_fixed(0.4), 0}, to_fixed(6), 3000, 10000));
    camera.focal = fixed(2.2);
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  Scene with_all_light() const {
    Scene lit = scene;
    lit.shadow = nullptr;
    return lit;
  }
  /// Without the light of the shadow; the others keep their order.
  Scene without_light() {
    std::size_t next = 0;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
      if (i != shadow.light) others_[next++] = scene.lights[i];
    }
    Scene dark = with_all_light();
    dark.lights = {others_, next};
    return dark;
  }

 private:
  DirectionalLight others_[kMaxLights];
};

/// Of RGB565, the largest difference of a channel, of 31.
int difference(std::uint16_t a, std::uint16_t b) {
  const auto apart = [](int one, int other) { return std::abs(one - other); };
  return std::max({apart(a >> 11, b >> 11), apart(a >> 6 & 31, b >> 6 & 31), apart(a & 31, b & 31)});
}

/// World units of a texel along the longer side of what casts, as the definition of the map has it: the extent of the
/// casters' boxes across the light, and one texel more on each side.
double texel_of(const World& world) {
  const DirectionalLight& light = world.lights[world.shadow.light];
  const oracle::Point back = oracle::unit({1.0 * light.x, 1.0 * light.y, 1.0 * light.z});
  const oracle::Point right = oracle::unit(oracle::cross({0, 1, 0}, back)), up = oracle::cross(back, right);
  double extent = 0;
  for (const oracle::Point& axis : {right, up}) {
    double low = 1e9, high = -1e9;
    const auto extend = [&](const Transform& transform, const Vec3& half) {
      double middle = 0, reach = 0;
      for (std::size_t row = 0; row < 3; ++row) middle += axis[row] * std::ldexp(transform.m[row][3], -16);
      const std::int32_t halves[3] = {half.x, half.y, half.z};
      for (std::size_t column = 0; column < 3; ++column) {
        double along = 0;
        for (std::size_t row = 0; row < 3; ++row) along += axis[row] * std::ldexp(transform.m[row][column], -16);
        reach += std::abs(along) * std::ldexp(halves[column], -16);
      }
      low = std::min(low, middle - reach);
      high = std::max(high, middle + reach);
    };
    for (const Instance& instance : world.scene.instances) {
      const Mesh& mesh = world.scene.meshes[instance.mesh];
      if (casts_shadow(mesh.shadow)) extend(instance.transform, mesh.half_extent);
    }
    for (const Quadric& quadric : world.scene.quadrics) extend(quadric.transform, {kFixedOne, kFixedOne, kFixedOne});
    extent = std::max(extent, high - low);
  }
  return extent / ((1 << world.shadow.log2_size) - 2);
}

struct Judged {
  int differ = 0;    ///< pixels in which light shows
  int shadowed = 0;  ///< of them
  int neither = 0;   ///< pixels of none of both pictures
  int at_edge = 0;   ///< not as the rays say, near an edge
  int wrong = 0;     ///< not as the rays say, elsewhere
};

Judged judge(World& world, const Drawn& drawn, const Drawn& lit, const Drawn& dark, double reach) {
  const oracle::ShadowOracle rays(world.scene, world.camera, kView);
  Judged judged;
  for (int y = 0; y < drawn.height; ++y) {
    for (int x = 0; x < drawn.width; ++x) {
      const bool is_lit = drawn.at(x, y) == lit.at(x, y), is_dark = drawn.at(x, y) == dark.at(x, y);
      if (!is_lit && !is_dark) ++judged.neither;
      if (is_lit && is_dark) continue;
      ++judged.differ;
      const auto surface = rays.seen(x, y);
      if (!surface) continue;
      const bool shadowed = surface->receives && rays.shadowed(surface->at, 1e-3);
      judged.shadowed += shadowed ? 1 : 0;
      if (shadowed == is_dark) continue;
      if (rays.is_far_from_edge(*surface, reach, 1e-3)) {
        ++judged.wrong;
        if (judged.wrong < 6) ADD_FAILURE() << x << ' ' << y << (shadowed ? " has light" : " has none");
      } else {
        ++judged.at_edge;
      }
    }
  }
  return judged;
}

template <Effects effects>
Judged judged_with(World& world, const View& view = kView) {
  constexpr Effects kPlain = without(effects, effect::shadows);
  const Drawn drawn = draw<effects>(world.scene, world.camera, view);
  const Drawn lit = draw<kPlain>(world.with_all_light(), world.camera, view);
  const Drawn dark = draw<kPlain>(world.without_light(), world.camera, view);
  return judge(world, drawn, lit, dark, 1.5 * texel_of(world) + kPixel / 8);
}

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
  expect_right(judged_with<kShadowed | effect::depth_32>(world), "z32");
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
  EXPECT_LT(differ(draw<kShadowed>(world.scene, world.camera, kView)), all / 2);
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
  const auto begun = [&](std::uint32_t pool) {
    world.shadow.pool = pool;
    const Plan plan = zstrip::plan(count(world.scene), kView, kShadowed).plan;
    std::vector<std::uint64_t> arena(plan.bytes() / 8 + 1);
    Renderer<kShadowed> renderer;
    return renderer.begin_frame(world.scene, world.camera, kView, plan, std::as_writable_bytes(std::span(arena)));
  };
  Status status = begun(8);
  EXPECT_EQ(status.error, Error::store_full) << "no room for the index";
  EXPECT_EQ(status.purpose, Purpose::effects);
  std::uint32_t enough = 2048;
  while (!(status = begun(enough))) {
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
    for (std::uint32_t Plan::*const part :
         {&Plan::effect_bytes, &Plan::depth_bytes, &Plan::extent_bytes, &Plan::vertex_bytes}) {
      Plan plan = right;
      plan.*part -= 8;
      std::vector<std::uint64_t> arena(right.bytes() / 8 + 1);
      Renderer<kShadowed | effect::bins> renderer;
      const Status status =
          renderer.begin_frame(world.scene, world.camera, kView, plan, std::as_writable_bytes(std::span(arena)));
      EXPECT_EQ(status.error, Error::arena_too_small);
      EXPECT_GT(status.needed, plan.*part);
    }
  }
}

TEST(Shadows, WhatCannotBeIsRefused) {
  World world;
  ASSERT_TRUE(validate(world.scene));
  EXPECT_EQ(effects_of(world.scene, world.camera), kShadowed);
  EXPECT_EQ(effects_of(world.with_all_light(), world.camera), without(kShadowed, effect::shadows));
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
  EXPECT_FALSE(depth_effects_agree(effect::shadows | effect::depth_w16));
  EXPECT_FALSE(depth_effects_agree(effect::shadows | effect::depth_ranges));
  const Budget layer{.strip_rows = 8, .layer = {.depth = 4096, .colour = 4096}};
  EXPECT_EQ(plan(count(world.scene), kView, kShadowed, layer).status.error, Error::shadow);
  world.materials[1].depth_test = DepthTest::nearer;
  const Plan plan = zstrip::plan(count(world.scene), kView, kShadowed).plan;
  std::vector<std::uint64_t> arena(plan.bytes() / 8 + 1);
  Renderer<kShadowed> renderer;
  ASSERT_TRUE(renderer.begin_frame(world.scene, world.camera, kView, plan, std::as_writable_bytes(std::span(arena))));
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
  std::vector<std::uint64_t> arena(plan.bytes() / 8 + 1), pixels(plan.strip_pixel_bytes(kView) / 8 + 1);
  Renderer<kShadowed> renderer;
  const Status begun =
      renderer.begin_frame(world.scene, world.camera, kView, plan, std::as_writable_bytes(std::span(arena)));
  EXPECT_EQ(begun.error, Error::shadow);
  EXPECT_EQ(renderer.draw_strip(0, std::as_writable_bytes(std::span(pixels))).error, Error::not_begun);
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
