// Billboards: how they are turned, against the definition in floating point; and that a picture of them is the picture
// of instances which somebody has turned.
#include <cmath>
#include <random>

#include "../oracle/vectors.hpp"
#include "drawn.hpp"
#include "zstrip/effects/billboards/billboard.hpp"
#include "zstrip_scenes/effect_scenes.hpp"
#include "zstrip_scenes/knot.hpp"

namespace effects_test::billboard_test {
namespace {

using namespace oracle;

Point column(const Transform& t, int c) {
  return {std::ldexp(t.m[0][c], -16), std::ldexp(t.m[1][c], -16), std::ldexp(t.m[2][c], -16)};
}

/// As docs/conventions.md defines it.
std::array<Point, 3> turned(const Transform& t, Billboard billboard, const Camera& camera) {
  const Point right = of_axis(camera.right), up = of_axis(camera.up), back = of_axis(camera.back);
  const double x = length(column(t, 0)), y = length(column(t, 1)), z = length(column(t, 2));
  if (billboard == Billboard::viewer || y == 0) return {x * right, y * up, z * back};
  const Point axis = unit(column(t, 1));
  const double along = dot(right, axis);
  Point side = right - along * axis;
  if (std::ranges::all_of(side, [](double c) { return std::abs(c) < 1.0 / 256; })) side = cross(axis, back);
  side = unit(side);
  return {x * side, column(t, 1), z * cross(side, axis)};
}

class Billboards : public testing::Test {
 protected:
  Fixed number(double low, double high) { return to_fixed(std::uniform_real_distribution(low, high)(random_)); }
  Camera camera() {
    Camera camera;
    const auto angle = [this] { return static_cast<Angle>(random_() & 0xFFFF); };
    EXPECT_TRUE(orbit(camera, {number(-1, 1), number(-1, 1), number(-1, 1)}, number(2, 6), angle(), angle()));
    return camera;
  }
  Transform transform(double largest) {
    Transform t{};
    for (auto& row : t.m) {
      for (Fixed& entry : row) entry = number(-largest, largest);
    }
    return t;
  }

  std::mt19937 random_{4711};
};

TEST_F(Billboards, TurnAsTheDefinitionSays) {
  for (int i = 0; i < 3000; ++i) {
    const Camera from = camera();
    const double size = std::pow(2.0, i % 17 - 9);  // 0.002 to 128
    Transform t = transform(size);
    const Billboard billboard = i % 2 == 0 ? Billboard::viewer : Billboard::upright;
    if (i % 10 == 5) t.m[0][1] = t.m[2][1] = 0, t.m[1][1] = std::max<Fixed>(1, to_fixed(size));  // a post that stands
    if (i % 100 == 3) t.m[0][1] = t.m[1][1] = t.m[2][1] = 0;
    const Transform got = detail::turned_to_viewer(t, billboard, from);
    const std::array<Point, 3> expected = turned(t, billboard, from);
    // In 16.16 the y axis' direction is as exact as it is long.
    const double bound = std::ldexp(1, -15) + std::ldexp(size, -19);
    for (int c = 0; c < 3; ++c) {
      for (std::size_t r = 0; r < 3; ++r) {
        ASSERT_NEAR(column(got, c)[r], expected[static_cast<std::size_t>(c)][r], bound) << i << ' ' << r << ' ' << c;
      }
    }
    for (int r = 0; r < 3; ++r) EXPECT_EQ(got.m[r][3], t.m[r][3]) << "stays where it is";
    if (billboard == Billboard::upright && length(column(t, 1)) != 0) {
      for (int r = 0; r < 3; ++r) EXPECT_EQ(got.m[r][1], t.m[r][1]) << "stays upright";
    }
  }
}

TEST_F(Billboards, UprightFromAboveTurnsByTheViewingDirection) {
  // The picture's right lies along the post: nothing of it is left to turn by.
  Camera from;
  from.right = {0, 1 << 30, 0};
  from.up = {0, 0, 1 << 30};
  from.back = {1 << 30, 0, 0};
  const Transform got = detail::turned_to_viewer(Transform::identity(), Billboard::upright, from);
  const Transform expected{{{0, 0, kFixedOne, 0}, {0, kFixedOne, 0, 0}, {-kFixedOne, 0, 0, 0}}};
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) EXPECT_EQ(got.m[r][c], expected.m[r][c]) << r << ' ' << c;
  }
}

TEST_F(Billboards, CamerasWithoutAxesDivideByNothing) {
  Camera none = camera();
  none.right = none.up = none.back = {0, 0, 0};
  ASSERT_TRUE(usable(none));
  const Transform t = transform(2);
  EXPECT_EQ(detail::turned_to_viewer(t, Billboard::upright, none).m[0][0], t.m[0][0]);
  EXPECT_EQ(detail::turned_to_viewer(t, Billboard::viewer, none).m[0][0], 0);
}

/// Two boxes, one of them sunk into the other; the first stands upright, the second faces the viewer.
struct World {
  Mesh meshes[3] = {scenes::kRoomMeshes[1], scenes::kRoomMeshes[1], scenes::kRoomMeshes[1]};
  Material materials[2] = {{.colour = {220, 160, 90, 255}, .smooth = false}, {.colour = {90, 160, 220, 255}}};
  Instance instances[3] = {{.mesh = 0}, {.mesh = 1, .material = 1}, {.mesh = 2}};
  Scene scene;

