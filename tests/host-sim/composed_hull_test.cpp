// Hulls of meshes with edges: one vertex in each place, whose normal keeps a line's width along all edges.
#include "compose/composed_hull.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace zstrip::sim::test {
namespace {

/// A cube of six faces with four vertices each, in a box of these half extents.
struct Cube {
  std::vector<Position> positions;
  std::vector<Normal> normals;
  std::vector<Triangle> triangles;
  Mesh mesh;

  explicit Cube(const Vec3& half) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {-1, 1}) {
        const auto first = static_cast<std::uint16_t>(positions.size());
        for (const auto& [u, v] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
          std::array<int, 3> p{};
          p[axis] = side;
          p[(axis + 1) % 3] = side * u;
          p[(axis + 2) % 3] = v;
          const auto place = [&p](std::size_t i) { return static_cast<std::int16_t>(32767 * p[i]); };
          positions.push_back({place(0), place(1), place(2)});
          std::array<std::int8_t, 3> n{};
          n[axis] = static_cast<std::int8_t>(127 * side);
          normals.push_back({n[0], n[1], n[2], 0});
        }
        const auto corner = [first](int i) { return static_cast<std::uint16_t>(first + i); };
        triangles.push_back({corner(0), corner(1), corner(2)});
        triangles.push_back({corner(0), corner(2), corner(3)});
      }
    }
    mesh.positions = positions;
    mesh.normals = normals;
    mesh.triangles = triangles;
    mesh.half_extent = half;
  }
  Cube(const Cube&) = delete;
  Cube& operator=(const Cube&) = delete;
};

TEST(ComposedHull, CornersOfABoxPointAlongTheSumOfItsFaces) {
  for (const Fixed thickness : {kFixedOne, kFixedOne / 50}) {
    const Cube cube({kFixedOne, kFixedOne, thickness});
    EXPECT_FALSE(is_own_hull(cube.mesh)) << "each corner has three normals";
    const std::vector<MeshData> hulls = hull_of(cube.mesh);
    ASSERT_EQ(hulls.size(), 1U);
    const MeshData& hull = hulls[0];
    EXPECT_EQ(hull.positions.size(), 8U);
    EXPECT_EQ(hull.triangles.size(), 12U);
    ASSERT_EQ(hull.normals.size(), 8U);
    for (std::size_t i = 0; i < 8; ++i) {
      const Position& p = hull.positions[i];
      const Normal& n = hull.normals[i];
      EXPECT_NEAR(n.x, p.x < 0 ? -127 : 127, 3) << i;
      EXPECT_NEAR(n.y, p.y < 0 ? -127 : 127, 3) << i;
      EXPECT_NEAR(n.z, p.z < 0 ? -127 : 127, 3) << i;
    }
    Mesh own = cube.mesh;
    own.positions = hull.positions;
    own.normals = hull.normals;
    own.triangles = hull.triangles;
    EXPECT_TRUE(is_own_hull(own));
    own.normals = {};
    EXPECT_FALSE(is_own_hull(own)) << "nothing to move along";
  }
}

/// Whether a face is cut into triangles, and into how many, says nothing of where its corner moves.
TEST(ComposedHull, FlatFacesMoveStraight) {
  Cube cube({kFixedOne, kFixedOne, kFixedOne});
  // A corner in the middle of the last face (z = 1).
  cube.triangles.resize(10);
  const auto first = static_cast<std::uint16_t>(20), middle = static_cast<std::uint16_t>(cube.positions.size());
  cube.positions.push_back({5000, 100, 32767});
  cube.normals.push_back({0, 0, 127, 0});
  for (std::uint16_t i = 0; i < 4; ++i) {
    cube.triangles.push_back(
        {static_cast<std::uint16_t>(first + i), static_cast<std::uint16_t>(first + (i + 1) % 4), middle});
  }
  cube.mesh.positions = cube.positions;
  cube.mesh.normals = cube.normals;
  cube.mesh.triangles = cube.triangles;
  const std::vector<MeshData> hulls = hull_of(cube.mesh);
  ASSERT_EQ(hulls.size(), 1U);
  ASSERT_EQ(hulls[0].positions.size(), 9U);
  for (std::size_t i = 0; i < 9; ++i) {
    const Normal& n = hulls[0].normals[i];
    const bool is_middle = hulls[0].positions[i].x == 5000;
    EXPECT_NEAR(std::abs(n.x), is_middle ? 0 : 127, 3);
    EXPECT_NEAR(std::abs(n.y), is_middle ? 0 : 127, 3);
    EXPECT_NEAR(n.z, hulls[0].positions[i].z < 0 ? -127 : 127, 3);
  }
}

}  // namespace
}  // namespace zstrip::sim::test
