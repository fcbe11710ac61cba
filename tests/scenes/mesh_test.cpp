// The meshes: closed, facing outwards, with normals that agree with the faces, and meshlets that hold what they say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>

#include "geometry.hpp"
#include "zstrip_scenes/cube.hpp"
#include "zstrip_scenes/knot.hpp"
#include "zstrip_scenes/knot_meshlets.hpp"
#include "zstrip_scenes/random.hpp"
#include "zstrip_scenes/room.hpp"
#include "zstrip_scenes/scenes.hpp"
#include "zstrip_scenes/teapot.hpp"
#include "zstrip_scenes/teapot_meshlets.hpp"

namespace zstrip::scenes_test {
namespace {

struct Edges {
  std::size_t open = 0;      ///< used by one triangle only
  std::size_t repeated = 0;  ///< used twice in the same direction: flipped or doubled triangles
};
Edges edges_of(const Mesh& mesh) {
  std::set<std::pair<std::size_t, std::size_t>> directed;
  Edges edges;
  for (const WeldedTriangle& t : welded(mesh)) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!directed.emplace(t[i], t[(i + 1) % 3]).second) ++edges.repeated;
    }
  }
  for (const auto& [from, to] : directed) edges.open += directed.count({to, from}) == 0;
  return edges;
}

/// The cosines between faces and the normals at their corners, the worst first.
std::vector<double> agreement(const Mesh& mesh) {
  std::vector<double> cosines;
  for (const Triangle& t : mesh.triangles) {
    const Point a = object_position(mesh, mesh.positions[t.a]);
    const Point face =
        cross(object_position(mesh, mesh.positions[t.b]) - a, object_position(mesh, mesh.positions[t.c]) - a);
    for (const std::uint16_t vertex : {t.a, t.b, t.c}) {
      const Point normal = to_point(mesh.normals[vertex]);
      cosines.push_back(dot(face, normal) / (length(face) * length(normal)));
    }
  }
  std::sort(cosines.begin(), cosines.end());
  return cosines;
}
double worst_agreement(const Mesh& mesh) { return agreement(mesh).front(); }

Mesh with_normals(Mesh mesh, std::span<const Normal> normals) {
  mesh.normals = normals;
  return mesh;
}

TEST(Mesh, KnotIsClosed) {
  for (const Mesh& mesh : {scenes::kKnotMesh[0], scenes::kKnotMeshletsMesh[0]}) {
    EXPECT_EQ(edges_of(mesh).open, 0U);
    EXPECT_EQ(edges_of(mesh).repeated, 0U);
  }
}

TEST(Mesh, CubeAndRoomAreClosed) {
  for (const Mesh& mesh : {scenes::kCubeMesh[0], scenes::kRoomMeshes[0]}) {
    EXPECT_EQ(edges_of(mesh).open, 0U);
    EXPECT_EQ(edges_of(mesh).repeated, 0U);
  }
}

// Newell's patches leave six edge loops open: body's rim and lid's edge (16 edges each), both ends of the handle and
// of the spout (8 each).
TEST(Mesh, TeapotIsOpenOnlyWhereTheDataIs) {
  for (const Mesh& mesh : {scenes::kTeapotMesh[0], scenes::kTeapotMeshletsMesh[0]}) {
    EXPECT_EQ(edges_of(mesh).open, 64U);
    EXPECT_EQ(edges_of(mesh).repeated, 0U);
  }
}

TEST(Mesh, NoTriangleOfASurfaceIsDegenerate) {
  for (const Mesh& mesh :
       {scenes::kKnotMesh[0], scenes::kCubeMesh[0], scenes::kRoomMeshes[0], scenes::kTeapotMesh[0]}) {
    for (const Triangle& t : mesh.triangles) {
      const Point a = object_position(mesh, mesh.positions[t.a]);
      const Point b = object_position(mesh, mesh.positions[t.b]);
      const Point c = object_position(mesh, mesh.positions[t.c]);
      ASSERT_GT(length(cross(b - a, c - a)), 1e-6);
    }
  }
}

