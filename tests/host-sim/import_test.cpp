// The whole import: what comes out is a scene that the renderer takes, and the same surface as in the file.
#include "import_fixture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "import/quantise.hpp"
#include "import/read_model.hpp"

namespace zstrip::sim::test {
namespace {

TEST_F(Import, OneTriangle) {
  const Model one = model(file("t.obj", kTriangleObj));
  ASSERT_EQ(one.meshes.size(), 1U);
  EXPECT_EQ(one.meshes[0].triangles.size(), 1U);
  EXPECT_EQ(one.meshes[0].positions.size(), 3U);
  EXPECT_TRUE(one.materials[0].double_sided);
  EXPECT_EQ(one.meshes[0].half_extent.z, 0);
}

TEST_F(Import, LongestSideBecomesTwo) {
  const Model box =
      model(file("box.obj", "v 10 20 30\nv 14 20 30\nv 10 22 30\nv 10 20 31\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"));
  EXPECT_EQ(box.units.origin, (std::array<double, 3>{12, 21, 30.5}));
  EXPECT_EQ(box.units.scale, 0.5);
  const Mesh& mesh = box.meshes[0];
  EXPECT_FALSE(box.materials[0].double_sided);
  for (const Position& p : mesh.positions) {
    // Corners lie at the box's faces, within the step of the grid.
    EXPECT_NEAR(std::abs(from_fixed(mesh.half_extent.x) * p.x / 32768), 1, 1.0 / 32768);
    EXPECT_NEAR(std::abs(from_fixed(mesh.half_extent.y) * p.y / 32768), 0.5, 1.0 / 32768);
    EXPECT_NEAR(std::abs(from_fixed(mesh.half_extent.z) * p.z / 32768), 0.25, 1.0 / 32768);
  }
}

TEST_F(Import, UpAxes) {
  // The tip is away from the base along +z; after turning it must be on top, without mirroring.
  const std::string path = file("t.obj", "v 0 0 3\nv 1 0 0\nv 0 1 0\nv -1 -1 0\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n");
  for (const auto& [up, tip_y] : std::map<UpAxis, int>{{UpAxis::plus_z, 32767}, {UpAxis::minus_z, -32767}}) {
    const Model turned = model(path, up);
    int extreme = 0;
    for (const Position& p : turned.meshes[0].positions) {
      if (p.x > -20000 && p.x < 20000 && std::abs(p.z) < 20000) extreme = p.y;
    }
    EXPECT_NEAR(extreme, tip_y, 1);
    EXPECT_FALSE(turned.materials[0].double_sided) << "a mirrored tetrahedron would be inside out";
  }
}

/// A triangle of side 2 at z = 0 and 1, as FBX with an axis that points upwards: 0 x, 1 y, 2 z.
std::string fbx(int up, int sign) {
  return fmt::format(
      "; FBX 7.3.0 project file\nFBXHeaderExtension:  {{\n\tFBXHeaderVersion: 1003\n\tFBXVersion: 7300\n}}\n"
      "GlobalSettings:  {{\n\tVersion: 1000\n\tProperties70:  {{\n"
      "\t\tP: \"UpAxis\", \"int\", \"Integer\", \"\",{}\n\t\tP: \"UpAxisSign\", \"int\", \"Integer\", "
      "\"\",{}\n\t}}\n}}\n"
      "Objects:  {{\n\tGeometry: 1, \"Geometry::\", \"Mesh\" {{\n\t\tVertices: *9 {{\n\t\t\ta: "
      "0,0,0,2,0,0,0,0,1\n\t\t}}\n"
      "\t\tPolygonVertexIndex: *3 {{\n\t\t\ta: 0,1,-3\n\t\t}}\n\t\tGeometryVersion: 124\n\t}}\n"
      "\tModel: 2, \"Model::\", \"Mesh\" {{\n\t\tVersion: 232\n\t}}\n}}\n"
      "Connections:  {{\n\tC: \"OO\",2,0\n\tC: \"OO\",1,2\n}}\n",
      up, sign);
}

TEST_F(Import, FormatsSayWhichAxisPointsUpwards) {
  // The tip is above the base along z.
  const std::string stl =
      "solid s\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid "
      "s\n";
  const std::string off = "OFF\n3 1 0\n0 0 0\n2 0 0\n0 0 1\n3 0 1 2\n";
  const auto is_upright = [](const Model& one) {
    const Mesh& mesh = one.meshes[0];
    return mesh.half_extent.y > 0 && mesh.half_extent.z == 0;
  };
  EXPECT_TRUE(is_upright(model(file("one.stl", stl))));
  EXPECT_TRUE(is_upright(model(file("two.STL", stl))));
  EXPECT_FALSE(is_upright(model(file("three.stl", stl), UpAxis::plus_y))) << "what is asked for counts";
  EXPECT_FALSE(is_upright(model(file("one.off", off)))) << "it says nothing of axes";
  EXPECT_TRUE(is_upright(model(file("z.fbx", fbx(2, 1)))));
  EXPECT_FALSE(is_upright(model(file("y.fbx", fbx(1, 1)))));
}

/// The triangle's base has two corners along x, its tip is above one of them along z.
TEST_F(Import, FbxSaysWhichEndOfItsAxisPointsUpwards) {
  const auto above = [&](int up, int sign) {
    const Model one = model(file("one.fbx", fbx(up, sign)));
    int upper = 0, lower = 0;
    for (const Position& p : one.meshes[0].positions) ++(p.y > 0 ? upper : lower);
    EXPECT_EQ(upper + lower, 3);
    return upper;
  };
  EXPECT_EQ(above(2, 1), 1) << "the tip";
  EXPECT_EQ(above(2, -1), 2) << "the base";
  EXPECT_EQ(above(0, 1), 1) << "the corner along x";
  EXPECT_EQ(above(0, -1), 2);
}

TEST_F(Import, MoreVerticesThanSixteenBits) {
  const std::string obj = sphere_obj(400, 250);
  const std::string path = file("sphere.obj", obj);
  const Model large = model(path);
  EXPECT_GE(large.meshes.size(), 2U);
  std::size_t count = 0;
  for (const Mesh& mesh : large.meshes) {
    EXPECT_LE(mesh.positions.size(), 65535U);
    count += mesh.triangles.size();
    for (const Meshlet& meshlet : mesh.meshlets) {
      EXPECT_LE(meshlet.vertex_count, 64);
      const double largest = std::max({mesh.half_extent.x, mesh.half_extent.y, mesh.half_extent.z});
      for (const Position& p : mesh.positions.subspan(meshlet.first_vertex, meshlet.vertex_count)) {
        const double x = (p.x - meshlet.centre.x) * (mesh.half_extent.x / largest);
        const double y = (p.y - meshlet.centre.y) * (mesh.half_extent.y / largest);
        const double z = (p.z - meshlet.centre.z) * (mesh.half_extent.z / largest);
        ASSERT_LE(std::sqrt(x * x + y * y + z * z), meshlet.radius);
      }
    }
  }
  EXPECT_EQ(count, 2U * 400U * 249U);

  // The same triangles as in the file: quantise the source directly and compare corner by corner.
  const Result<SourceModel> source = read_model(path, UpAxis::plus_y);
  ASSERT_TRUE(source);
  std::multiset<std::array<Point, 3>> expected;
  const Vec3& half = large.meshes[0].half_extent;
  const auto quantised = [&](const SourceVertex& vertex) {
    const auto coordinate = [&](std::size_t axis, Fixed extent) {
      const double scene = (double{vertex.position[axis]} - large.units.origin[axis]) * large.units.scale;
      return static_cast<int>(std::clamp(std::round(scene * 32768 / from_fixed(extent)), -32767.0, 32767.0));
    };
    return Point{coordinate(0, half.x), coordinate(1, half.y), coordinate(2, half.z)};
  };
  for (const SourceMesh& mesh : source->meshes) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      std::array<Point, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) corners[k] = quantised(mesh.vertices[mesh.indices[i + k]]);
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      expected.insert(corners);
    }
  }
  EXPECT_EQ(triangles(large), expected);
}

