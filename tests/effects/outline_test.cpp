// Outlines: where a vertex moves, against the definition in floating point; how wide they are around spheres and boxes;
// and that nothing of what they surround changes.
#include <array>
#include <cmath>
#include <random>

#include "../oracle/vectors.hpp"
#include "drawn.hpp"
#include "outlines_scene.hpp"
#include "own_mesh.hpp"
#include "zstrip/effects/billboards/billboard.hpp"
#include "zstrip/effects/exclusions.hpp"
#include "zstrip/effects/outlines/outline.hpp"

namespace effects_test::outline_test {
namespace {

using namespace oracle;

constexpr Colour kRed{255, 0, 0, 255};
constexpr std::uint16_t kRedPixel = 0xF800;

using zstrip::test::OwnMesh;
using zstrip::test::sphere;

/// The box's eight corners, with the sums of their faces' normals.
OwnMesh box() {
  OwnMesh own;
  for (int i = 0; i < 8; ++i) {
    const auto side = [i](int axis) { return (i >> axis & 1) != 0 ? 1 : -1; };
    const auto place = [&side](int axis) { return static_cast<std::int16_t>(32767 * side(axis)); };
    const auto normal = [&side](int axis) { return static_cast<std::int8_t>(127 * side(axis)); };
    own.positions.push_back({place(0), place(1), place(2)});
    own.normals.push_back({normal(0), normal(1), normal(2), 0});
  }
  for (const auto& [a, b, c, d] : {std::array<std::uint16_t, 4>{0, 2, 3, 1},
                                   {4, 5, 7, 6},
                                   {0, 1, 5, 4},
                                   {2, 6, 7, 3},
                                   {0, 4, 6, 2},
                                   {1, 3, 7, 5}}) {
    own.triangles.push_back({a, b, c});
    own.triangles.push_back({a, c, d});
  }
  return own;
}

constexpr Effects kOutlined = effect::outlines;

/// One white thing, without light, on black.
struct World {
  OwnMesh own;
  Mesh meshes[1];
  Outline outlines[1];
  Material materials[1] = {{.lit = false}};
  Instance instances[1] = {};
  Scene scene;

  World(const OwnMesh& shape, double width) : own(shape) {
    meshes[0] = own.mesh();
    meshes[0].outline = 1;
    outlines[0] = {.colour = kRed, .width = static_cast<std::uint16_t>(16 * width)};
    scene.meshes = meshes;
    scene.outlines = outlines;
    scene.materials = materials;
    scene.instances = instances;
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  /// The same without its outline.
  Scene plain() {
    without_[0] = meshes[0];
    without_[0].outline = 0;
    Scene scene_without = scene;
    scene_without.meshes = without_;
    return scene_without;
  }

 private:
  Mesh without_[1];
};

Camera camera_at(double distance, std::int32_t turn = 0, std::int32_t tilt = 0) {
  Camera camera;
  EXPECT_TRUE(orbit(camera, {0, 0, 0}, to_fixed(distance), turn, tilt));
  camera.focal = fixed(2);
  return camera;
}

/// Of pixels: how far the farthest red one is from the nearest white one, the nearest black one likewise, and the least
/// distance of something that is neither from the picture's border.
struct Widths {
  double widest = 0, narrowest = 1e9;
};
Widths widths_of(const Drawn& drawn) {
  Widths widths;
  std::vector<std::pair<int, int>> white;
  const auto is_white = [&](int x, int y) { return drawn.at(x, y) == 0xFFFF; };
  for (int y = 0; y < drawn.height; ++y) {
    for (int x = 0; x < drawn.width; ++x) {
      if (is_white(x, y)) white.emplace_back(x, y);
    }
  }
  for (int y = 0; y < drawn.height; ++y) {
    for (int x = 0; x < drawn.width; ++x) {
      if (is_white(x, y)) continue;
      double nearest = 1e9;
      for (const auto& [i, k] : white) nearest = std::min(nearest, std::hypot(x - i, y - k));
      if (drawn.at(x, y) == 0) {
        widths.narrowest = std::min(widths.narrowest, nearest);
      } else {
        EXPECT_EQ(drawn.at(x, y), kRedPixel);
        widths.widest = std::max(widths.widest, nearest);
      }
    }
  }
  return widths;
}

/// White pixels where there were some, nothing else within.
void expect_same_inside(const Drawn& with, const Drawn& without) {
  int different = 0;
  for (std::size_t i = 0; i < with.pixels.size(); ++i) {
    different += (with.pixels[i] == 0xFFFF) != (without.pixels[i] == 0xFFFF) ? 1 : 0;
  }
  EXPECT_EQ(different, 0) << "of " << std::ranges::count(without.pixels, 0xFFFF);
}

constexpr View kView{96, 80, PixelFormat::rgb565};

TEST(Outlines, OfASphereAreAsWideAllAround) {
  for (const double width : {1.0, 2.0, 3.5, 8.0}) {
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.9, 0.0}, {-0.5, 0.7}, {0.6, -0.6}}) {
      World world(sphere(32, 64), width);
      world.instances[0].transform.m[0][3] = to_fixed(x);
      world.instances[0].transform.m[1][3] = to_fixed(y);
      const Camera camera = camera_at(5);
      const Drawn drawn = draw<kOutlined>(world.scene, camera, kView);
      const Widths widths = widths_of(drawn);
      EXPECT_LE(widths.widest, width + 1) << width << ' ' << x << ' ' << y;
      EXPECT_GE(widths.narrowest, width - 1 + 0.5) << width << ' ' << x << ' ' << y;
      expect_same_inside(drawn, draw<Effects{}>(world.plain(), camera, kView));
    }
  }
}

