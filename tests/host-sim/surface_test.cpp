// Normals, closed bodies, welding, texture coordinates, on source models made by hand.
#include "import/surface.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "import/read_model.hpp"
#include "import/texcoords.hpp"
#include "support.hpp"

namespace zstrip::sim::test {
namespace {

class Surface : public FolderTest {
 protected:
  SourceModel model(const std::string& obj) const {
    Result<SourceModel> read = read_model(file("model.obj", obj), UpAxis::plus_y);
    EXPECT_TRUE(read) << read.failure().message;
    return std::move(*read);
  }
};

TEST_F(Surface, CubeKeepsItsCreases) {
  SourceModel cube = model(cube_obj());
  generate_missing_normals(cube);
  ASSERT_EQ(cube.meshes.size(), 1U);
  for (const SourceVertex& vertex : cube.meshes[0].vertices) {
    std::array<float, 3> magnitudes{};
    for (std::size_t i = 0; i < 3; ++i) magnitudes[i] = std::abs(vertex.normal[i]);
    std::sort(magnitudes.begin(), magnitudes.end());
    EXPECT_NEAR(magnitudes[0], 0, 1e-6);
    EXPECT_NEAR(magnitudes[1], 0, 1e-6);
    EXPECT_NEAR(magnitudes[2], 1, 1e-6);
  }
  weld(cube.meshes[0]);
  EXPECT_EQ(cube.meshes[0].vertices.size(), 24U);
}

TEST_F(Surface, SphereBecomesSmooth) {
  SourceModel sphere = model(sphere_obj(48, 24));
  generate_missing_normals(sphere);
  weld(sphere.meshes[0]);
  EXPECT_EQ(sphere.meshes[0].vertices.size(), 48U * 23U + 2U);
  for (const SourceVertex& vertex : sphere.meshes[0].vertices) {
    double dot = 0;
    double length = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      dot += double{vertex.normal[i]} * double{vertex.position[i]};
      length += double{vertex.normal[i]} * double{vertex.normal[i]};
    }
    EXPECT_NEAR(length, 1, 1e-5);
    EXPECT_GT(dot, 0.7);
  }
}

TEST_F(Surface, ManyFacesAtOnePointTakeNoSquareTime) {
  std::string fan = "v 0 1 0\n";
  constexpr int kFaces = 30000;
  for (int i = 0; i <= kFaces; ++i) {
    fan += "v " + std::to_string(std::cos(i * 1e-4)) + " 0 " + std::to_string(std::sin(i * 1e-4)) + "\n";
  }
  for (int i = 0; i < kFaces; ++i) fan += "f 1 " + std::to_string(i + 3) + " " + std::to_string(i + 2) + "\n";
  SourceModel cone = model(fan);
  const auto begin = std::clock();
  generate_missing_normals(cone);
  EXPECT_LT((std::clock() - begin) / CLOCKS_PER_SEC, 1) << "seconds of processor time";
  EXPECT_GT(cone.meshes[0].vertices.size(), 1000U);
}

TEST_F(Surface, ClosedOutside) {
  for (const std::string& body : {cube_obj(), sphere_obj(8, 6)}) {
    EXPECT_EQ(find_outsides(model(body)), std::vector<Outside>{{.is_closed = true}});
  }
}

TEST_F(Surface, AMissingFaceOpensTheCube) {
  const std::string cube = cube_obj();
  const Outside open = find_outsides(model(cube.substr(0, cube.rfind("f "))))[0];
  EXPECT_FALSE(open.is_closed);
  EXPECT_NEAR(open.opening, 1.0 / 5, 1e-9);
}

TEST_F(Surface, InsideOutIsNotOutside) {
  std::string cube = cube_obj();
  std::string inside_out = cube.substr(0, cube.find("f "));
  inside_out += "f 1 2 3 4\nf 8 7 6 5\nf 5 6 2 1\nf 7 8 4 3\nf 6 7 3 2\nf 8 5 1 4\n";
  EXPECT_EQ(find_outsides(model(inside_out)), std::vector<Outside>{{.is_closed = false}});
}

TEST_F(Surface, OpeningsOfSheetsTubesAndOfABodyBesideASheet) {
  const auto opening = [&](const std::string& obj) { return find_outsides(model(obj))[0].opening; };
  const std::string sheet = "v 5 0 0\nv 6 0 0\nv 6 1 0\nv 5 1 0\nf -4 -3 -2 -1\n";
  EXPECT_NEAR(opening(sheet), 1, 1e-9);
  // A cube without two faces that lie opposite each other: openings on both ends, 8 of 16.
  const std::string cube = cube_obj();
  std::string tube = cube.substr(0, cube.find("f "));
  tube += "f 5 6 2 1\nf 7 8 4 3\nf 6 7 3 2\nf 8 5 1 4\n";
  EXPECT_NEAR(opening(tube), 0.5, 1e-9);
  // The sheet is 1 of 25 parts of the area.
  EXPECT_NEAR(opening(cube + sheet), 1.0 / 25, 1e-6);
}

TEST_F(Surface, FilesWithNormalsKeepThem) {
  SourceModel triangle = model("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0.6 0.8\nf 1//1 2//1 3//1\n");
  generate_missing_normals(triangle);
  for (const SourceVertex& vertex : triangle.meshes[0].vertices) {
    EXPECT_FLOAT_EQ(vertex.normal[1], 0.6F);
    EXPECT_FLOAT_EQ(vertex.normal[2], 0.8F);
  }
}

SourceMesh textured_triangle(std::array<std::array<float, 2>, 3> texcoords) {
  SourceMesh mesh;
  mesh.has_texcoords = true;
  for (const auto& texcoord : texcoords) {
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
    mesh.vertices.push_back({.texcoord = texcoord});
  }
  return mesh;
}

TEST(Texcoords, UnitSquareTakesFourteenBits) {
  SourceMesh mesh = textured_triangle({{{0, 0}, {1, 0}, {0, 1}}});
  std::uint64_t clamped = 0;
  EXPECT_EQ(fit_texcoords(mesh, 8, clamped), 14);
  EXPECT_EQ(clamped, 0U);
}

TEST(Texcoords, FarAwayIsMovedByWholeTextures) {
  SourceMesh mesh = textured_triangle({{{1000.25F, -500}, {1001, -500.5F}, {1000.5F, -499.25F}}});
  const SourceMesh before = mesh;
  std::uint64_t clamped = 0;
  EXPECT_GE(fit_texcoords(mesh, 8, clamped), 13);
  EXPECT_EQ(clamped, 0U);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const float moved = mesh.vertices[i].texcoord[axis] - before.vertices[i].texcoord[axis];
      EXPECT_EQ(moved, std::round(moved));
      EXPECT_LE(std::abs(mesh.vertices[i].texcoord[axis]), 2);
    }
  }
}

