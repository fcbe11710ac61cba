// Textures, texture coordinates and colours of imported models.
#include "import_fixture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "import/read_model.hpp"

namespace zstrip::sim::test {
namespace {

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

/// They were left out without a word, as those of glTF and OBJ are not.
TEST_F(Import, MapsOfColladaThatAreNotDrawnAreSaid) {
  EXPECT_TRUE(model(file("plain.dae", collada_triangle(""))).warnings.empty());
  const Model glows =
      model(file("glows.dae", collada_triangle(R"(<emission><texture texture="t" texcoord="c"/></emission>)")));
  EXPECT_EQ(glows.warnings, std::vector<std::string>{"drawn without: emission maps"});
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

}  // namespace
}  // namespace zstrip::sim::test
