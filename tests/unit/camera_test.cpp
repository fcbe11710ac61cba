// Camera placement, at ordinary places and at the poles.
#include <gtest/gtest.h>

#include <cmath>

#include "zstrip/camera.hpp"

namespace {

using namespace zstrip;

constexpr double kUnit = 1073741824.0;  // 2.30

double dot(const Vec3& a, const Vec3& b) {
  return (a.x / kUnit) * (b.x / kUnit) + (a.y / kUnit) * (b.y / kUnit) + (a.z / kUnit) * (b.z / kUnit);
}

void expect_right_handed_frame(const Camera& camera) {
  EXPECT_NEAR(dot(camera.right, camera.right), 1, 3e-8);
  EXPECT_NEAR(dot(camera.up, camera.up), 1, 3e-8);
  EXPECT_NEAR(dot(camera.back, camera.back), 1, 3e-8);
  EXPECT_NEAR(dot(camera.right, camera.up), 0, 3e-8);
  EXPECT_NEAR(dot(camera.right, camera.back), 0, 3e-8);
  const double x = (camera.right.y / kUnit) * (camera.up.z / kUnit) - (camera.right.z / kUnit) * (camera.up.y / kUnit);
  EXPECT_NEAR(x, camera.back.x / kUnit, 3e-8);  // right x up = back
}

TEST(Camera, OrbitAtDefaultAnglesIsTheDefaultCamera) {
  Camera camera;
  ASSERT_TRUE(orbit(camera, {0, 0, 0}, 3 * kFixedOne, 0, kFullTurn / 4));
  const Camera standard;
  EXPECT_EQ(camera.right, standard.right);
  EXPECT_EQ(camera.up, standard.up);
  EXPECT_EQ(camera.back, standard.back);
  EXPECT_EQ(camera.eye, standard.eye);
}

TEST(Camera, OrbitIsOrthonormalEverywhere) {
  Camera camera;
  for (Angle phi = 0; phi < kFullTurn; phi += 1117) {
    for (Angle theta = 0; theta <= kFullTurn / 2; theta += 512) {
      ASSERT_TRUE(orbit(camera, {1000, -2000, 3000}, 5 * kFixedOne, phi, theta));
      expect_right_handed_frame(camera);
    }
  }
}

TEST(Camera, OrbitAgreesWithLookAtAwayFromThePoles) {
  Camera a;
  Camera b;
  for (Angle phi = 0; phi < kFullTurn; phi += 3001) {
    for (Angle theta = 3000; theta < kFullTurn / 2 - 3000; theta += 2111) {
      ASSERT_TRUE(orbit(a, {0, 0, 0}, 5 * kFixedOne, phi, theta));
      ASSERT_TRUE(look_at(b, a.eye, {0, 0, 0}, {0, kFixedOne, 0}));
      EXPECT_NEAR(dot(a.right, b.right), 1, 1e-7);
      EXPECT_NEAR(dot(a.up, b.up), 1, 1e-7);
    }
  }
}

TEST(Camera, OrbitAtThePolesTakesUprightFromPhiAndDoesNotFlip) {
  Camera before;
  Camera pole;
  for (const Angle theta : {0, kFullTurn / 2}) {
    ASSERT_TRUE(orbit(pole, {0, 0, 0}, kFixedOne, 5000, theta));
    ASSERT_TRUE(orbit(before, {0, 0, 0}, kFixedOne, 5000, theta == 0 ? 1 : theta - 1));
    EXPECT_GT(dot(pole.right, before.right), 0.999999);
    EXPECT_GT(dot(pole.up, before.up), 0.999999);
  }
  Camera full;
  ASSERT_TRUE(orbit(pole, {0, 0, 0}, kFixedOne, 0, 9000));
  ASSERT_TRUE(orbit(full, {0, 0, 0}, kFixedOne, kFullTurn, 9000));
  EXPECT_EQ(pole.eye, full.eye);
  EXPECT_EQ(pole.up, full.up);
}

TEST(Camera, LookAtStraightUpAndDownStaysOrthonormal) {
  Camera camera;
  for (const Fixed y : {-kFixedOne, kFixedOne}) {
    ASSERT_TRUE(look_at(camera, {0, y, 0}, {0, 0, 0}, {0, kFixedOne, 0}));
    expect_right_handed_frame(camera);
  }
  ASSERT_TRUE(look_at(camera, {0, 0, kFixedOne}, {0, 0, 0}, {0, 0, 0}));
  expect_right_handed_frame(camera);
}

TEST(Camera, RefusesWhatHasNoDirection) {
  Camera camera;
  EXPECT_EQ(look_at(camera, {1, 2, 3}, {1, 2, 3}, {0, 1, 0}).error, Error::camera);
  EXPECT_EQ(orbit(camera, {0, 0, 0}, 0, 0, 0).error, Error::camera);
  EXPECT_EQ(orbit(camera, {INT32_MAX, 0, 0}, INT32_MAX, kFullTurn / 4, kFullTurn / 4).error, Error::camera);
  EXPECT_EQ(set_field_of_view(camera, 0).error, Error::camera);
  EXPECT_EQ(set_field_of_view(camera, kFullTurn / 2).error, Error::camera);
}

TEST(Camera, FieldOfView) {
  Camera camera;
  for (Angle angle = 100; angle < kFullTurn / 2 - 100; angle += 37) {
    ASSERT_TRUE(set_field_of_view(camera, angle));
    const double exact = 65536.0 / std::tan(angle * M_PI / kFullTurn);
    EXPECT_NEAR(camera.focal, exact, 1 + exact * 1e-6);
  }
}

}  // namespace