TEST(Texcoords, AWideMeshIsMovedTriangleByTriangle) {
  SourceMesh mesh = textured_triangle({{{0, 0}, {1, 0}, {0, 1}}});
  const SourceMesh far = textured_triangle({{{300, 0}, {301, 0}, {300, 1}}});
  mesh.vertices.insert(mesh.vertices.end(), far.vertices.begin(), far.vertices.end());
  mesh.indices = {0, 1, 2, 3, 4, 5};
  std::uint64_t clamped = 0;
  EXPECT_EQ(fit_texcoords(mesh, 10, clamped), 14);
  EXPECT_EQ(clamped, 0U);
}

TEST(Texcoords, WhatDoesNotFitIsClampedAndCounted) {
  SourceMesh mesh = textured_triangle({{{0, 0}, {1e30F, 0}, {0, 1}}});
  std::uint64_t clamped = 0;
  EXPECT_EQ(fit_texcoords(mesh, 8, clamped), kMinTexcoordBits);
  EXPECT_GT(clamped, 0U);
  for (const SourceVertex& vertex : mesh.vertices) EXPECT_LE(std::abs(vertex.texcoord[0]), 2048);
}

TEST(Texcoords, TexelsStayBelowTheRenderersLimit) {
  // 40 repeats are 20 on each side: 20 * 2048 texels are too many.
  SourceMesh mesh = textured_triangle({{{0, 0}, {40, 0}, {40, 3}}});
  std::uint64_t clamped = 0;
  const int bits = fit_texcoords(mesh, 11, clamped);
  EXPECT_EQ(clamped, 0U);
  const TextureSides sides = longest_sides(mesh, bits);
  EXPECT_EQ(sides.log2_width, 10);
  EXPECT_GE(sides.log2_height, 11);
}

TEST(Texcoords, RoundingUpToTheLimitIsBeyondIt) {
  SourceMesh mesh = textured_triangle({{{-15.99999F, 0}, {15.99999F, 0}, {0, 1}}});
  EXPECT_EQ(longest_sides(mesh, 10).log2_width, 10);
  mesh.vertices[0].texcoord[0] = -15.99F;
  mesh.vertices[1].texcoord[0] = 15.99F;
  EXPECT_EQ(longest_sides(mesh, 10).log2_width, 11);
}

}  // namespace
}  // namespace zstrip::sim::test
