// Motion: the turntable turns once, models fill the picture and stay inside it, the workload turns as the formula says.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "geometry.hpp"
#include "zstrip_scenes/scenes.hpp"

namespace zstrip::scenes_test {
namespace {

using scenes::BuiltIn;
using scenes::Staged;

/// How far a frame's vertices reach from the middle of the picture; 1 is its border.
struct Reach {
  double across = 0, up = 0;
  double nearest = 1e9;
};
void extend(Reach& reach, const Staged& staged, double aspect) {
  const Camera& camera = staged.camera;
  constexpr double kUnit = 1 << 30;
  for (const Instance& instance : staged.scene.instances) {
    const Mesh& mesh = staged.scene.meshes[instance.mesh];
    for (const Position& position : mesh.positions) {
      const Point p = apply(instance.transform, object_position(mesh, position)) - to_point(camera.eye);
      const double w = -dot(p, to_point(camera.back, kUnit)), focal = camera.focal / 65536.0;
      reach.across = std::max(reach.across, std::abs(dot(p, to_point(camera.right, kUnit)) * focal / w / aspect));
      reach.up = std::max(reach.up, std::abs(dot(p, to_point(camera.up, kUnit)) * focal / w));
      reach.nearest = std::min(reach.nearest, w);
    }
  }
}

class Turntable : public testing::TestWithParam<View> {};

TEST_P(Turntable, ModelsFillThePictureAndStayInside) {
  const View view = GetParam();
  for (const BuiltIn& scene : scenes::built_in()) {
    if (scene.turns == scenes::Turns::camera) continue;
    Reach reach;
    for (std::uint32_t frame = 0; frame < 24; ++frame) {
      Staged staged;
      stage(scene, staged, frame, 24, view);
      extend(reach, staged, double(view.width) / view.height);
    }
    EXPECT_GT(reach.nearest, 0.5) << scene.name;
    EXPECT_LE(std::max(reach.across, reach.up), 1.0) << scene.name << " leaves the picture";
    EXPECT_GE(std::max(reach.across, reach.up), 0.9) << scene.name << " could be larger";
  }
}

INSTANTIATE_TEST_SUITE_P(Views, Turntable,
                         testing::Values(View{.width = 320, .height = 240}, View{.width = 128, .height = 64},
                                         View{.width = 240, .height = 320}, View{.width = 240, .height = 240},
                                         View{.width = 4096, .height = 1}, View{.width = 1, .height = 4096}),
                         [](const auto& parameter) {
                           return std::to_string(parameter.param.width) + "x" + std::to_string(parameter.param.height);
                         });

TEST(Stage, TheRoomsCameraStaysInTheRoom) {
  const BuiltIn* room = scenes::find("room");
  ASSERT_NE(room, nullptr);
  for (std::uint32_t frame = 0; frame < 36; ++frame) {
    Staged staged;
    stage(*room, staged, frame, 36);
    const Point eye = to_point(staged.camera.eye);
    EXPECT_LT(std::abs(eye.x), 1.85);
    EXPECT_LT(std::abs(eye.y), 1.1);
    EXPECT_LT(std::abs(eye.z), 1.85);
    const double angle = 2 * M_PI * frame / 36;
    EXPECT_NEAR(std::atan2(eye.x, eye.z), std::remainder(angle, 2 * M_PI), 1e-3);
    // The axes stay orthonormal and look at the y axis.
    const Point right = to_point(staged.camera.right, 1 << 30), up = to_point(staged.camera.up, 1 << 30),
                back = to_point(staged.camera.back, 1 << 30);
    EXPECT_NEAR(length(right), 1, 1e-4);
    EXPECT_NEAR(length(cross(right, up) - back), 0, 1e-4);
    EXPECT_NEAR(length(length(eye) * back - eye), 0, 1e-3);
  }
}

TEST(Stage, OneTurnInSoManyFrames) {
  for (const BuiltIn& scene : scenes::built_in()) {
    if (scene.turns == scenes::Turns::camera) continue;
    for (const std::uint32_t frames : {1U, 7U, 60U, 65537U}) {
      for (const std::uint32_t frame : {0U, frames / 3, frames - 1, frames, 4294967295U}) {
        Staged staged;
        stage(scene, staged, frame, frames);
        const double angle = 2 * M_PI * (frame % frames) / frames;
        const Point moved = apply(staged.scene.instances[0].transform, {0.25, 0.5, 1});
        const Point expected{0.25 * std::cos(angle) + std::sin(angle), 0.5, -0.25 * std::sin(angle) + std::cos(angle)};
        EXPECT_LT(length(moved - expected), 2e-4) << scene.name << " frame " << frame << " of " << frames;
      }
    }
  }
}

TEST(Stage, ZeroFramesStandStill) {
  Staged still, turning;
  stage(*scenes::find("teapot"), still, 5, 0);
  stage(*scenes::find("teapot"), turning, 0, 1);
  EXPECT_EQ(0,
            std::memcmp(&still.scene.instances[0].transform, &turning.scene.instances[0].transform, sizeof(Transform)));
}

TEST(Stage, FrameZeroIsTheSceneAtRest) {
  for (const BuiltIn& scene : scenes::built_in()) {
    Staged staged;
    stage(scene, staged, 0, 60);
    ASSERT_EQ(staged.scene.instances.size(), scene.scene.instances.size());
    EXPECT_NE(staged.scene.instances.data(), scene.scene.instances.data());
    EXPECT_EQ(staged.scene.meshes.data(), scene.scene.meshes.data());
    EXPECT_EQ(staged.scene.lights.size(), scene.scene.lights.size());
    for (std::size_t i = 0; i < staged.scene.instances.size(); ++i) {
      EXPECT_EQ(staged.scene.instances[i].mesh, scene.scene.instances[i].mesh);
      EXPECT_EQ(staged.scene.instances[i].material, scene.scene.instances[i].material);
      EXPECT_EQ(
          0, std::memcmp(&staged.scene.instances[i].transform, &scene.scene.instances[i].transform, sizeof(Transform)));
    }
    EXPECT_EQ(staged.camera.eye, scene.camera.eye);
    EXPECT_EQ(staged.camera.back, scene.camera.back);
  }
}

TEST(Stage, TheLightComesFromTheUpperLeftOfTheCamera) {
  for (const char* name : {"teapot", "teapot_meshlets", "knot_lit", "knot_textured"}) {
    const BuiltIn* scene = scenes::find(name);
    ASSERT_NE(scene, nullptr);
    ASSERT_EQ(scene->scene.lights.size(), 1U);
    const DirectionalLight& light = scene->scene.lights[0];
    const Point towards{light.x / 32767.0, light.y / 32767.0, light.z / 32767.0};
    EXPECT_NEAR(length(towards), 1, 1e-4);
    EXPECT_LT(dot(towards, to_point(scene->camera.right, 1 << 30)), -0.3);
    EXPECT_GT(dot(towards, to_point(scene->camera.up, 1 << 30)), 0.3);
    EXPECT_GT(dot(towards, to_point(scene->camera.back, 1 << 30)), 0.3);
  }
}

TEST(Stage, TurntableCamerasStandTwentyDegreesAbove) {
  for (const BuiltIn& scene : scenes::built_in()) {
    const Point back = to_point(scene.camera.back, 1 << 30), up = to_point(scene.camera.up, 1 << 30);
    const double degrees = scene.turns == scenes::Turns::camera ? 15 : 20;
    EXPECT_NEAR(std::atan2(back.y, back.z) * 180 / M_PI, degrees, 1e-3) << scene.name;
    EXPECT_NEAR(length(back), 1, 1e-6);
    EXPECT_NEAR(length(up), 1, 1e-6);
    EXPECT_NEAR(dot(up, back), 0, 1e-6);
  }
}

TEST(StageWorkload, TurnsByATenthRadianAFrameAndHalfAsMuchAboutX) {
  const BuiltIn* knot = scenes::find("knot");
  ASSERT_NE(knot, nullptr);
  for (const std::uint32_t frame : {0U, 1U, 2U, 17U, 59U, 60U, 63U, 126U, 1000U, 100000U}) {
    Staged staged;
    stage_workload(*knot, staged, frame);
    const double a = 0.1 * frame, b = a / 2;
    const Point p{0.3, -0.4, 0.9};
    const Point turned{p.x * std::cos(a) + p.z * std::sin(a), p.y, p.z * std::cos(a) - p.x * std::sin(a)};
    const Point expected{turned.x, turned.y * std::cos(b) - turned.z * std::sin(b),
                         turned.y * std::sin(b) + turned.z * std::cos(b)};
    // Angles are cut to 1/65536 turn, 1e-4 radians.
    EXPECT_LT(length(apply(staged.scene.instances[0].transform, p) - expected), 3e-4) << frame;
  }
}

TEST(StageWorkload, TheCameraIsTheCommonOne) {
  for (const BuiltIn& scene : scenes::built_in()) {
    Staged staged;
    stage_workload(scene, staged, 3);
    const bool is_cube = std::string_view(scene.name) == "cube";
    EXPECT_NEAR(staged.camera.eye.z / 65536.0, is_cube ? 2.2 : 3.0, 1e-5) << scene.name;
    EXPECT_EQ(staged.camera.eye.x, 0);
    EXPECT_EQ(staged.camera.eye.y, 0);
    EXPECT_NEAR(staged.camera.focal / 65536.0, 1 / std::tan(M_PI / 6), 1e-5);
    EXPECT_NEAR(staged.camera.near_plane / 65536.0, 0.1, 1e-5);
    EXPECT_EQ(staged.camera.far_plane, 100 * kFixedOne);
    EXPECT_EQ(staged.camera.back, (Vec3{0, 0, 1 << 30}));
  }
}

// Frame numbers run for weeks on a device: no jump, wherever the angle's bits wrap.
TEST(StageWorkload, NeverJumps) {
  const BuiltIn* knot = scenes::find("knot");
  ASSERT_NE(knot, nullptr);
  for (const std::uint32_t start : {0U, 62U, 125U, 65535U, 4000000000U, 4294967290U}) {
    Staged before, after;
    stage_workload(*knot, before, start);
    stage_workload(*knot, after, start + 1);
    const Point p{0.3, -0.4, 0.9};
    const double moved =
        length(apply(before.scene.instances[0].transform, p) - apply(after.scene.instances[0].transform, p));
    EXPECT_LT(moved, 0.16) << start;
    EXPECT_GT(moved, 0.01) << start;
  }
}

}  // namespace
}  // namespace zstrip::scenes_test
