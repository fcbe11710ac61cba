// The whole import: what comes out is a scene that the renderer takes, and the same surface as in the file.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <map>
#include <set>
#include <thread>

#include "image/encode.hpp"
#include "import/crash_guard.hpp"
#include "import/model.hpp"
#include "import/model_files.hpp"
#include "import/quantise.hpp"
#include "import/read_model.hpp"
#include "support.hpp"
#include "text/step_report.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip::sim::test {
namespace {

class Import : public FolderTest {
 protected:
  Model model(const std::string& path, std::optional<UpAxis> up = {},
              Texcoords texcoords = Texcoords::of_textures) const {
    Result<Model> imported = import_model(path, up, texcoords, BackFaces::as_front);
    EXPECT_TRUE(imported) << imported.failure().message;
    const Scene scene{.meshes = imported->meshes,
                      .materials = imported->materials,
                      .textures = imported->textures,
                      .instances = imported->instances,
                      .lights = imported->lights};
    EXPECT_TRUE(validate(scene));
    return std::move(*imported);
  }
  std::string failure(const std::string& path) const {
    const Result<Model> imported = import_model(path);
    EXPECT_FALSE(imported);
    if (imported) return "";
    EXPECT_EQ(imported.failure().status, ExitStatus::input);
    EXPECT_NE(imported.failure().message.find(path), std::string::npos);
    return imported.failure().message;
  }
  /// A PNG of one colour (RGB565).
  void png(const std::string& name, std::uint16_t width, std::uint16_t height, std::uint16_t colour) const {
    std::vector<std::byte> pixels;
    for (int i = 0; i < width * height; ++i) {
      pixels.push_back(static_cast<std::byte>(colour & 0xFF));
      pixels.push_back(static_cast<std::byte>(colour >> 8));
    }
    const auto bytes = encode(ImageType::png, {width, height, PixelFormat::rgb565}, pixels);
    ASSERT_TRUE(bytes);
    file(name, std::string(bytes->begin(), bytes->end()));
  }
};

using Point = std::array<int, 3>;

Point point(const Position& p) { return {p.x, p.y, p.z}; }

/// The corners of all triangles of a model, each triangle rotated so that its smallest corner comes first.
std::multiset<std::array<Point, 3>> triangles(const Model& model) {
  std::multiset<std::array<Point, 3>> result;
  for (const Mesh& mesh : model.meshes) {
    for (const Triangle& t : mesh.triangles) {
      std::array<Point, 3> corners{point(mesh.positions[t.a]), point(mesh.positions[t.b]), point(mesh.positions[t.c])};
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      result.insert(corners);
    }
  }
  return result;
}

/// A model of 4.5 million triangles gave no sign of life for 91 s.
TEST_F(Import, TellsWhatItIsDoing) {
  file("cube.obj", cube_obj());
  testing::internal::CaptureStderr();
  {
    const StepReport report(true, std::chrono::milliseconds{0});
    model(path("cube.obj"));
  }
  model(path("cube.obj"));
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "zstrip: reading 'cube.obj', 0 s\nzstrip: finding the surfaces of 'cube.obj', 0 s\n"
            "zstrip: merging the vertices of 'cube.obj', 0 s\nzstrip: quantising the vertices, 0 s\n"
            "zstrip: cutting the model into meshlets, 0 s\n");
}