TEST(Outlines, CoverWhatALargerSphereDoes) {
  // In parallel projection a sphere with an outline is a sphere with a longer radius.
  constexpr Effects kParallel = kOutlined | effect::orthographic;
  World world(sphere(48, 96), 4);
  Camera camera = camera_at(5);
  camera.projection = Projection::orthographic;
  camera.focal = fixed(0.5);  // 20 pixels a unit
  const Drawn drawn = draw<kParallel>(world.scene, camera, kView);
  for (int i = 0; i < 3; ++i) world.instances[0].transform.m[i][i] = to_fixed(1.2);
  const Drawn larger = draw<effect::orthographic>(world.plain(), camera, kView);
  int different = 0, covered = 0;
  for (std::size_t i = 0; i < drawn.pixels.size(); ++i) {
    different += (drawn.pixels[i] != 0) != (larger.pixels[i] != 0) ? 1 : 0;
    covered += larger.pixels[i] != 0 ? 1 : 0;
  }
  EXPECT_GT(covered, 1700);
  EXPECT_LE(different, 2) << "pixels at the edge";
}

TEST(Outlines, OfABoxAreAsWideAlongItsEdges) {
  for (const double distance : {5.0, 9.0}) {
    World world(box(), 3);
    const Camera camera = camera_at(distance);
    const Drawn drawn = draw<kOutlined>(world.scene, camera, kView);
    const Drawn without = draw<Effects{}>(world.plain(), camera, kView);
    expect_same_inside(drawn, without);
    // The middle row and column: the near face, then three pixels.
    for (const bool across : {true, false}) {
      int red = 0, white = 0;
      for (int i = 0; i < (across ? 96 : 80); ++i) {
        const std::uint16_t pixel = across ? drawn.at(i, 40) : drawn.at(48, i);
        red += pixel == kRedPixel ? 1 : 0;
        white += pixel == 0xFFFF ? 1 : 0;
      }
      // On both sides. The near face's corners move towards the eye, too, which adds up to a 20th of the box.
      EXPECT_GE(red, 6) << distance;
      EXPECT_LE(red, 8) << distance;
      EXPECT_GT(white, 10);
    }
  }
}

