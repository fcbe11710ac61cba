// The edges that are found in a mesh.
#include "import/edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "own_mesh.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip::sim::test {
namespace {

using zstrip::test::OwnMesh;

bool is_crease(const Edge& edge) { return edge.right != kNoFace && edge.a > edge.b; }
auto creases(const std::vector<Edge>& edges) { return std::ranges::count_if(edges, is_crease); }
auto borders(const std::vector<Edge>& edges) { return std::ranges::count(edges, kNoFace, &Edge::right); }

/// Whether three vertices are a triangle's, in its order, by their places.
bool is_a_face(const Mesh& mesh, std::uint16_t a, std::uint16_t b, std::uint16_t c) {
  const auto place = [&mesh](std::uint16_t vertex) {
    const Position& p = mesh.positions[vertex];
    return std::array{p.x, p.y, p.z};
  };
  return std::ranges::any_of(mesh.triangles, [&](const Triangle& t) {
    const std::array of{place(t.a), place(t.b), place(t.c)};
    for (std::size_t i = 0; i < 3; ++i) {
      if (place(a) == of[i] && place(b) == of[(i + 1) % 3] && place(c) == of[(i + 2) % 3]) return true;
    }
    return false;
  });
}

void expect_faces(const Mesh& mesh, const std::vector<Edge>& edges) {
  for (const Edge& edge : edges) {
    EXPECT_TRUE(is_a_face(mesh, edge.a, edge.b, edge.left));
    EXPECT_TRUE(edge.right == kNoFace || is_a_face(mesh, edge.b, edge.a, edge.right));
  }
}

TEST(FoundEdges, OfABoxAreTwelveCreasesAndADiagonalAFace) {
  const OwnMesh own = zstrip::test::faceted_box();
  const std::vector<Edge> edges = find_edges(own.mesh(), false);
  EXPECT_EQ(edges.size(), 18U);
  EXPECT_EQ(creases(edges), 12);
  EXPECT_EQ(borders(edges), 0);
  expect_faces(own.mesh(), edges);
  Mesh plain = own.mesh();
  plain.normals = {};
  EXPECT_EQ(creases(find_edges(plain, false)), 0) << "one colour";
  EXPECT_EQ(creases(find_edges(plain, true)), 12) << "flat faces have light of their own";
}

TEST(FoundEdges, OfASphereAreSmooth) {
  const OwnMesh own = zstrip::test::sphere(8, 12);
  const std::vector<Edge> edges = find_edges(own.mesh(), false);
  // Of the triangles at the poles one in two has no area. E = 3/2 F.
  EXPECT_EQ(edges.size(), 3U * (8 * 24 - 24) / 2);
  EXPECT_EQ(creases(edges), 0);
  EXPECT_EQ(borders(edges), 0);
  expect_faces(own.mesh(), edges);
  EXPECT_EQ(creases(find_edges(own.mesh(), true)), 252 - 6 * 12) << "the diagonals of quads, which are plane";
}

TEST(FoundEdges, ColoursThatDifferAreACrease) {
  const OwnMesh own = zstrip::test::faceted_box();
  Mesh mesh = own.mesh();
  mesh.normals = {};
  std::vector<Colour> colours(own.positions.size(), Colour{1, 2, 3, 255});
  mesh.colours = colours;
  EXPECT_EQ(creases(find_edges(mesh, false)), 0);
  for (std::size_t i = 0; i < 4; ++i) colours[i].g = 9;  // the first face's
  EXPECT_EQ(creases(find_edges(mesh, false)), 4);
}

TEST(FoundEdges, OfOneFaceEndTheMesh) {
  OwnMesh own = zstrip::test::faceted_box();
  own.triangles.resize(10);
  EXPECT_EQ(borders(find_edges(own.mesh(), false)), 4);
  // Three faces at one edge, and two that run along theirs in one direction: no two of them are a pair.
  own.positions = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, -9, 0}, {0, 0, 9}};
  own.normals.clear();
  own.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  EXPECT_EQ(borders(find_edges(own.mesh(), false)), 9);
  own.triangles = {{0, 1, 2}, {0, 1, 4}};
  EXPECT_EQ(borders(find_edges(own.mesh(), false)), 6);
}

TEST(FoundEdges, OfAnyTrianglesAreValid) {
  std::mt19937 random(9);
  for (int i = 0; i < 200; ++i) {
    OwnMesh own;
    const auto small = [&random] { return static_cast<std::int16_t>(random() % 3); };
    for (int vertex = 0; vertex < 12; ++vertex) own.positions.push_back({small(), small(), small()});
    const auto vertex = [&random] { return static_cast<std::uint16_t>(random() % 12); };
    for (int triangle = 0; triangle < 20; ++triangle) own.triangles.push_back({vertex(), vertex(), vertex()});
    const Mesh mesh = own.mesh();
    const std::vector<Edge> edges = find_edges(mesh, i % 2 == 0);
    expect_faces(mesh, edges);
    const EdgeSet set{edges, 0};
    EXPECT_TRUE(validate(Scene{
        .meshes = {&mesh, 1}, .materials = {}, .textures = {}, .instances = {}, .lights = {}, .edges = {&set, 1}}));
  }
}

}  // namespace
}  // namespace zstrip::sim::test