TEST_F(Import, SharedBordersStayIdentical) {
  file("m.mtl", "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 1 0\n");
  const Model two = model(file("two.obj",
                               "mtllib m.mtl\nv 0 0.1 0\nv 0.7 0.3 0.1\nv 0.2 1 0.37\nv 1 1 1\n"
                               "usemtl a\nf 1 2 3\nusemtl b\nf 3 2 4\n"));
  ASSERT_EQ(two.meshes.size(), 2U);
  EXPECT_EQ(two.meshes[0].half_extent, two.meshes[1].half_extent);
  std::set<Point> first;
  std::set<Point> second;
  for (const Position& p : two.meshes[0].positions) first.insert(point(p));
  for (const Position& p : two.meshes[1].positions) second.insert(point(p));
  std::vector<Point> shared;
  std::set_intersection(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(shared));
  EXPECT_EQ(shared.size(), 2U);
  EXPECT_EQ(two.materials[two.instances[0].material].colour, (Colour{255, 0, 0, 255}));
  EXPECT_EQ(two.materials[two.instances[1].material].colour, (Colour{0, 255, 0, 255}));
}

TEST_F(Import, TrianglesThatAreNotFiniteAreCounted) {
  const Model one =
      model(file("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 0 inf 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n"));
  EXPECT_EQ(one.meshes[0].triangles.size(), 1U);
  ASSERT_EQ(one.warnings.size(), 1U);
  EXPECT_NE(one.warnings[0].find("2 triangles left out"), std::string::npos) << one.warnings[0];
}

