// The scenes of the benchmarks against the formulas that every renderer compared uses, written out again here.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry.hpp"
#include "zstrip_scenes/cube.hpp"
#include "zstrip_scenes/knot.hpp"
#include "zstrip_scenes/random.hpp"

namespace zstrip::scenes_test {
namespace {

/// Distance in steps of the position grid, the largest of the three axes.
double steps_between(const Mesh& mesh, const Position& position, const Point& expected) {
  const Point error = object_position(mesh, position) - expected;
  const Point step = (1.0 / 32768) * to_point(mesh.half_extent);
  return std::max({std::abs(error.x) / step.x, std::abs(error.y) / step.y, std::abs(error.z) / step.z});
}

TEST(Workload, KnotIsTheFormulaInDoublePrecision) {
  const Mesh& mesh = scenes::kKnotMesh[0];
  ASSERT_EQ(mesh.positions.size(), 160U * 16U);
  const auto centre_line = [](double t) {
    return Point{(std::sin(t) + 2 * std::sin(2 * t)) * 0.28, (std::cos(t) - 2 * std::cos(2 * t)) * 0.28,
                 -std::sin(3 * t) * 0.28};
  };
  double worst_steps = 0;
  for (std::size_t i = 0; i < 160; ++i) {
    const double t = 2 * M_PI * static_cast<double>(i) / 160;
    const Point c = centre_line(t), d = centre_line(t + 0.001);
    const Point tangent = (1 / length(d - c)) * (d - c);
    const Point side = (1 / std::hypot(tangent.x, tangent.y)) * Point{-tangent.y, tangent.x, 0};
    const Point other = cross(tangent, side);
    for (std::size_t j = 0; j < 16; ++j) {
      const std::size_t vertex = 16 * i + j;
      const double a = 2 * M_PI * static_cast<double>(j) / 16;
      const Point normal = std::cos(a) * side + std::sin(a) * other;
      worst_steps = std::max(worst_steps, steps_between(mesh, mesh.positions[vertex], c + 0.13 * normal));

      const Colour& colour = mesh.colours[vertex];
      EXPECT_EQ(colour.r, std::floor(127.5 + 127 * normal.x));
      EXPECT_EQ(colour.g, std::floor(127.5 + 127 * normal.y));
      EXPECT_EQ(colour.b, std::floor(127.5 + 127 * normal.z));
      const Point error = to_point(scenes::kKnotNormals[vertex]) - normal;
      EXPECT_LE(std::max({std::abs(error.x), std::abs(error.y), std::abs(error.z)}), 0.5001 / 127);
    }
  }
  EXPECT_LE(worst_steps, 0.5001);
}

// The workload as other renderers get it. In single precision the tangent is the difference of two numbers that agree
// in their first 10 bits: the reference itself is up to two steps off.
TEST(Workload, KnotIsCloseToSinglePrecision) {
  const Mesh& mesh = scenes::kKnotMesh[0];
  for (std::size_t i = 0; i < 160; ++i) {
    const float t = 6.2831853F * static_cast<float>(i) / 160, e = 0.001F;
    float c[2][3];
    for (int k = 0; k < 2; ++k) {
      const float s = t + static_cast<float>(k) * e;
      c[k][0] = (std::sin(s) + 2 * std::sin(2 * s)) * 0.28F;
      c[k][1] = (std::cos(s) - 2 * std::cos(2 * s)) * 0.28F;
      c[k][2] = -std::sin(3 * s) * 0.28F;
    }
    float tangent[3] = {c[1][0] - c[0][0], c[1][1] - c[0][1], c[1][2] - c[0][2]};
    const float l = std::sqrt(tangent[0] * tangent[0] + tangent[1] * tangent[1] + tangent[2] * tangent[2]);
    for (float& component : tangent) component /= l;
    float side[3] = {-tangent[1], tangent[0], 0};
    const float m = std::sqrt(side[0] * side[0] + side[1] * side[1]);
    side[0] /= m;
    side[1] /= m;
    const float other[3] = {tangent[1] * side[2] - tangent[2] * side[1], tangent[2] * side[0] - tangent[0] * side[2],
                            tangent[0] * side[1] - tangent[1] * side[0]};
    for (std::size_t j = 0; j < 16; ++j) {
      const float a = 6.2831853F * static_cast<float>(j) / 16;
      float position[3];
      for (int k = 0; k < 3; ++k) position[k] = c[0][k] + 0.13F * (side[k] * std::cos(a) + other[k] * std::sin(a));
      const double steps =
          steps_between(mesh, mesh.positions[16 * i + j], to_point(position[0], position[1], position[2]));
      EXPECT_LE(steps, 2.5);
    }
  }
}

// With the opposite winding: the formula's (a, b, c), (a, c, d) face inwards where counter-clockwise is the front.
TEST(Workload, KnotTrianglesAreThoseOfTheGrid) {
  std::size_t next = 0;
  for (int i = 0; i < 160; ++i) {
    for (int j = 0; j < 16; ++j) {
      const int a = i * 16 + j, b = ((i + 1) % 160) * 16 + j, c = ((i + 1) % 160) * 16 + (j + 1) % 16,
                d = i * 16 + (j + 1) % 16;
      const Triangle& first = scenes::kKnotTriangles[next++];
      const Triangle& second = scenes::kKnotTriangles[next++];
      ASSERT_EQ((std::array<int, 6>{first.a, first.b, first.c, second.a, second.b, second.c}),
                (std::array<int, 6>{a, c, b, a, d, c}));
    }
  }
}

std::uint32_t xorshift(std::uint32_t& state) {
  state ^= state << 13;
  state ^= state >> 17;
  state ^= state << 5;
  return state;
}

/// Recomputes all triangles in single precision, in the workload's order of calls.
void expect_random_workload(const Mesh& mesh, float size) {
  std::uint32_t state = 12345;
  const auto rnd = [&state](float a, float b) {
    return a + (b - a) * (static_cast<float>(xorshift(state) >> 8) / 16777216.0F);
  };
  double worst_steps = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const float cx = rnd(-.9F, .9F), cy = rnd(-.9F, .9F), cz = rnd(-.9F, .9F);
    const std::uint32_t r = xorshift(state) >> 24, g = xorshift(state) >> 24, b = xorshift(state) >> 24;
    for (std::size_t vertex = 3 * t; vertex < 3 * t + 3; ++vertex) {
      const float x = cx + rnd(-size, size) * .5F, y = cy + rnd(-size, size) * .5F, z = cz + rnd(-size, size) * .5F;
      rnd(0, 1);
      rnd(0, 1);
      worst_steps = std::max(worst_steps, steps_between(mesh, mesh.positions[vertex], to_point(x, y, z)));
      const Colour& colour = mesh.colours[vertex];
      ASSERT_EQ((std::array<std::uint32_t, 3>{colour.r, colour.g, colour.b}), (std::array<std::uint32_t, 3>{r, g, b}));
    }
    const Triangle& triangle = mesh.triangles[t];
    ASSERT_EQ((std::array<std::size_t, 3>{triangle.a, triangle.b, triangle.c}),
              (std::array<std::size_t, 3>{3 * t, 3 * t + 1, 3 * t + 2}));
  }
  EXPECT_LE(worst_steps, 0.51) << "half a step of rounding, and single precision's own error";
}

TEST(Workload, Random50IsTheSequence) {
  ASSERT_EQ(scenes::kRandom50Mesh[0].triangles.size(), 50U);
  expect_random_workload(scenes::kRandom50Mesh[0], 1.0F);
}

TEST(Workload, Random10kIsTheSequence) {
  ASSERT_EQ(scenes::kRandom10kMesh[0].triangles.size(), 10000U);
  expect_random_workload(scenes::kRandom10kMesh[0], 0.06F);
}

TEST(Workload, CubeIsTheTable) {
  static constexpr int kCorners[6][4][3] = {
      {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}, {{1, -1, -1}, {-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}},
      {{1, -1, 1}, {1, -1, -1}, {1, 1, -1}, {1, 1, 1}}, {{-1, -1, -1}, {-1, -1, 1}, {-1, 1, 1}, {-1, 1, -1}},
      {{-1, 1, 1}, {1, 1, 1}, {1, 1, -1}, {-1, 1, -1}}, {{-1, -1, -1}, {1, -1, -1}, {1, -1, 1}, {-1, -1, 1}}};
  static constexpr int kUv[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Mesh& mesh = scenes::kCubeMesh[0];
  const int one = 1 << mesh.texcoord_bits;
  for (std::size_t i = 0; i < 24; ++i) {
    const int* corner = kCorners[i / 4][i % 4];
    const Point expected{double(corner[0]), double(corner[1]), double(corner[2])};
    EXPECT_LT(length(object_position(mesh, mesh.positions[i]) - expected), 1e-6);
    EXPECT_EQ(mesh.texcoords[i].u, one * kUv[i % 4][0]);
    EXPECT_EQ(mesh.texcoords[i].v, one * kUv[i % 4][1]);
  }
}

TEST(Workload, CubeTextureIsTheSequence) {
  std::uint32_t state = 777;
  for (std::size_t y = 0; y < 64; ++y) {
    for (std::size_t x = 0; x < 64; ++x) {
      const std::size_t c = ((x >> 3) ^ (y >> 3)) & 1;
      const std::uint32_t k = xorshift(state) >> 27;
      const std::uint32_t r = c ? 31 : k, g = c ? 63 - k : 20, b = c ? 10 : 31 - k;
      ASSERT_EQ(scenes::kCubeTexels[64 * y + x], (r << 11) | (g << 5) | b) << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace zstrip::scenes_test
