// Solids that products are made of, and how pictures of them are judged by rays.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "csg_oracle.hpp"
#include "drawn.hpp"
#include "own_mesh.hpp"

namespace effects_test {

using zstrip::test::faceted_box;
using zstrip::test::OwnMesh;
using zstrip::test::sphere;

inline constexpr View kCsgView{128, 96, PixelFormat::rgb565};

/// A ring around z in the unit cube, of a thickness of 0.3: rays enter it twice.
inline OwnMesh ring(int around, int across) {
  OwnMesh own;
  const double turn = 2 * std::numbers::pi;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = turn * i / around, v = turn * j / across, r = 0.7 + 0.3 * std::cos(v);
      const std::array p{r * std::cos(u), r * std::sin(u), 0.3 * std::sin(v)};
      const std::array n{std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)};
      const auto place = [&p](std::size_t axis) { return static_cast<std::int16_t>(std::lround(32767 * p[axis])); };
      const auto normal = [&n](std::size_t axis) { return static_cast<std::int8_t>(std::lround(127 * n[axis])); };
      own.positions.push_back({place(0), place(1), place(2)});
      own.normals.push_back({normal(0), normal(1), normal(2), 0});
      const auto vertex = [=](int at, int beside) {
        return static_cast<std::uint16_t>(at % around * across + beside % across);
      };
      own.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      own.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return own;
}

/// The same surface from the other side.
inline OwnMesh turned_inside_out(OwnMesh own) {
  for (Triangle& t : own.triangles) std::swap(t.b, t.c);
  for (Normal& n : own.normals) {
    for (std::int8_t* const component : {&n.x, &n.y, &n.z}) *component = static_cast<std::int8_t>(-*component);
  }
  return own;
}

/// Scaled by `size`, turned about y and then about x.
inline Transform posed(double x, double y, double z, double size, double about_y = 0, double about_x = 0) {
  const double c = std::cos(about_y), s = std::sin(about_y), d = std::cos(about_x), t = std::sin(about_x);
  const std::array<std::array<double, 4>, 3> m{{{size * c, 0, size * s, x},
                                                {size * t * s, size * d, -size * t * c, y},
                                                {-size * d * s, size * t, size * d * c, z}}};
  Transform transform;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      transform.m[row][column] = static_cast<Fixed>(std::lround(std::ldexp(m[row][column], 16)));
    }
  }
  return transform;
}

/// Instances of a box, a ball and a ring, each in its own colour and unlit: the picture says which of them is seen.
struct CsgWorld {
  OwnMesh box = faceted_box(), ball = sphere(16, 32), hoop = ring(32, 12);
  Mesh meshes[3];
  std::vector<Material> materials;
  std::vector<Instance> instances;
  std::vector<CsgOperand> operands;
  Scene scene;
  Camera camera;

  enum Shape : std::uint16_t { kBox, kBall, kRing };

  CsgWorld() {
    meshes[kBox] = box.mesh();
    meshes[kBall] = ball.mesh();
    meshes[kRing] = hoop.mesh();
    look(3000, 12000);
  }
  CsgWorld(const CsgWorld&) = delete;
  CsgWorld& operator=(const CsgWorld&) = delete;

  void look(Angle around, Angle up, double distance = 6) {
    EXPECT_TRUE(orbit(camera, {0, 0, 0}, static_cast<Fixed>(std::lround(std::ldexp(distance, 16))), around, up));
    camera.focal = 2 * kFixedOne;
  }
  std::uint16_t add(Shape shape, const Transform& transform) {
    const auto index = static_cast<std::uint16_t>(instances.size());
    const auto channel = [index](int factor) { return static_cast<std::uint8_t>(40 + index * factor % 200); };
    materials.push_back({.colour = {channel(64), channel(104), channel(168), 255}, .lit = false, .smooth = false});
    instances.push_back({shape, index, transform});
    return index;
  }
  void intersect(std::uint16_t instance, std::uint8_t product = 0) {
    operands.push_back({instance, product, CsgUse::intersected});
  }
  void subtract(std::uint16_t instance, std::uint8_t product = 0) {
    operands.push_back({instance, product, CsgUse::subtracted});
  }
  const Scene& whole() {
    scene.meshes = meshes;
    scene.materials = materials;
    scene.instances = instances;
    scene.csg = operands;
    return scene;
  }
};

struct CsgJudged {
  int seen = 0;     ///< pixels of a solid
  int unclear = 0;  ///< within a tenth of a pixel of an edge, or where faces are close to each other
  int wrong = 0;
};

/// Which solid each pixel shows, but where an edge or another face is nearer than `close` (units of length).
inline CsgJudged judge(CsgWorld& world, const Drawn& drawn, double close = 4e-3) {
  const View view{static_cast<std::uint16_t>(drawn.width), static_cast<std::uint16_t>(drawn.height)};
  const oracle::CsgOracle rays(world.whole(), world.camera, view);
  CsgJudged judged;
  for (int y = 0; y < drawn.height; ++y) {
    for (int x = 0; x < drawn.width; ++x) {
      const auto middle = rays.seen(x + 0.5, y + 0.5);
      judged.seen += middle ? 1 : 0;
      const Colour colour = middle ? world.materials[middle->instance].colour : world.scene.background;
      if (drawn.at(x, y) == detail::rgb565(colour)) continue;
      bool clear = !middle || middle->clearance > close;
      for (int step = 0; step < 8 && clear; ++step) {
        const double angle = step * std::numbers::pi / 4;
        clear = rays.seen(x + 0.5 + 0.1 * std::cos(angle), y + 0.5 + 0.1 * std::sin(angle)) == middle;
      }
      ++(clear ? judged.wrong : judged.unclear);
      if (clear && judged.wrong < 4) ADD_FAILURE() << x << ' ' << y << " is 0x" << std::hex << drawn.at(x, y);
    }
  }
  return judged;
}

inline void expect_right(CsgWorld& world, const Drawn& drawn, const char* what, int at_least = 400) {
  const CsgJudged judged = judge(world, drawn);
  EXPECT_EQ(judged.wrong, 0) << what;
  EXPECT_GT(judged.seen, at_least) << what;
  EXPECT_LE(judged.unclear, judged.seen / 50) << what;
}

}  // namespace effects_test