// A hull moved on the screen alone had the far side of a plate in front of its near one.
TEST(Outlines, OfAThinPlateStayBehindIt) {
  for (const double thickness : {0.2, 0.05, 0.02}) {
    for (int turn = 0; turn < 16; ++turn) {
      World world(box(), 4);
      world.instances[0].transform.m[2][2] = to_fixed(thickness);
      world.instances[0].transform.m[0][3] = to_fixed(turn % 3 * 0.4 - 0.4);
      // Its normals as those of a plate that is not scaled.
      world.meshes[0].half_extent.z = world.instances[0].transform.m[2][2];
      world.instances[0].transform.m[2][2] = kFixedOne;
      const Camera camera = camera_at(5, 4096 * turn + 900, 3000 + 700 * turn);
      SCOPED_TRACE(testing::Message() << thickness << ' ' << turn);
      expect_same_inside(draw<kOutlined>(world.scene, camera, kView), draw<Effects{}>(world.plain(), camera, kView));
    }
  }
}

TEST(Outlines, ReachIntoThePicture) {
  // 2 units a half picture's height at distance 5: the sphere's edge is beside the picture, its outline is not.
  World world(sphere(32, 64), 16);
  world.instances[0].transform.m[0][3] = to_fixed(4.2);
  const Camera camera = camera_at(5);
  const Drawn without = draw<Effects{}>(world.plain(), camera, kView);
  ASSERT_EQ(std::ranges::count(without.pixels, 0xFFFF), 0);
  const Drawn drawn = draw<kOutlined>(world.scene, camera, kView);
  EXPECT_GT(std::ranges::count(drawn.pixels, kRedPixel), 20);
  EXPECT_EQ(draw<kOutlined>(world.scene, camera, kView, {.strip_rows = 7, .strip_columns = 16}), drawn);
}

TEST(Outlines, AreAsWideWithSamples) {
  constexpr Effects kSampled = kOutlined | effect::supersampled;
  for (const std::uint8_t samples : {std::uint8_t{2}, std::uint8_t{4}}) {
    World world(sphere(32, 64), 3);
    View view = kView;
    view.samples = samples;
    Drawn drawn = draw<kSampled>(world.scene, camera_at(5), view);
    // A pixel is what most of its samples are.
    for (std::uint16_t& pixel : drawn.pixels) {
      const int red = pixel >> 11, green = pixel >> 5 & 0x3F;
      pixel = red < 16 ? std::uint16_t{0} : green < 32 ? kRedPixel : std::uint16_t{0xFFFF};
    }
    const Widths widths = widths_of(drawn);
    EXPECT_LE(widths.widest, 4) << int{samples};
    EXPECT_GE(widths.narrowest, 2.5) << int{samples};
  }
}

TEST(Outlines, AreTheSameInStripsAndBins) {
  constexpr Effects kBinned = kOutlined | effect::bins;
  std::mt19937 random(99);
  std::ptrdiff_t red = 0;
  for (int i = 0; i < 40; ++i) {
    World world(i % 2 == 0 ? sphere(12, 16) : box(), 1 + i % 16);
    // Some of them around the eye: cut by the near plane, beside the guard band.
    const auto number = [&random](double low, double high) {
      return to_fixed(std::uniform_real_distribution(low, high)(random));
    };
    for (int axis = 0; axis < 3; ++axis) {
      world.instances[0].transform.m[axis][3] = number(-2, 2);
      world.instances[0].transform.m[axis][axis] = number(0.2, i % 5 == 0 ? 200 : 2);
    }
    const Camera camera = camera_at(3, static_cast<std::int32_t>(random() & 0xFFFF), 1000 * (i % 12));
    const Drawn whole = draw<kOutlined>(world.scene, camera, kView);
    EXPECT_EQ(draw<kOutlined>(world.scene, camera, kView, {.strip_rows = 5, .strip_columns = 16}), whole) << i;
    EXPECT_EQ(draw<kBinned>(world.scene, camera, kView, {.strip_rows = 9, .modes = Modes::binned}), whole) << i;
    red += std::ranges::count(whole.pixels, kRedPixel);
  }
  EXPECT_GT(red, 5000);
}