TEST_F(Import, NothingLeftIsAnError) {
  EXPECT_NE(failure(file("n.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).find("finite"), std::string::npos);
  EXPECT_NE(failure(file("d.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")).find("area"), std::string::npos);
}

TEST_F(Import, OpenSurfacesOfFilesWithoutSidesHaveBacksOfTheirOwn) {
  const std::string sheet = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";
  const Result<Model> both = import_model(file("sheet.obj", sheet));
  ASSERT_TRUE(both);
  ASSERT_EQ(both->instances.size(), 2U);
  for (const Instance& instance : both->instances) EXPECT_FALSE(both->materials[instance.material].double_sided);
  EXPECT_EQ(both->meshes[0].normals[0].z, -127);
  EXPECT_EQ(both->meshes[1].normals[0].z, 127);
  // A small hole shows too little of the inside.
  const std::string sphere = sphere_obj(16, 16);
  const Result<Model> holed = import_model(file("holed.obj", sphere.substr(0, sphere.rfind("f "))));
  ASSERT_TRUE(holed);
  ASSERT_EQ(holed->instances.size(), 1U);
  EXPECT_TRUE(holed->materials[0].double_sided);
}

TEST_F(Import, ExtremeCoordinates) {
  for (const char* scale : {"1e-30", "1e30", "3e38"}) {
    const std::string s = scale;
    const Model one = model(file("t.obj", "v 0 0 0\nv " + s + " 0 0\nv 0 " + s + " 0\nf 1 2 3\n"));
    EXPECT_EQ(one.meshes[0].triangles.size(), 1U) << scale;
    EXPECT_GE(one.meshes[0].half_extent.x, kFixedOne) << scale;
  }
}

/// Assimp's readers leave these out without a word.
TEST_F(Import, WhatReadersLeaveOutIsSaid) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\n";
  const std::string corners = "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  png("whole.png", 16, 16, 0x1234);
  file("m.mtl", "newmtl a\nmap_Kd whole.png\n");
  const struct {
    std::string name, content, words;  // without words no warning
  } cases[] = {
      {"a.obj", "mtllib gone.mtl\nusemtl a\n" + triangle,
       "gone.mtl' cannot be opened; their surfaces are drawn without them"},
      {"b.OBJ", "mtllib gone.mtl\nusemtl a\n" + triangle,
       "gone.mtl' cannot be opened; their surfaces are drawn without them"},
      {"c.obj", triangle, ""},
      {"d.obj", "mtllib m.mtl\nusemtl a\n" + triangle, ""},
      {"e.ply", ply + corners, ""},
      {"f.ply", ply + "element edge 2\nproperty int vertex1\nproperty int vertex2\n" + corners + "0 1\n1 2\n", ""},
  };
  for (const auto& [name, content, words] : cases) {
    const Model read = model(file(name, content));
    ASSERT_EQ(read.warnings.size(), words.empty() ? 0U : 1U) << name;
    const std::string said = words.empty() ? "" : read.warnings[0];
    EXPECT_NE(said.find(words), std::string::npos) << said;
  }
}

TEST_F(Import, OneLeftOutIsSingular) {
  const Model one = model(file("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nf 1 2 3\nf 1 2 4\n"));
  ASSERT_EQ(one.warnings.size(), 1U);
  EXPECT_EQ(one.warnings[0].rfind("1 triangle left out", 0), 0U) << one.warnings[0];
}

}  // namespace
}  // namespace zstrip::sim::test
