// Removed triangles: what is closed stays closed, limits are kept, and what a surface shows is not smeared.
#include "import/reduction.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "import/surface.hpp"

namespace zstrip::sim::test {
namespace {

using At = std::array<float, 3>;

/// A grid of (columns + 1) x (rows + 1) vertices, two triangles a cell; `vertex` gets 0..1 along both.
SourceMesh grid_mesh(int columns, int rows, const std::function<SourceVertex(double u, double v)>& vertex) {
  SourceMesh mesh;
  mesh.has_texcoords = true;
  for (int y = 0; y <= rows; ++y) {
    for (int x = 0; x <= columns; ++x) mesh.vertices.push_back(vertex(1.0 * x / columns, 1.0 * y / rows));
  }
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const auto a = static_cast<std::uint32_t>(y * (columns + 1) + x);
      const std::uint32_t b = a + 1, c = a + static_cast<std::uint32_t>(columns) + 1, d = c + 1;
      for (const std::uint32_t index : {a, b, d, a, d, c}) mesh.indices.push_back(index);
    }
  }
  return mesh;
}

/// A place on a torus around z, closed along both axes.
SourceVertex on_torus(double u, double v) {
  const double turn = 2 * std::numbers::pi;
  const double a = u == 1 ? 0 : turn * u, b = v == 1 ? 0 : turn * v;
  const double bulge = 1 + 0.1 * std::sin(3 * a);
  SourceVertex vertex;
  vertex.position = {static_cast<float>(std::cos(a) * (2 + bulge * std::cos(b))),
                     static_cast<float>(std::sin(a) * (2 + bulge * std::cos(b))),
                     static_cast<float>(bulge * std::sin(b))};
  vertex.normal = {static_cast<float>(std::cos(a) * std::cos(b)) + 0.0F,
                   static_cast<float>(std::sin(a) * std::cos(b)) + 0.0F, static_cast<float>(std::sin(b)) + 0.0F};
  vertex.texcoord = {static_cast<float>(u), static_cast<float>(v)};
  return vertex;
}

SourceModel torus(int columns, int rows) {
  SourceModel model;
  model.meshes.push_back(grid_mesh(columns, rows, on_torus));
  return model;
}

/// Moves the triangles of every second stripe of eight to a mesh of their own.
void add_stripes(SourceModel& model) {
  SourceMesh& all = model.meshes[0];
  SourceMesh stripes = all;
  stripes.material = 1;
  stripes.indices.clear();
  std::vector<std::uint32_t> rest;
  for (std::size_t i = 0; i < all.indices.size(); i += 3) {
    float u = 0;
    for (std::size_t k = 0; k < 3; ++k) u += all.vertices[all.indices[i + k]].texcoord[0] / 3;
    std::vector<std::uint32_t>& to = static_cast<int>(8 * u) % 2 == 0 ? rest : stripes.indices;
    to.insert(to.end(), all.indices.begin() + static_cast<std::ptrdiff_t>(i),
              all.indices.begin() + static_cast<std::ptrdiff_t>(i) + 3);
  }
  all.indices = rest;
  model.meshes.push_back(stripes);
}

/// Gives each triangle vertices of its own, with its normal.
void flatten(SourceMesh& mesh) {
  std::vector<SourceVertex> vertices;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    std::array<SourceVertex, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) corner[k] = mesh.vertices[mesh.indices[i + k]];
    std::array<double, 3> e{}, f{};
    for (std::size_t k = 0; k < 3; ++k) {
      e[k] = double{corner[1].position[k]} - corner[0].position[k];
      f[k] = double{corner[2].position[k]} - corner[0].position[k];
    }
    const std::array<double, 3> n{e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    for (SourceVertex& each : corner) {
      for (std::size_t k = 0; k < 3; ++k) each.normal[k] = static_cast<float>(n[k] / length) + 0.0F;
      vertices.push_back(each);
    }
  }
  mesh.vertices = vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i) mesh.indices[i] = static_cast<std::uint32_t>(i);
}

