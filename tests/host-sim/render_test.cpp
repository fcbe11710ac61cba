// Cameras: framed so that nothing leaves the picture at any angle, and placed where the options say.
#include <cmath>
#include <numbers>

#include "import/quantise.hpp"
#include "motion/turned_billboard.hpp"
#include "render/camera.hpp"
#include "render/framing.hpp"
#include "render/stage.hpp"
#include "support.hpp"

namespace zstrip::sim::test {
namespace {

struct Projected {
  double x, y;  // -1..1 in the picture
};

Projected project(const Camera& camera, double aspect, double x, double y, double z) {
  constexpr double kUnit = 1 << 30;
  const auto along = [&](const Vec3& axis) {
    return (axis.x * (x - from_fixed(camera.eye.x)) + axis.y * (y - from_fixed(camera.eye.y)) +
            axis.z * (z - from_fixed(camera.eye.z))) /
           kUnit;
  };
  const double focal = from_fixed(camera.focal);
  const double w = camera.projection == Projection::orthographic ? 1 : -along(camera.back);
  return {along(camera.right) * focal / w / aspect, along(camera.up) * focal / w};
}

class Framed : public FolderTest, public ::testing::WithParamInterface<std::tuple<bool, double, bool>> {
 protected:
  static FramingView framing_view() {
    const auto [orthographic, aspect, whole_turn] = GetParam();
    return {.aspect = aspect,
            .half_tangent = std::tan(kDefaultFieldOfView * std::numbers::pi / 360),
            .orthographic = orthographic,
            .whole_turn = whole_turn};
  }
};

TEST_P(Framed, FillsThePictureAndStaysInside) {
  const auto [orthographic, aspect, whole_turn] = GetParam();
  // Deliberately off centre and longer than high.
  const Position positions[] = {{-32000, -9000, -5000}, {31000, -9000, 2000}, {20000, 12000, -9000}, {0, 0, 9000}};
  Mesh mesh;
  mesh.positions = positions;
  const Instance instance{};
  Scene scene;
  scene.meshes = {&mesh, 1};
  scene.instances = {&instance, 1};
  CameraOptions options;
  options.orthographic = orthographic;
  const FramingView view = framing_view();
  const auto camera = framed_camera(options, frame_scene(scene, view), radius_about_origin(scene));
  ASSERT_TRUE(camera);

  double widest = 0;
  double highest = 0;
  constexpr int kAngles = 720;
  for (int step = 0; step < (whole_turn ? kAngles : 1); ++step) {
    const double angle = 2 * std::numbers::pi * step / kAngles;
    for (const Position& p : positions) {
      const double x = p.x / 32768.0;
      const double z = p.z / 32768.0;
      const Projected at = project(*camera, aspect, x * std::cos(angle) + z * std::sin(angle), p.y / 32768.0,
                                   z * std::cos(angle) - x * std::sin(angle));
      widest = std::max(widest, std::abs(at.x));
      highest = std::max(highest, std::abs(at.y));
    }
  }
  EXPECT_LE(widest, 0.951);
  EXPECT_LE(highest, 0.951);
  EXPECT_GE(std::max(widest, highest), 0.94);
}

TEST_P(Framed, BillboardsStayInsideHoweverTheyAreTurned) {
  const auto [orthographic, aspect, whole_turn] = GetParam();
  const Position positions[] = {{-32000, -32000, 0}, {32000, -32000, 0}, {0, 32000, 9000}};
  Mesh mesh;
  mesh.positions = positions;
  Scene scene;
  scene.meshes = {&mesh, 1};
  for (const Billboard billboard : {Billboard::viewer, Billboard::upright}) {
    mesh.billboard = billboard;
    Instance instance{.transform = Transform::identity()};
    instance.transform.m[0][3] = kFixedOne / 4;
    scene.instances = {&instance, 1};
    CameraOptions options;
    options.orthographic = orthographic;
    const FramingView view = framing_view();
    EXPECT_GE(radius_about_origin(scene), std::hypot(32000, 32000) / 32768 + 0.25);
    const auto camera = framed_camera(options, frame_scene(scene, view), radius_about_origin(scene));
    ASSERT_TRUE(camera);
    for (int step = 0; step < (whole_turn ? 72 : 1); ++step) {
      const double angle = 2 * std::numbers::pi * step / 72;
      instance.transform.m[0][3] = to_fixed(0.25 * std::cos(angle));
      instance.transform.m[2][3] = to_fixed(-0.25 * std::sin(angle));
      const Transform turned = standing(scene, instance, *camera);
      for (const Position& p : positions) {
        const auto row = [&](int r) {
          return (turned.m[r][0] * (p.x / 32768.0) + turned.m[r][1] * (p.y / 32768.0) +
                  turned.m[r][2] * (p.z / 32768.0) + turned.m[r][3]) /
                 kFixedOne;
        };
        const Projected at = project(*camera, aspect, row(0), row(1), row(2));
        EXPECT_LE(std::max(std::abs(at.x), std::abs(at.y)), 0.951) << step;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Views, Framed,
                         ::testing::Combine(::testing::Bool(), ::testing::Values(0.25, 4.0 / 3, 8.0),
                                            ::testing::Bool()));

TEST(PlaceCamera, EyeInTheModelsUnits) {
  CameraOptions options;
  options.eye = {{10, 0, 50}};
  options.look_at = {{10, 0, 0}};
  const auto camera = place_camera(options, {.origin = {10, 0, 0}, .scale = 0.1}, 1);
  ASSERT_TRUE(camera);
  EXPECT_EQ(camera->eye, (Vec3{0, 0, 5 * kFixedOne}));
  EXPECT_EQ(camera->back, (Vec3{0, 0, 1 << 30}));
  EXPECT_LT(camera->near_plane, 4 * kFixedOne);
  EXPECT_GT(camera->far_plane, 6 * kFixedOne);
}

TEST(PlaceCamera, OrbitMeetsLookAt) {
  CameraOptions by_orbit;
  by_orbit.orbit = Orbit{4, 90, 90};
  CameraOptions by_eye;
  by_eye.eye = {{4, 0, 0}};
  const auto a = place_camera(by_orbit, {}, 1);
  const auto b = place_camera(by_eye, {}, 1);
  ASSERT_TRUE(a);
  ASSERT_TRUE(b);
  EXPECT_EQ(a->eye, b->eye);
  EXPECT_EQ(a->back, b->back);
}

TEST(PlaceCamera, OrthographicShowsTheSameAtTheTarget) {
  CameraOptions options;
  options.eye = {{0, 0, 4}};
  const auto perspective = place_camera(options, {}, 1);
  options.orthographic = true;
  const auto parallel = place_camera(options, {}, 1);
  ASSERT_TRUE(perspective);
  ASSERT_TRUE(parallel);
  EXPECT_NEAR(project(*perspective, 1, 0.5, 0.25, 0).x, project(*parallel, 1, 0.5, 0.25, 0).x, 1e-4);
  EXPECT_NEAR(project(*perspective, 1, 0.5, 0.25, 0).y, project(*parallel, 1, 0.5, 0.25, 0).y, 1e-4);
}

TEST(PlaceCamera, RefusesWhatItCannotShow) {
  CameraOptions options;
  options.eye = {{0, 0, 0}};
  EXPECT_FALSE(place_camera(options, {}, 1));
  options.eye = {{0, 0, 1e9}};
  EXPECT_FALSE(place_camera(options, {}, 1));
  options.eye.reset();
  options.orbit = Orbit{1e-9, 0, 0};
  EXPECT_FALSE(place_camera(options, {}, 1));
}

}  // namespace
}  // namespace zstrip::sim::test