TEST(Mesh, FrontFacesLookOutwards) {
  // A tube around the trefoil: area of the 16-sided ring times the length of the curve, to a few percent.
  const double ring = 8 * std::sin(2 * M_PI / 16) * 0.13 * 0.13;
  double curve = 0;
  for (int i = 0; i < 10000; ++i) {
    const double t = 2 * M_PI * i / 10000;
    curve += 0.28 * std::sqrt(std::pow(std::cos(t) + 4 * std::cos(2 * t), 2) +
                              std::pow(-std::sin(t) + 4 * std::sin(2 * t), 2) + std::pow(3 * std::cos(3 * t), 2));
  }
  curve *= 2 * M_PI / 10000;
  EXPECT_NEAR(signed_volume(scenes::kKnotMesh[0]), ring * curve, 0.01 * ring * curve);
  EXPECT_NEAR(signed_volume(scenes::kCubeMesh[0]), 8, 1e-5);
  EXPECT_NEAR(signed_volume(scenes::kRoomMeshes[0]), -40, 0.01) << "seen from inside";
  EXPECT_NEAR(signed_volume(scenes::kTeapotMesh[0]), 3172.52 / std::pow(16.070313, 3), 1e-5) << "the source's volume";
}

TEST(Mesh, NormalsAgreeWithTheFaces) {
  EXPECT_GT(worst_agreement(scenes::kKnotLitMesh[0]), 0.9);
  EXPECT_GT(worst_agreement(scenes::kKnotTexturedMesh[0]), 0.9);
  EXPECT_GT(worst_agreement(with_normals(scenes::kCubeMesh[0], scenes::kCubeNormals)), 0.9999);
  EXPECT_GT(worst_agreement(scenes::kRoomMeshes[0]), 0.9999);
  // The teapot has creases: at the rim, the spout's mouth, and one vertex where handle and body touch.
  const std::vector<double> teapot = agreement(scenes::kTeapotMesh[0]);
  EXPECT_GT(teapot.front(), 0);
  EXPECT_GT(teapot[teapot.size() / 50], 0.6);
  EXPECT_GT(teapot[teapot.size() / 4], 0.9);
}

TEST(Mesh, NormalsAreUnitVectors) {
  for (const scenes::BuiltIn& scene : scenes::built_in()) {
    for (const Mesh& mesh : scene.scene.meshes) {
      for (const Normal& normal : mesh.normals) ASSERT_NEAR(length(to_point(normal)), 1, 0.008) << scene.name;
    }
  }
}

TEST(Mesh, PositionsUseTheGrid) {
  for (const scenes::BuiltIn& scene : scenes::built_in()) {
    for (const Mesh& mesh : scene.scene.meshes) {
      int largest = 0;
      for (const Position& p : mesh.positions) {
        for (const int value : {p.x, p.y, p.z}) {
          ASSERT_NE(value, -32768) << scene.name;
          largest = std::max(largest, std::abs(value));
        }
      }
      EXPECT_GT(largest, 30000) << scene.name << " wastes the half extent";
    }
  }
}

TEST(Mesh, TeapotStandsUpright) {
  const Mesh& mesh = scenes::kTeapotMesh[0];
  double lowest = 1, highest = -1, spout = -1, handle = 1, knob = 1;
  for (const Position& position : mesh.positions) {
    const Point p = object_position(mesh, position);
    lowest = std::min(lowest, p.y);
    highest = std::max(highest, p.y);
    spout = std::max(spout, p.x);
    handle = std::min(handle, p.x);
    if (p.y > 0.4) knob = std::min(knob, std::abs(p.z));
  }
  EXPECT_NEAR(spout, 1, 1e-4);
  EXPECT_NEAR(handle, -1, 1e-4);
  EXPECT_NEAR(highest, 7.875 / 16.070313, 1e-4);
  EXPECT_NEAR(lowest, -7.875 / 16.070313, 1e-4);
  EXPECT_NEAR(knob, 0, 1e-4) << "the lid's knob is on top, in the middle";
}

