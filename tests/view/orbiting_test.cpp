// Cameras that are moved by hand, against spherical coordinates.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "view/orbiting.hpp"

namespace zstrip::sim::test {
namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

double from_fixed(Fixed value) { return static_cast<double>(value) / kFixedOne; }

/// Looks at the origin from `elevation` degrees above the horizon, from the front.
Camera camera_at(double distance, double elevation) {
  Camera camera;
  const auto fixed = [](double value) { return static_cast<Fixed>(std::lround(value * kFixedOne)); };
  const Vec3 eye{0, fixed(distance * std::sin(radians(elevation))), fixed(distance * std::cos(radians(elevation)))};
  EXPECT_TRUE(look_at(camera, eye, {0, 0, 0}, {0, kFixedOne, 0}));
  camera.near_plane = fixed(0.1);
  camera.far_plane = fixed(4 * distance);
  return camera;
}

TEST(ViewOrbiting, UnmovedItIsTheCameraItself) {
  const Camera camera = camera_at(7, 20);
  const Camera same = orbited(camera, {});
  EXPECT_EQ(same.eye, camera.eye);
  EXPECT_EQ(same.right, camera.right);
  EXPECT_EQ(same.far_plane, camera.far_plane);
}

TEST(ViewOrbiting, TheEyeIsOnASphereAroundTheSceneAndLooksAtItsCentre) {
  for (const double distance : {0.5, 7.0, 900.0}) {
    for (const double yaw : {-170.0, -90.0, -5.0, 0.0, 40.0, 180.0}) {
      for (const double pitch : {-150.0, -60.0, -1.0, 0.0, 30.0, 100.0}) {
        for (const double zoom : {0.05, 1.0, 20.0}) {
          const Camera camera = orbited(camera_at(distance, 20), {yaw, pitch, zoom});
          const double elevation = radians(std::clamp(20 + pitch, -89.0, 89.0));
          const double radius = distance * zoom, tolerance = 1e-4 * radius + 3e-5;
          EXPECT_NEAR(from_fixed(camera.eye.x), radius * std::cos(elevation) * std::sin(radians(-yaw)), tolerance);
          EXPECT_NEAR(from_fixed(camera.eye.y), radius * std::sin(elevation), tolerance);
          EXPECT_NEAR(from_fixed(camera.eye.z), radius * std::cos(elevation) * std::cos(radians(yaw)), tolerance);
          EXPECT_TRUE(usable(camera));
          const double to_centre = from_fixed(camera.eye.x) * camera.back.x + from_fixed(camera.eye.y) * camera.back.y +
                                   from_fixed(camera.eye.z) * camera.back.z;
          EXPECT_NEAR(to_centre / (1 << 30), radius, tolerance) << "back points from the centre to the eye";
          EXPECT_NEAR(camera.right.y, 0, 4) << "the horizon stays level";
          EXPECT_GT(from_fixed(camera.far_plane), radius + distance) << "what was seen is not cut off";
        }
      }
    }
  }
}

/// A drag back did nothing until it had undone all of the drag.
TEST(ViewOrbiting, WhatIsBeyondTheLimitsIsNotKept) {
  const Camera camera = camera_at(7, 20);
  EXPECT_NEAR(within_limits(camera, {.pitch = 400}).pitch, 69, 0.01);
  EXPECT_NEAR(within_limits(camera, {.pitch = -400}).pitch, -109, 0.01);
  EXPECT_EQ(within_limits(camera, {.yaw = 3, .pitch = 5, .distance = 2}).pitch, 5);
}

TEST(ViewOrbiting, AScenesLimitsHoldAndItsTargetIsTheCentre) {
  const Camera camera = camera_at(7, 20);
  const OrbitLimits limits{.yaw = {-30, 0}, .pitch = {-5, 10}, .distance = {0.5, 1}, .target = 3};
  const Orbiting by = within_limits(camera, {.yaw = -90, .pitch = 80, .distance = 4}, limits);
  EXPECT_EQ(by.yaw, -30);
  EXPECT_EQ(by.pitch, 10);
  EXPECT_EQ(by.distance, 1);
  const Camera moved = orbited(camera, {.yaw = 90, .pitch = 10, .distance = 0.5}, limits), same = orbited(camera, {});
  const auto target = [](const Camera& from, double distance) {
    const auto at = [&](Fixed eye, std::int32_t back) { return from_fixed(eye) - distance * back / (1 << 30); };
    return std::array{at(from.eye.x, from.back.x), at(from.eye.y, from.back.y), at(from.eye.z, from.back.z)};
  };
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(target(moved, 1.5)[i], target(same, 3)[i], 1e-3) << i;
  EXPECT_EQ(moved.eye.x, 0) << "no yaw to that side";
}

/// Each coordinate was cut off alone, which turned the view.
TEST(ViewOrbiting, TheEyeOfALargeSceneStaysInRange) {
  const Camera near = camera_at(20000, 20), far = orbited(near, {.distance = 20});
  EXPECT_NEAR(static_cast<double>(far.eye.y) / far.eye.z, std::tan(radians(20)), 1e-4);
  EXPECT_GT(far.eye.z, near.eye.z);
}

TEST(ViewOrbiting, AnOrthographicCameraShowsMoreFromFarther) {
  Camera camera = camera_at(7, 20);
  camera.projection = Projection::orthographic;
  EXPECT_NEAR(orbited(camera, {.distance = 2}).focal, camera.focal / 2, 1);
  EXPECT_NEAR(orbited(camera, {.distance = 0.5}).focal, 2 * camera.focal, 1);
}

TEST(ViewOrbiting, ACameraAtTheOriginTurnsAboutAPointBeforeIt) {
  Camera camera;
  camera.eye = {0, 0, 0};
  const Camera turned = orbited(camera, {.yaw = 90});
  EXPECT_TRUE(usable(turned));
  EXPECT_LT(turned.eye.x, -kFixedOne / 2);
  EXPECT_NEAR(turned.back.x, -(1 << 30), 4);
}

}  // namespace
}  // namespace zstrip::sim::test
