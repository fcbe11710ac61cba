// Hard cases H: cameras. The renderer has no quadrics, so that cases 64 and 65 have nothing to test.
#include <gtest/gtest.h>

#include <cmath>

#include "space.hpp"

namespace hard_cases {
namespace {

TEST(HardCases, H66_SphericalCameraAtThePolesAndThroughTheWholeTurn) {
  // Through the poles and past 360 degrees the picture changes a little with every step, never by a flip.
  Model model = picture::random_model(3, 80, 16000);
  model.texels.clear();
  const auto picture_at = [&](Angle phi, Angle theta) {
    Camera camera;
    EXPECT_TRUE(orbit(camera, {0, 0, 0}, 4 * kFixedOne, phi, theta));
    Scene scene = model.scene();
    scene.background = {0, 0, 0, 255};
    const Picture picture = picture::render(scene, camera, kView, kView.height);
    EXPECT_TRUE(picture.status);
    return mask_of(picture);
  };
  const auto difference = [](const std::vector<bool>& a, const std::vector<bool>& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i];
    return count;
  };
  const int covered = static_cast<int>(std::ranges::count(picture_at(0, kFullTurn / 4), true));
  ASSERT_GT(covered, 500);
  ASSERT_LT(covered, kPixels * 3 / 4);
  constexpr Angle kStep = 60;  // a third of a degree
  for (const Angle pole : {Angle{0}, Angle{kFullTurn / 2}}) {
    for (Angle phi = 0; phi < kFullTurn; phi += kFullTurn / 8) {
      auto before = picture_at(phi, pole - 3 * kStep);
      for (int i = -2; i <= 3; ++i) {
        const auto now = picture_at(phi, pole + i * kStep);
        const int changed = difference(before, now);
        ASSERT_GT(changed, 0) << "pole " << pole << " phi " << phi << " step " << i;
        ASSERT_LT(changed, covered / 16) << "pole " << pole << " phi " << phi << " step " << i;
        before = now;
      }
    }
  }
  auto before = picture_at(-3 * kStep, 12000);
  for (int i = -2; i <= 3; ++i) {
    const auto now = picture_at(i * kStep, 12000);
    const int changed = difference(before, now);
    ASSERT_GT(changed, 0) << i;
    ASSERT_LT(changed, covered / 16) << i;
    before = now;
  }
}

TEST(HardCases, H66_SphericalCoordinatesAreTheDocumentedOnes) {
  for (Angle phi = -70000; phi <= 70000; phi += 1777) {
    for (Angle theta = 0; theta <= kFullTurn / 2; theta += 1024) {
      Camera camera;
      ASSERT_TRUE(orbit(camera, {1000, 2000, -3000}, 5 * kFixedOne, phi, theta));
      const double p = phi * 2 * M_PI / 65536, t = theta * 2 * M_PI / 65536;
      ASSERT_NEAR(camera.eye.x, 1000 + 5 * 65536 * std::sin(t) * std::sin(p), 2);
      ASSERT_NEAR(camera.eye.y, 2000 + 5 * 65536 * std::cos(t), 2);
      ASSERT_NEAR(camera.eye.z, -3000 + 5 * 65536 * std::sin(t) * std::cos(p), 2);
    }
  }
}

}  // namespace
}  // namespace hard_cases
