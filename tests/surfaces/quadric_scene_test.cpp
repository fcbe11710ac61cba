// The built-in scene of spheres, however it is cut and by whichever pipeline; and what fog does to a sphere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn.hpp"
#include "ray_oracle.hpp"
#include "zstrip/base/crc32.hpp"
#include "zstrip_scenes/spheres.hpp"

namespace {

using namespace zstrip;
using effects_test::draw;
using effects_test::draw_any;
using effects_test::Drawn;
using ray_oracle::Real;

constexpr Effects kSpheres = effects_of(scenes::spheres.scene, scenes::spheres.camera);
constexpr View kView{160, 120};

Camera orthographic() {
  Camera camera = scenes::spheres.camera;
  camera.projection = Projection::orthographic;
  camera.focal = fixed(0.45);
  return camera;
}

std::uint32_t checksum(const Drawn& drawn) { return crc32(std::as_bytes(std::span(drawn.pixels))); }

TEST(Spheres, HaveTheirChecksums) {
  EXPECT_EQ(checksum(draw<kSpheres>(scenes::spheres.scene, scenes::spheres.camera, kView)), 0x88B409A7U);
  EXPECT_EQ(checksum(draw<kSpheres | effect::orthographic>(scenes::spheres.scene, orthographic(), kView)), 0xDE1F9770U);
}

TEST(Spheres, StripsTilesBinsAndSupersetsDrawTheSame) {
  const Scene& scene = scenes::spheres.scene;
  for (const Camera& camera : {scenes::spheres.camera, orthographic()}) {
    const Effects effects = effects_of(scene, camera);
    const Drawn whole = draw_any(effects, scene, camera, kView);
    const Drawn exact = camera.projection == Projection::perspective
                            ? draw<kSpheres>(scene, camera, kView)
                            : draw<kSpheres | effect::orthographic>(scene, camera, kView);
    EXPECT_EQ(exact, whole) << "the superset's";
    for (const Budget& budget : {Budget{.strip_rows = 1}, Budget{.strip_rows = 7, .strip_columns = 24},
                                 Budget{.strip_rows = 16, .modes = Modes::binned}}) {
      EXPECT_EQ(draw_any(effects | effect::bins, scene, camera, kView, budget), whole)
          << budget.strip_rows << 'x' << budget.strip_columns;
    }
  }
}

TEST(Spheres, PlansListTheirBytesOnlyWhereThereAreAny) {
  Scene without = scenes::spheres.scene;
  without.quadrics = {};
  const auto bytes = [](const Scene& scene) {
    return plan(count(scene), kView, effects_of(scene, Camera{})).plan.instance_bytes;
  };
  EXPECT_EQ(bytes(without), 2 * kInstanceBytes);
  EXPECT_EQ(bytes(scenes::spheres.scene), 2 * kInstanceBytes + 3 * kQuadricBytes);
}

TEST(Quadric, FadesIntoFogByItsDistanceAtEachPixel) {
  const Material material{.colour = {240, 160, 80, 255}, .lit = false};
  const Quadric ball{.material = 0,
                     .transform = {{{fixed(2.0), 0, 0, 0}, {0, fixed(2.0), 0, 0}, {0, 0, fixed(2.0), 0}}}};
  const Fog fog{.colour = {16, 96, 240, 255}, .mode = FogMode::linear, .start = fixed(2.5), .end = fixed(5.0)};
  Scene scene;
  scene.materials = {&material, 1};
  scene.quadrics = {&ball, 1};
  scene.fog = &fog;
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Camera camera;
    camera.projection = projection;
    camera.eye = {0, 0, fixed(5.0)};
    camera.focal = projection == Projection::perspective ? fixed(1.9) : fixed(0.4);
    const Drawn drawn = draw_any(effects_of(scene, camera), scene, camera, kView);
    int judged = 0;
    for (int y = 0; y < kView.height; ++y) {
      for (int x = 0; x < kView.width; ++x) {
        const auto ray = ray_oracle::ray_through(camera, kView, x + Real{0.5}, y + Real{0.5});
        const auto crossing = ray_oracle::cross_quadric(ray, ball.transform);
        if (crossing.clearance < 0.01L) continue;
        const Real visible = std::clamp((5 - crossing.enter.w) / Real{2.5}, Real{0}, Real{1});
        // Half a step of a channel for the pixel, and as much again for the surface's colour, which fog gets packed.
        const Real green = 160 * visible + 96 * (1 - visible);
        EXPECT_NEAR(drawn.green(x, y) + 2, static_cast<double>(green), 4.6) << x << ',' << y;
        ++judged;
      }
    }
    EXPECT_GT(judged, 2000);
  }
}

}  // namespace