TEST(Outlines, OfWhatTurnsWithTheCameraTurnToo) {
  for (const Billboard billboard : {Billboard::viewer, Billboard::upright}) {
    World world(box(), 3);
    world.meshes[0].billboard = billboard;
    const Camera camera = camera_at(5, 9000, 5000);
    const Drawn drawn = draw<kOutlined | effect::billboards>(world.scene, camera, kView);
    world.meshes[0].billboard = Billboard::none;
    world.instances[0].transform = detail::turned_to_viewer(world.instances[0].transform, billboard, camera);
    EXPECT_EQ(drawn, draw<kOutlined>(world.scene, camera, kView));
  }
}

// Its hull mirrored them, too.
TEST(Outlines, OfReflectiveMaterialsHaveTheirOwnColour) {
  constexpr Effects kMirroring = kOutlined | effect::environment | effect::textures;
  World world(sphere(32, 64), 4);
  const Camera camera = camera_at(5);
  const Drawn white = draw<kOutlined>(world.scene, camera, kView);
  const std::array<std::uint16_t, 2> green{0x07E0, 0x07E0};
  const Texture texture{.texels = green, .log2_width = 0, .log2_height = 0};
  const Finish mirror{.filter = TextureFilter::environment_nearest};
  world.materials[0].texture = 0;
  world.materials[0].finish = 0;
  world.scene.textures = {&texture, 1};
  world.scene.finishes = {&mirror, 1};
  Drawn drawn = draw<kMirroring>(world.scene, camera, kView);
  EXPECT_GT(std::ranges::count(drawn.pixels, 0x07E0), 100);
  std::ranges::replace(drawn.pixels, 0x07E0, 0xFFFF);
  EXPECT_EQ(drawn, white);
}