  World() {
    meshes[0].billboard = Billboard::upright;
    meshes[1].billboard = Billboard::viewer;
    scene.meshes = meshes;
    scene.materials = materials;
    scene.instances = instances;
    scene.lights = scenes::kKeyLight;
  }
  /// The same, turned by hand.
  World turned_for(const Camera& camera) const {
    World by_hand;
    for (std::size_t i = 0; i < 3; ++i) {
      by_hand.instances[i].transform =
          meshes[i].billboard == Billboard::none
              ? instances[i].transform
              : detail::turned_to_viewer(instances[i].transform, meshes[i].billboard, camera);
      by_hand.meshes[i].billboard = Billboard::none;
    }
    return by_hand;
  }
};

TEST_F(Billboards, ArePicturesOfTurnedInstances) {
  constexpr View kView{72, 56, PixelFormat::rgb565};
  constexpr Effects kPlain = effect::lighting | effect::gouraud;
  std::ptrdiff_t shown = 0;
  for (int i = 0; i < 12; ++i) {
    const Camera from = camera();
    World world;
    for (Instance& instance : world.instances) instance.transform = transform(0.5);
    const World by_hand = world.turned_for(from);
    ASSERT_EQ(without_shades(effects_of(world.scene, from)), kPlain | effect::billboards);
    ASSERT_EQ(without_shades(effects_of(by_hand.scene, from)), kPlain);
    const Drawn expected = draw<kPlain>(by_hand.scene, from, kView);
    shown += std::ranges::count_if(expected.pixels, [](std::uint16_t pixel) { return pixel != 0; });
    EXPECT_EQ(draw<kPlain | effect::billboards>(world.scene, from, kView), expected) << i;
    EXPECT_EQ(draw<kPlain | effect::billboards>(world.scene, from, kView, {.strip_rows = 5, .strip_columns = 16}),
              expected);
    const Effects binned = kPlain | effect::billboards | effect::bins;
    EXPECT_EQ(draw_any(binned, world.scene, from, kView, {.strip_rows = 7, .modes = Modes::binned}), expected);
  }
  EXPECT_GT(shown, 2000);
}

TEST_F(Billboards, ShowTheSameSideFromEverywhere) {
  Mesh knot = scenes::knot.scene.meshes[0];
  knot.billboard = Billboard::viewer;
  Scene scene = scenes::knot.scene;
  scene.meshes = {&knot, 1};
  scene.lights = {};
  constexpr View kView{64, 48, PixelFormat::rgb565};
  constexpr Effects kEffects =
      effect::billboards | effect::orthographic | effects_of(scenes::knot.scene, scenes::knot.camera);
  Drawn first;
  for (int i = 0; i < 6; ++i) {
    Camera from;
    ASSERT_TRUE(orbit(from, {0, 0, 0}, fixed(4), 7000 * i, 3000 + 4000 * i));
    from.projection = Projection::orthographic;
    from.focal = fixed(0.9);
    const Drawn drawn = draw_any(kEffects, scene, from, kView);
    if (i == 0) first = drawn;
    std::ptrdiff_t different = 0;  // at edges: the axes are rounded
    for (std::size_t p = 0; p < drawn.pixels.size(); ++p) different += drawn.pixels[p] != first.pixels[p] ? 1 : 0;
    EXPECT_LE(different, 20) << i;
  }
  const auto background = first.pixels[0];
  EXPECT_GT(std::ranges::count_if(first.pixels, [&](std::uint16_t pixel) { return pixel != background; }), 400);
}

TEST_F(Billboards, LongAxesAndUnknownFacingsAreRefused) {
  World world;
  ASSERT_TRUE(validate(world.scene));
  world.instances[1].transform.m[0][0] = world.instances[1].transform.m[1][0] = 200 * kFixedOne;
  world.instances[2].transform = world.instances[1].transform;  // not a billboard: only its entries have a limit
  const Status status = validate(world.scene);
  EXPECT_EQ(status.error, Error::instance);
  EXPECT_EQ(status.needed, 1U);
  constexpr View kView{32, 24, PixelFormat::rgb565};
  constexpr Effects kEffects = effect::lighting | effect::gouraud | effect::billboards;
  const Plan plan = zstrip::plan(count(world.scene), kView, kEffects).plan;
  Renderer<kEffects> renderer;
  const Status refused = begun(renderer, world.scene, camera(), kView, plan);
  EXPECT_EQ(refused.error, Error::instance);
  EXPECT_EQ(refused.needed, 1U);
  std::vector<std::uint16_t> pixels(32 * 24);
  EXPECT_EQ(renderer.draw_strip(0, std::as_writable_bytes(std::span(pixels))).error, Error::not_begun);

  world.meshes[1].billboard = static_cast<Billboard>(3);
  EXPECT_EQ(validate(world.scene).error, Error::mesh);
}

TEST_F(Billboards, TakeTheBytesThatThePlanSays) {
  World world;
  constexpr View kView{32, 24, PixelFormat::rgb565};
  constexpr Effects kEffects = effect::lighting | effect::gouraud | effect::billboards;
  EXPECT_EQ(plan(count(world.scene), kView, kEffects).plan.effect_bytes, 176U) << "16 and 3 times 52, in words of 8";
}

}  // namespace
}  // namespace effects_test::billboard_test