/// Everything the renderer reads of a triangle, in order.
std::vector<std::array<int, 12>> corners(const Mesh& mesh) {
  std::vector<std::array<int, 12>> result;
  for (const Triangle& t : mesh.triangles) {
    std::array<std::array<int, 4>, 3> corner{};
    std::size_t next = 0;
    for (const std::uint16_t vertex : {t.a, t.b, t.c}) {
      const Position& p = mesh.positions[vertex];
      int attribute = 0;
      if (!mesh.normals.empty()) {
        const Normal& n = mesh.normals[vertex];
        attribute = (n.x + 128) << 16 | (n.y + 128) << 8 | (n.z + 128);
      } else if (!mesh.colours.empty()) {
        const Colour& c = mesh.colours[vertex];
        attribute = c.r << 16 | c.g << 8 | c.b;
      }
      corner[next++] = {p.x, p.y, p.z, attribute};
    }
    std::rotate(corner.begin(), std::min_element(corner.begin(), corner.end()), corner.end());
    std::array<int, 12> all{};
    for (std::size_t i = 0; i < 12; ++i) all[i] = corner[i / 4][i % 4];
    result.push_back(all);
  }
  std::sort(result.begin(), result.end());
  return result;
}

TEST(Meshlets, CutMeshesHoldTheSameTriangles) {
  EXPECT_EQ(corners(scenes::kTeapotMesh[0]), corners(scenes::kTeapotMeshletsMesh[0]));
  EXPECT_EQ(corners(scenes::kKnotMesh[0]), corners(scenes::kKnotMeshletsMesh[0]));
  EXPECT_EQ(corners(scenes::kKnotLitMesh[0]), corners(scenes::kKnotTexturedMesh[0]));
  EXPECT_EQ(corners(scenes::kRandom10kMesh[0]), corners(scenes::kRandom10kMeshletsMesh[0]));
}

TEST(Meshlets, AreSmallAndInsideTheirSpheres) {
  for (const scenes::BuiltIn& scene : scenes::built_in()) {
    for (const Mesh& mesh : scene.scene.meshes) {
      const double unit = std::max({mesh.half_extent.x, mesh.half_extent.y, mesh.half_extent.z});
      for (const Meshlet& meshlet : mesh.meshlets) {
        EXPECT_LE(meshlet.vertex_count, 64);
        double farthest = 0;
        for (const Position& p : mesh.positions.subspan(meshlet.first_vertex, meshlet.vertex_count)) {
          const Point offset{(p.x - meshlet.centre.x) * (mesh.half_extent.x / unit),
                             (p.y - meshlet.centre.y) * (mesh.half_extent.y / unit),
                             (p.z - meshlet.centre.z) * (mesh.half_extent.z / unit)};
          farthest = std::max(farthest, length(offset));
        }
        EXPECT_LE(farthest, meshlet.radius) << scene.name;
        EXPECT_GE(farthest, meshlet.radius - 1.001) << scene.name << ": larger than need be";
      }
    }
  }
}

// On the cut mesh the texture closes: coincident vertices differ by whole repeats.
TEST(Meshlets, TheKnotsTextureHasNoSeam) {
  const Mesh& mesh = scenes::kKnotTexturedMesh[0];
  const int one = 1 << mesh.texcoord_bits;
  std::map<std::array<int, 3>, TexCoord> first;
  int largest_u = 0, largest_v = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Position& p = mesh.positions[i];
    const TexCoord& uv = mesh.texcoords[i];
    const TexCoord& other = first.try_emplace({p.x, p.y, p.z}, uv).first->second;
    EXPECT_EQ((uv.u - other.u) % one, 0);
    EXPECT_EQ((uv.v - other.v) % one, 0);
    largest_u = std::max<int>(largest_u, uv.u);
    largest_v = std::max<int>(largest_v, uv.v);
  }
  EXPECT_EQ(largest_u, 8 * one);
  EXPECT_EQ(largest_v, one);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint16_t vertex : {t.b, t.c}) {
      EXPECT_LE(std::abs(mesh.texcoords[vertex].u - mesh.texcoords[t.a].u), 8 * one / 160 + 1);
      EXPECT_LE(std::abs(mesh.texcoords[vertex].v - mesh.texcoords[t.a].v), one / 16);
    }
  }
}

}  // namespace
}  // namespace zstrip::scenes_test