TEST(Outlines, VerticesMoveAsTheDefinitionSays) {
  std::mt19937 random(5);
  const auto between = [&random](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  double most = 0;
  for (int i = 0; i < 4000; ++i) {
    OwnMesh own;
    Point n = unit({between(-1, 1), between(-1, 1), between(-1, 1)});
    own.positions = {{static_cast<std::int16_t>(between(-32767, 32767)), 0, 5}};
    own.normals = {{static_cast<std::int8_t>(std::lround(127 * n[0])),
                    static_cast<std::int8_t>(std::lround(127 * n[1])),
                    static_cast<std::int8_t>(std::lround(127 * n[2])), 0}};
    n = {own.normals[0].x / 127.0, own.normals[0].y / 127.0, own.normals[0].z / 127.0};
    World world(own, 1 + i % 16);
    Camera camera = camera_at(between(3, 60), static_cast<std::int32_t>(random() & 0xFFFF), 500 * (i % 30));
    const bool parallel = i % 3 == 0;
    if (parallel) camera.projection = Projection::orthographic, camera.focal = to_fixed(between(0.02, 2));
    const double scale = between(0.1, 4);
    for (int axis = 0; axis < 3; ++axis) world.instances[0].transform.m[axis][axis] = to_fixed(scale);
    const DepthFit fit = fit_depth(distance_of(fixed(1)), distance_of(fixed(90)));
    detail::CompiledInstance compiled;
    ASSERT_TRUE(detail::compile_instance(compiled, world.scene, world.instances[0], camera, kView, fit));
    const std::int32_t w = compiled.w.at(own.positions[0]);
    detail::make_outline(compiled, world.outlines[0], world.instances[0].transform, camera, kView, fit);
    const detail::HullVertex moved = parallel ? detail::hull_vertex<true>(compiled, world.meshes[0], 0)
                                              : detail::hull_vertex<false>(compiled, world.meshes[0], 0);
    const double right = dot(n, of_axis(camera.right)), down = -dot(n, of_axis(camera.up));
    const double away = -dot(n, of_axis(camera.back));
    const double share = std::min(1.0, (1 + right * right + down * down) / 2);
    const double width = world.outlines[0].width;                            // 1/16 pixels
    const double pixels = std::ldexp(camera.focal, -16) * kView.height / 2;  // a unit of length, at distance 1
    const double reach = width / 16 / pixels;
    const double deeper = share * away * std::min(reach, parallel ? 1e9 : 0.5);
    const double smaller = parallel ? 1 : 1 - deeper;
    EXPECT_NEAR(moved.right, width * share * right * smaller, 0.6 + width * 0.001) << i;
    EXPECT_NEAR(moved.down, width * share * down * smaller, 0.6 + width * 0.001) << i;
    // A step of w in units of length: from the distances that its range spans. No hull is beyond 2^30 steps.
    const double steps = (static_cast<double>(compiled.w_near) + compiled.w_range) / 90;
    const double deeper_by = parallel ? deeper * steps : deeper * w;
    const double expected = std::clamp(w + deeper_by, 1 - std::ldexp(1, 30), std::ldexp(1, 30) - 1);
    EXPECT_NEAR(moved.w, expected, 3 + 0.002 * std::abs(deeper_by) + 0.001 * reach * (parallel ? steps : w)) << i;
    most = std::max(most, std::abs(deeper_by) / w);
  }
  EXPECT_GT(most, 0.02);
}

// What was weighed as their cost had no normals, which only validate() looks for.
TEST(Outlines, OfTheSceneThatIsWeighedAreValid) { EXPECT_TRUE(validate(scenes::outlines.scene)); }

TEST(Outlines, WhatIsNoneIsRefused) {
  World world(sphere(6, 8), 2);
  ASSERT_TRUE(validate(world.scene));
  EXPECT_EQ(without_shades(effects_of(world.scene, camera_at(5))), kOutlined);
  EXPECT_EQ(without_shades(effects_of(world.plain(), camera_at(5))), Effects{});
  for (const int width : {0, 257, 65535}) {
    world.outlines[0].width = static_cast<std::uint16_t>(width);
    EXPECT_EQ(validate(world.scene).error, Error::outline) << width;
  }
  world.outlines[0].width = 256;
  ASSERT_TRUE(validate(world.scene));
  world.outlines[0].hull = 1;
  EXPECT_EQ(validate(world.scene).error, Error::outline) << "no such mesh";
  world.outlines[0].hull = 0;
  ASSERT_TRUE(validate(world.scene));
  world.meshes[0].outline = 2;
  EXPECT_EQ(validate(world.scene).error, Error::mesh) << "no such outline";
  world.meshes[0].outline = 1;
  world.meshes[0].normals = {};
  EXPECT_EQ(validate(world.scene).error, Error::outline) << "a hull without normals";
  world.outlines[0].hull = kOwnMesh;
  const Status own = validate(world.scene);
  EXPECT_EQ(own.error, Error::outline);
  EXPECT_EQ(own.needed, 0U);
  world.meshes[0].normals = world.own.normals;
  for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::mask, AlphaMode::blend}) {
    const Finish finish{.alpha_mode = mode};
    world.materials[0].finish = 0;
    world.scene.finishes = {&finish, 1};
    EXPECT_EQ(validate(world.scene).error, mode == AlphaMode::opaque ? Error::none : Error::outline);
  }
}

TEST(Outlines, TakeTheBytesThatThePlanSays) {
  World world(box(), 3);
  const SceneCounts counts = count(world.scene);
  EXPECT_EQ(counts.instances, 2U);
  EXPECT_EQ(counts.meshlets, 2U);
  EXPECT_EQ(counts.triangles, 24U);
  EXPECT_EQ(count(world.plain()).instances, 1U);
  EXPECT_EQ(plan(counts, kView, kOutlined).plan.effect_bytes, 352U) << "16, two times 52 and 232";
}

TEST(Outlines, MethodsThatKnowNoHullsRefuseThem) {
  EXPECT_EQ(refused_by_methods(kOutlined | method::painter | method::bsp), kOutlined);
  EXPECT_EQ(refused_by_methods(kOutlined | method::painter | method::in_order), kOutlined);
  EXPECT_EQ(refused_by_methods(kOutlined | method::hierarchical_z), Effects{});
}

}  // namespace
}  // namespace effects_test::outline_test