Reduced reduce(SourceModel& model, std::uint64_t triangles) {
  for (SourceMesh& mesh : model.meshes) weld(mesh);
  return remove_triangles(model, {.triangles = triangles});
}

std::size_t triangles_of(const SourceModel& model) {
  std::size_t count = 0;
  for (const SourceMesh& mesh : model.meshes) count += mesh.indices.size() / 3;
  return count;
}

/// The number of edges, by their places, that not exactly two triangles share, one in each direction.
std::size_t unshared_edges(const SourceModel& model) {
  std::map<std::pair<At, At>, std::pair<int, int>> uses;
  for (const SourceMesh& mesh : model.meshes) {
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
      const At& a = mesh.vertices[mesh.indices[i]].position;
      const At& b = mesh.vertices[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]].position;
      a < b ? ++uses[{a, b}].first : ++uses[{b, a}].second;
    }
  }
  std::size_t wrong = 0;
  for (const auto& [edge, use] : uses) wrong += use != std::pair{1, 1};
  return wrong;
}

TEST(RemovedTriangles, EdgesThatTwoTrianglesShareStayShared) {
  for (const bool striped : {false, true}) {
    for (const bool flat : {false, true}) {
      for (const std::uint64_t limit : {2500U, 1200U, 600U}) {
        SourceModel model = torus(64, 24);
        if (striped) add_stripes(model);
        if (flat) {
          for (SourceMesh& mesh : model.meshes) flatten(mesh);
        }
        ASSERT_EQ(unshared_edges(model), 0U);
        const Reduced reduced = reduce(model, limit);
        EXPECT_EQ(reduced.triangles_before, 2 * 64 * 24U);
        EXPECT_EQ(unshared_edges(model), 0U) << striped << flat << ' ' << limit;
        EXPECT_LE(triangles_of(model), limit) << striped << flat;
        EXPECT_GT(triangles_of(model), limit * 3 / 4) << striped << flat;
        EXPECT_EQ(reduced.triangles, triangles_of(model));
        EXPECT_TRUE(reduced.keeps_limit);
      }
    }
  }
}

TEST(RemovedTriangles, ALimitThatIsKeptChangesNothing) {
  SourceModel model = torus(16, 8);
  const Reduced reduced = reduce(model, 256);
  EXPECT_EQ(triangles_of(model), 256U);
  EXPECT_EQ(reduced.error, 0);
  EXPECT_TRUE(reduced.keeps_limit);
}

TEST(RemovedTriangles, FlatFacesStayFlat) {
  SourceModel model = torus(32, 16);
  flatten(model.meshes[0]);
  reduce(model, 300);
  SourceModel again = model;
  flatten(again.meshes[0]);
  const SourceMesh &mesh = model.meshes[0], &flat = again.meshes[0];
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(mesh.vertices[mesh.indices[i]].normal[k], flat.vertices[i].normal[k], 1e-5) << i;
    }
  }
}

TEST(RemovedTriangles, AMirroredTextureDoesNotSlide) {
  SourceModel model;
  model.meshes.push_back(grid_mesh(32, 32, [](double u, double v) {
    SourceVertex vertex;
    vertex.position = {static_cast<float>(u), static_cast<float>(v), 0};
    vertex.normal = {0, 0, 1};
    vertex.texcoord = {static_cast<float>(std::abs(u - 0.5)), static_cast<float>(v)};
    return vertex;
  }));
  reduce(model, 200);
  const SourceMesh& mesh = model.meshes[0];
  EXPECT_LE(triangles_of(model), 200U);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    double x = 0, u = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      x += double{mesh.vertices[mesh.indices[i + k]].position[0]} / 3;
      u += double{mesh.vertices[mesh.indices[i + k]].texcoord[0]} / 3;
    }
    EXPECT_NEAR(u, std::abs(x - 0.5), 1e-6);
  }
}

