// A small world with a shadow in it, and what of a picture of it is in shadow, judged by rays in double precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "drawn.hpp"
#include "own_mesh.hpp"
#include "shadow_oracle.hpp"

namespace effects_test {

using oracle::to_fixed;
using zstrip::test::faceted_box;
using zstrip::test::OwnMesh;
using zstrip::test::sphere;

/// Turned about the vertical axis.
inline Transform placed(double x, double y, double z, double scale, double turn = 0) {
  const double c = scale * std::cos(turn), s = scale * std::sin(turn);
  return {{{to_fixed(c), 0, to_fixed(s), to_fixed(x)},
           {0, to_fixed(scale), 0, to_fixed(y)},
           {to_fixed(-s), 0, to_fixed(c), to_fixed(z)}}};
}

inline Transform stretched(Transform transform, double x, double y, double z) {
  const double factors[3] = {x, y, z};
  for (auto& row : transform.m) {
    for (int column = 0; column < 3; ++column)
      row[column] = static_cast<Fixed>(std::lround(row[column] * factors[column]));
  }
  return transform;
}

inline DirectionalLight light_from(double x, double y, double z, Colour colour = {180, 170, 150, 255}) {
  const double length = std::sqrt(x * x + y * y + z * z);
  const auto component = [length](double c) { return static_cast<std::int16_t>(std::lround(32767 * c / length)); };
  return {component(x), component(y), component(z), colour};
}

inline constexpr Effects kShadowed = effect::lighting | effect::gouraud | effect::shadows | effect::quadrics;
inline constexpr View kView{128, 96, PixelFormat::rgb565};
inline constexpr double kPixel =
    6 / (2.2 * 48);  ///< of World's camera, at what it looks at; vertices are snapped to sixteenths

/// A floor with a box, a ball of triangles and a sphere on it.
struct World {
  OwnMesh cube = faceted_box(), ball = sphere(24, 48);
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
    meshes[0] = cube.mesh();
    meshes[0].shadow = ShadowRole::only_receives;
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
inline int difference(std::uint16_t a, std::uint16_t b) {
  const auto apart = [](int one, int other) { return std::abs(one - other); };
  return std::max({apart(a >> 11, b >> 11), apart(a >> 6 & 31, b >> 6 & 31), apart(a & 31, b & 31)});
}

/// World units of a texel along the longer side of what casts, as the definition of the map has it: the extent of the
/// casters' boxes across the light, and one texel more on each side.
inline double texel_of(const World& world) {
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

inline Judged judge(World& world, const Drawn& drawn, const Drawn& lit, const Drawn& dark, double reach) {
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

}  // namespace effects_test