/// The thread that reports must not need the one that works.
TEST(StepReport, TellsAStepThatTakesLong) {
  testing::internal::CaptureStderr();
  {
    const StepReport report(true, std::chrono::milliseconds{20});
    tell_step("waiting");
    std::this_thread::sleep_for(std::chrono::seconds{1});
  }
  EXPECT_NE(testing::internal::GetCapturedStderr().find("zstrip: waiting, "), std::string::npos);
  testing::internal::CaptureStderr();
  {
    const StepReport report(false, std::chrono::milliseconds{0});
    tell_step("waiting");
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

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

TEST_F(Import, TexturesOfOddSizes) {
  png("picture.png", 3, 5, 0xF800);
  file("m.mtl", "newmtl a\nKd 1 1 1\nmap_Kd picture.png\n");
  const Model textured = model(
      file("t.obj", "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n"));
  ASSERT_EQ(textured.textures.size(), 1U);
  EXPECT_EQ(textured.textures[0].log2_width, 2);
  EXPECT_EQ(textured.textures[0].log2_height, 3);
  for (const std::uint16_t texel : textured.textures[0].texels) EXPECT_EQ(texel, 0xF800);
  EXPECT_EQ(textured.materials[0].texture, 0);
  // v grows downwards: the corner with the file's (0, 0) is at the lower left of the texture.
  const Mesh& mesh = textured.meshes[0];
  for (std::size_t i = 0; i < 3; ++i) {
    if (mesh.positions[i].x < 0 && mesh.positions[i].y < 0) {
      EXPECT_EQ(mesh.texcoords[i].u, 0);
      EXPECT_EQ(mesh.texcoords[i].v, 1 << mesh.texcoord_bits);
    }
  }
}

TEST_F(Import, MissingAndDamagedTexturesAreWarnings) {
  png("whole.png", 16, 16, 0x1234);
  file("half.png", read(path("whole.png")).substr(0, 60));
  for (const char* name : {"missing.png", "half.png", ".", "/dev/zero"}) {
    file("m.mtl", std::string("newmtl a\nKd 1 0 0\nmap_Kd ") + name + "\n");
    const Model plain = model(
        file("t.obj", "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n"));
    EXPECT_TRUE(plain.textures.empty()) << name;
    EXPECT_EQ(plain.materials[0].texture, kNoTexture) << name;
    ASSERT_EQ(plain.warnings.size(), 1U) << name;
    EXPECT_NE(plain.warnings[0].find("texture"), std::string::npos);
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
       "gone.mtl' cannot be opened; what uses them is drawn without"},
      {"b.OBJ", "mtllib gone.mtl\nusemtl a\n" + triangle,
       "gone.mtl' cannot be opened; what uses them is drawn without"},
      {"c.obj", triangle, ""},
      {"d.obj", "mtllib m.mtl\nusemtl a\n" + triangle, ""},
      {"e.ply", ply + corners, ""},
      {"f.ply", ply + "element edge 2\nproperty int vertex1\nproperty int vertex2\n" + corners + "0 1\n1 2\n",
       "2 edges left out: edges of PLY are not read; write faces"},
  };
  for (const auto& [name, content, words] : cases) {
    const Model read = model(file(name, content));
    ASSERT_EQ(read.warnings.size(), words.empty() ? 0U : 1U) << name;
    const std::string said = words.empty() ? "" : read.warnings[0];
    EXPECT_NE(said.find(words), std::string::npos) << said;
  }
}

TEST_F(Import, VertexColoursReplaceTheMaterial) {
  const Model coloured = model(file("c.ply",
                                    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                    "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
                                    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                                    "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n"));
  ASSERT_EQ(coloured.meshes[0].colours.size(), 3U);
  EXPECT_EQ(coloured.materials[0].colour, (Colour{255, 255, 255, 255}));
  int sum = 0;
  for (const Colour& c : coloured.meshes[0].colours) sum += c.r + c.g + c.b;
  EXPECT_EQ(sum, 3 * 255);
}

TEST_F(Import, TexturesAreLoweredUntilTheirRepeatsFit) {
  png("wide.png", 2048, 16, 0x07E0);
  file("m.mtl", "newmtl a\nKd 1 1 1\nmap_Kd wide.png\n");
  const std::string start = "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  for (const auto& [repeats, width] : {std::pair{20, 2048}, std::pair{40, 1024}, std::pair{100, 512}}) {
    const std::string u = std::to_string(repeats);
    const Model model = this->model(
        file("quad.obj", start + "vt 0 0\nvt " + u + " 0\nvt " + u + " 1\nvt 0 1\n" + "f 1/1 2/2 3/3 4/4\n"));
    ASSERT_EQ(model.textures.size(), 1U);
    EXPECT_EQ(1 << model.textures[0].log2_width, width);
    EXPECT_EQ(1 << model.textures[0].log2_height, 16);
    EXPECT_EQ(model.warnings.size(), width == 2048 ? 0U : 1U);
    if (width < 2048) {
      EXPECT_NE(model.warnings.at(0).find("1 texture lowered"), std::string::npos);
    }
    const Mesh& mesh = model.meshes[0];
    for (const TexCoord& t : mesh.texcoords) {
      EXPECT_LT(std::abs(std::ldexp(t.u, model.textures[0].log2_width - mesh.texcoord_bits)), 32768);
    }
  }
}

TEST_F(Import, BordersOfTexturesOfOtherFormats) {
  png("a.png", 4, 4, 0x1234);
  file("q.mtl", "newmtl r\nmap_Kd a.png\nnewmtl c\nmap_Kd -clamp on a.png\n");
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
  const Result<SourceModel> read =
      read_model(file("q.obj", "mtllib q.mtl\n" + corners + "usemtl r\nf 1/1 2/2 3/3\nusemtl c\nf 1/1 2/2 3/3\n"), {});
  ASSERT_TRUE(read);
  std::map<std::string, std::array<TextureWrap, 2>> wraps;
  for (const SourceMaterial& material : read->materials) wraps[material.name] = material.wrap;
  EXPECT_EQ(wraps["r"], (std::array{TextureWrap::repeat, TextureWrap::repeat}));
  EXPECT_EQ(wraps["c"], (std::array{TextureWrap::clamp, TextureWrap::clamp}));
}