/// A sleeve along x whose halves follow two joints.
SourceModel sleeve(float size) {
  SourceModel model;
  model.meshes.push_back(grid_mesh(32, 12, [size](double u, double v) {
    const double angle = v == 1 ? 0 : 2 * std::numbers::pi * v;
    SourceVertex vertex;
    vertex.position = {size * static_cast<float>(4 * u), size * static_cast<float>(std::cos(angle)),
                       size * static_cast<float>(std::sin(angle))};
    vertex.normal = {0, static_cast<float>(std::cos(angle)) + 0.0F, static_cast<float>(std::sin(angle)) + 0.0F};
    vertex.joints = {0, 1, 0, 0};
    vertex.weights = {static_cast<std::uint8_t>(u < 0.5 ? 255 : 0), static_cast<std::uint8_t>(u < 0.5 ? 0 : 255)};
    return vertex;
  }));
  model.meshes[0].has_skin = true;
  model.meshes[0].has_texcoords = false;
  const double small = 1 / double{size};
  Affine inverse;
  for (std::size_t axis = 0; axis < 3; ++axis) inverse.m[axis][axis] = small;
  model.joints.resize(2, SourceJoint{.inverse_bind = inverse, .has_vertices = true});
  return model;
}

TEST(RemovedTriangles, WhereASkinBendsItsRingsStay) {
  SourceModel model = sleeve(1);
  reduce(model, 300);
  EXPECT_LE(triangles_of(model), 300U);
  const auto ring = [&](float x) {
    std::set<At> places;
    for (const SourceVertex& vertex : model.meshes[0].vertices) {
      if (vertex.position[0] == x) places.insert(vertex.position);
    }
    return places.size();
  };
  EXPECT_EQ(ring(2), 12U);
  EXPECT_EQ(ring(1.875F), 12U);
  EXPECT_LT(ring(1), 12U);
}

TEST(RemovedTriangles, ASkinModelledInAnotherUnitLosesAsMuch) {
  SourceModel metres = torus(64, 24), mixed = torus(64, 24);
  metres.meshes.push_back(sleeve(1).meshes[0]);
  metres.joints = sleeve(1).joints;
  mixed.meshes.push_back(sleeve(100).meshes[0]);
  mixed.joints = sleeve(100).joints;
  const Reduced expected = reduce(metres, 1500), reduced = reduce(mixed, 1500);
  const auto triangles = [](const SourceModel& model) {
    return static_cast<double>(model.meshes[1].indices.size() / 3);
  };
  EXPECT_NEAR(triangles(mixed), triangles(metres), 0.05 * triangles(metres));
  EXPECT_NEAR(reduced.error, expected.error, 0.1 * expected.error);
}

TEST(RemovedTriangles, OpenBordersOfPartsThatMoveApartKeepTheirCommonPlaces) {
  const auto half = [](double from) {
    return grid_mesh(16, 16, [from](double u, double v) {
      SourceVertex vertex;
      vertex.position = {static_cast<float>(from + u), static_cast<float>(v), 0};
      vertex.normal = {0, 0, 1};
      return vertex;
    });
  };
  SourceModel model;
  model.meshes = {half(0), half(1)};
  model.meshes[1].node = 0;
  reduce(model, 80);
  EXPECT_LE(triangles_of(model), 80U);
  for (const SourceMesh& mesh : model.meshes) {
    std::set<At> common, other;
    for (const SourceVertex& vertex : mesh.vertices) {
      if (vertex.position[0] == 1) common.insert(vertex.position);
      if (vertex.position[0] == (mesh.node == 0 ? 2 : 0)) other.insert(vertex.position);
    }
    EXPECT_EQ(common.size(), 17U);
    EXPECT_EQ(other.size(), 2U) << "a straight border needs only its ends";
  }
}

}  // namespace
}  // namespace zstrip::sim::test
