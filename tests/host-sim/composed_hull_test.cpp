// Hulls of meshes with edges: one vertex in each place, whose normal keeps a line's width along all edges.
#include "compose/composed_hull.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "own_mesh.hpp"

namespace zstrip::sim::test {
namespace {

/// A cube of six faces with four vertices each, in a box of these half extents.
struct Cube {
  zstrip::test::OwnMesh own = zstrip::test::faceted_box();
  Mesh mesh;

  explicit Cube(const Vec3& half) : mesh(own.mesh()) { mesh.half_extent = half; }
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

/// The library that cuts meshes aborted.
TEST(ComposedHull, AMeshWithoutAreaHasNoHull) {
  const Cube cube({0, 0, 0});
  EXPECT_TRUE(hull_of(cube.mesh).empty());
}

/// Whether a face is cut into triangles, and into how many, says nothing of where its corner moves.
TEST(ComposedHull, FlatFacesMoveStraight) {
  Cube cube({kFixedOne, kFixedOne, kFixedOne});
  // A corner in the middle of the last face (z = 1).
  cube.own.triangles.resize(10);
  const auto first = static_cast<std::uint16_t>(20), middle = static_cast<std::uint16_t>(cube.own.positions.size());
  cube.own.positions.push_back({5000, 100, 32767});
  cube.own.normals.push_back({0, 0, 127, 0});
  for (std::uint16_t i = 0; i < 4; ++i) {
    cube.own.triangles.push_back(
        {static_cast<std::uint16_t>(first + i), static_cast<std::uint16_t>(first + (i + 1) % 4), middle});
  }
  cube.mesh.positions = cube.own.positions;
  cube.mesh.normals = cube.own.normals;
  cube.mesh.triangles = cube.own.triangles;
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