TEST_F(Import, TexturesInOtherCase) {
  png("test.png", 4, 4, 0xF800);
  for (const char* name : {"TEST.PNG", "Test.png", "C:\\Pictures\\TEST.png"}) {
    file("m.mtl", std::string("newmtl a\nKd 1 1 1\nmap_Kd ") + name + "\n");
    const Model textured = model(
        file("t.obj", "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n"));
    EXPECT_EQ(textured.textures.size(), 1U) << name;
    EXPECT_TRUE(textured.warnings.empty()) << name;
  }
}

TEST_F(Import, TexcoordsWithoutATextureAreKeptForOneThatComesLater) {
  const std::string path = file("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 3 0\nvt 0 1\nf 1/1 2/2 3/3\n");
  EXPECT_TRUE(model(path).meshes[0].texcoords.empty());
  const Model kept = model(path, UpAxis::plus_y, Texcoords::all);
  ASSERT_EQ(kept.meshes[0].texcoords.size(), 3U);
  std::vector<double> across;
  for (const TexCoord& t : kept.meshes[0].texcoords) across.push_back(std::ldexp(t.u, -kept.meshes[0].texcoord_bits));
  std::ranges::sort(across);
  EXPECT_EQ(across[2] - across[0], 3);
  EXPECT_TRUE(kept.textures.empty());
  EXPECT_EQ(kept.materials[0].texture, kNoTexture);
  const std::string none = file("n.obj", kTriangleObj);
  EXPECT_TRUE(model(none, UpAxis::plus_y, Texcoords::all).meshes[0].texcoords.empty());
}

TEST_F(Import, OneLeftOutIsSingular) {
  const Model one = model(file("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nf 1 2 3\nf 1 2 4\n"));
  ASSERT_EQ(one.warnings.size(), 1U);
  EXPECT_EQ(one.warnings[0].rfind("1 triangle left out", 0), 0U) << one.warnings[0];
}

std::string utf16(std::u16string_view text, bool big_endian) {
  std::string bytes = big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for (const char16_t unit : text) {
    const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 255);
    bytes += big_endian ? high : low;
    bytes += big_endian ? low : high;
  }
  return bytes;
}

/// Models in UTF-16 were refused as damaged, or as without triangles.
TEST_F(Import, TextsInUtf16AreThoseInUtf8) {
  const Model expected = model(file("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  for (const bool big_endian : {false, true}) {
    file("m.mtl", utf16(u"newmtl r\u00F6t\u20AC\U0001F600\nKd 1 0 0\n", big_endian));
    const Model read = model(file("m.obj", utf16(u"mtllib m.mtl\nusemtl r\u00F6t\u20AC\U0001F600\r\nv 0 0 0\nv 1 0 0\n"
                                                 u"v 0 1 0\nf 1 2 3\n",
                                                 big_endian)));
    ASSERT_EQ(read.meshes.size(), 1U);
    EXPECT_EQ(triangles(read), triangles(expected));
    EXPECT_EQ(read.material_names[read.instances[0].material], "r\u00F6t\u20AC\U0001F600");
    EXPECT_EQ(read.materials[read.instances[0].material].colour.r, 255);
    EXPECT_TRUE(read.warnings.empty());
  }
  EXPECT_EQ(as_utf8(std::string("\xFF\xFE\x00\xD8\x41\x00\x42", 7)), "\uFFFDA") << "half a pair, half a unit";
  EXPECT_EQ(as_utf8("\xFF"), "\xFF");
}

/// The mark was taken for the first word of the file: its line was skipped, or the file refused.
TEST_F(Import, TextsMayBeginWithAByteOrderMark) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string stl =
      "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
      "endsolid s\n";
  for (const auto& [name, text] : std::map<std::string, std::string>{{"m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
                                                                     {"m.ply", ply},
                                                                     {"m.stl", stl},
                                                                     {"m.off",
                                                                      "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n"
                                                                      "3 0 1 2\n"}}) {
    const Model expected = model(file(name, text), UpAxis::plus_y);
    const Model read = model(file(name, "\xEF\xBB\xBF" + text), UpAxis::plus_y);
    EXPECT_EQ(triangles(read), triangles(expected)) << name;
    EXPECT_TRUE(read.warnings.empty()) << name;
  }
  file("m.mtl", "\xEF\xBB\xBFnewmtl a\nKd 1 0 0\n");
  const Model red = model(file("m.obj", "mtllib m.mtl\nusemtl a\n" + kTriangleObj));
  EXPECT_EQ(red.materials[0].colour, (Colour{255, 0, 0, 255}));
  EXPECT_EQ(as_utf8(std::string("\xEF\xBB\xBF\0", 4)).size(), 4U) << "bytes, not text";
}

/// Colours of Blender were taken for those of the screen, and were nearly black.
TEST_F(Import, DiffuseColoursAreLinearWhereAFileSaysBlender) {
  const auto colour = [&](const std::string& obj, const std::string& mtl) {
    file("m.mtl", mtl + "newmtl a\nKd 0.5 0 1\n");
    return model(file("m.obj", obj + "mtllib m.mtl\nusemtl a\n" + kTriangleObj)).materials[0].colour;
  };
  const Colour linear{188, 0, 255, 255}, of_screen{128, 0, 255, 255};
  EXPECT_EQ(colour("", ""), of_screen);
  EXPECT_EQ(colour("# Made for Blender\n", "# by hand\n"), of_screen);
  EXPECT_EQ(colour("# Blender 4.1.0\n# www.blender.org\n", ""), linear);
  EXPECT_EQ(colour("# Blender v2.79 (sub 0) OBJ File: ''\r\n", ""), linear);
  EXPECT_EQ(colour("", "\n# Blender MTL File: 'None'\n"), linear);
  EXPECT_EQ(colour("", "newmtl b\n# Blender\n"), of_screen) << "no comment of the file";
}

/// Only what is drawn is read of them: any other line refused the model.
TEST_F(Import, LinesOfMtlThatAreNotKnownAreSkipped) {
  for (const char* line :
       {"aniso 0", "anisor 0", "Pr .5", "Pm 0", "Ps 0 0 0", "Pc", "Pcr x", "norm -bm 1 n.png", "map_Pr r.png",
        "map_Pm m.png", "map_Ps s.png", "d -halo 0.5", "Tf spectral a.rfl", "decal t.png", "Ka", "Ni 1,5", "abc"}) {
    file("m.mtl", std::string("newmtl a\n") + line + "\nKd 1 0 0\n" + line + "\n");
    const Model read = model(file("m.obj", "mtllib m.mtl\nusemtl a\n" + kTriangleObj));
    EXPECT_EQ(read.materials[0].colour, (Colour{255, 0, 0, 255})) << line;
    EXPECT_TRUE(read.warnings.empty()) << line;
  }
  for (const auto& [line, words] : std::map<std::string, std::string>{{"map_Ke e.png", "without its emission"},
                                                                      {"Ke 0 0 1", "without its emission"},
                                                                      {"Kd spectral a.rfl", "without its colour"},
                                                                      {"map_Kd -s 2 2 1 t.png", "-s and -o"}}) {
    png("t.png", 2, 2, 0xF800);
    file("m.mtl", "newmtl a\n" + line + "\n");
    const Model read = model(file("m.obj", "mtllib m.mtl\nusemtl a\n" + kTriangleObj));
    ASSERT_EQ(read.warnings.size(), 1U) << line;
    EXPECT_NE(read.warnings[0].find(words), std::string::npos) << read.warnings[0];
  }
}

/// Of several groups one was read, and pointers to nothing followed.
TEST_F(Import, GroupsOfRaw) {
  const Model model = this->model(file("groups.RAW",
                                       "First\n1 0 0 0 0 0 0 1 0 1 0 0\n1 0 0 0 0 3 0 1 3 1 0 3\n\n"
                                       "Second one\n0 0 1 3 0 0 0 4 0 1 3 0\n\t+0 0 1 3 3 0 0 4 3 1 3 3"));
  EXPECT_EQ(triangles(model).size(), 4U);
  EXPECT_TRUE(model.warnings.empty());
}

using CrashGuardDeathTest = Import;

TEST_F(CrashGuardDeathTest, EndsALoopAfterItsTime) {
  const auto loop = [] {
    const CrashGuard guard("crashed", "took too long", std::chrono::seconds{1}, ~std::uint64_t{0});
    while (std::clock() >= 0) {
    }
  };
  EXPECT_EXIT(loop(), ::testing::ExitedWithCode(4), "^took too long\n$");
}

TEST_F(CrashGuardDeathTest, LiftedLimitsLetWorkGoOn) {
  const auto work = [] {
    CrashGuard guard("crashed", "took too long", std::chrono::seconds{1}, 1);
    guard.lift_limits();
    const std::clock_t begin = std::clock();
    while (std::clock() - begin < 2 * CLOCKS_PER_SEC) {
    }
    const std::vector<char> memory(std::size_t{64} << 20);
    std::_Exit(memory.back());
  };
  EXPECT_EXIT(work(), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace zstrip::sim::test
