// Model files that are text: their encodings, and lines that readers do not know.
#include "import_fixture.hpp"

#include <map>

#include "import/model_files.hpp"

namespace zstrip::sim::test {
namespace {

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
  for (const char* line : {"aniso 0", "anisor 0", "Pr .5", "Pm 0", "Ps 0 0 0", "Pc", "Pcr x", "map_Pr r.png",
                           "map_Pm m.png", "map_Ps s.png", "Tf spectral a.rfl", "decal t.png", "Ka", "Ni 1,5", "abc"}) {
    file("m.mtl", std::string("newmtl a\n") + line + "\nKd 1 0 0\n" + line + "\n");
    const Model read = model(file("m.obj", "mtllib m.mtl\nusemtl a\n" + kTriangleObj));
    EXPECT_EQ(read.materials[0].colour, (Colour{255, 0, 0, 255})) << line;
    EXPECT_TRUE(read.warnings.empty()) << line;
  }
  for (const auto& [line, words] : std::map<std::string, std::string>{{"map_Ke e.png", "without its emission"},
                                                                      {"Ke 0 0 1", "without its emission"},
                                                                      {"Kd spectral a.rfl", "without its colour"},
                                                                      {"norm -bm 1 n.png", "without: normal maps"},
                                                                      {"map_Bump n.png", "without: normal maps"}}) {
    png("t.png", 2, 2, 0xF800);
    file("m.mtl", "newmtl a\n" + line + "\n");
    const Model read = model(file("m.obj", "mtllib m.mtl\nusemtl a\n" + kTriangleObj));
    ASSERT_EQ(read.warnings.size(), 1U) << line;
    EXPECT_NE(read.warnings[0].find(words), std::string::npos) << read.warnings[0];
  }
}

/// 'parm' was taken for a point.
TEST_F(Import, LinesOfObjThatAreNotDrawnAreSkipped) {
  const Model expected = model(file("e.obj", kTriangleObj));
  const Model read = model(file("m.obj", "cstype bezier\n" + kTriangleObj +
                                             "curv 0 1 1 2 3\nparm u 0 1\nsurf 0 1 0 1 1\nend\nlod 2\nshadow_obj a\n"));
  EXPECT_EQ(triangles(read), triangles(expected));
  EXPECT_TRUE(read.segments.empty());
}

/// A cube of such faces was drawn as points, without a message.
TEST_F(Import, FacesOfObjThatNameTextureCoordinatesWithoutAnyWereLost) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
  const std::string normals = "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 -1\n";
  const Model expected = model(file("e.obj", corners + normals + "f 1//1 2//2 3//3\nf 2//1 4//1 3//1\nl 1 4\n"));
  for (const char* faces : {"f 1/1/1 2/2/2 3/3/3\nf 2/4/1 4/4/1 3/4/1 # back\nl 1/1 4/4\n",
                            "f 1/-1/1 2/-1/2 3/-1/3\nf 2/9/1 4/9/1 3/9/1\nl 1 4\n",
                            "f 1/1/1 2/2/2 3/3/3\nf -3//1 -1//1 -2//1\nl 1/1 4\n"}) {
    const Model read = model(file("m.obj", corners + normals + faces));
    EXPECT_EQ(triangles(read), triangles(expected)) << faces;
    EXPECT_EQ(read.segments.size(), 1U) << faces;
    EXPECT_TRUE(read.warnings.empty()) << faces;
  }
}

TEST_F(Import, TexturesAreFoundInFoldersOfAnotherMachine) {
  std::filesystem::create_directory(path("Tex Dir"));
  png("Tex Dir/My Red.PNG", 2, 2, 0xF800);
  for (const char* name : {"C:\\Users\\x\\tex dir\\my red.png", "tex dir/MY RED.png  ", "/Volumes/x/Tex Dir/My Red.PNG",
                           "./TEX DIR/My red.png", "..\\..\\Tex Dir\\My Red.PNG"}) {
    file("m.mtl", std::string("newmtl a\nmap_Kd ") + name + "\n");
    const Model read = model(file("m.obj",
                                  "mtllib \"m.mtl\"\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                                  "f 1/1 2/2 3/3\n"));
    EXPECT_TRUE(read.warnings.empty()) << name << ": " << read.warnings[0];
    EXPECT_EQ(read.textures.size(), 1U) << name;
  }
}

TEST_F(Import, OptionsOfATextureMoveAndScaleIt) {
  png("two words.png", 2, 2, 0xF800);
  const auto texcoords = [&](const std::string& options) {
    file("m.mtl", "newmtl a\nKd 1 1 1\nmap_Kd " + options + "two words.png\n");
    const Model read = model(file("m.obj",
                                  "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                                  "f 1/1 2/2 3/3\n"));
    EXPECT_TRUE(read.warnings.empty()) << options;
    EXPECT_EQ(read.textures.size(), 1U) << options;
    // Of the extent alone: whole repeats are taken off.
    int low_u = 32767, high_u = -32767, low_v = 32767, high_v = -32767;
    for (const TexCoord& t : read.meshes[0].texcoords) {
      low_u = std::min<int>(low_u, t.u), high_u = std::max<int>(high_u, t.u);
      low_v = std::min<int>(low_v, t.v), high_v = std::max<int>(high_v, t.v);
    }
    const double one = std::ldexp(1.0, read.meshes[0].texcoord_bits);
    return std::array<double, 3>{(high_u - low_u) / one, (high_v - low_v) / one, low_u / one - std::floor(low_u / one)};
  };
  EXPECT_EQ(texcoords(""), (std::array<double, 3>{1, 1, 0}));
  EXPECT_EQ(texcoords("-s 2 3 1 "), (std::array<double, 3>{2, 3, 0}));
  EXPECT_EQ(texcoords("-o .25 0 -S 2 "), (std::array<double, 3>{2, 1, .25}));
  EXPECT_EQ(texcoords("-clamp off -blendu on -mm 0 1 -imfchan r -bm 2 -t 0 0 0 -texres 64 -colorspace sRGB "),
            (std::array<double, 3>{1, 1, 0}));
}

TEST_F(Import, PlacesOfObjFarAwayKeepTheirDigits) {
  const auto square = [](const char* x0, const char* x1, const char* y0, const char* y1) {
    const auto corner = [](const char* x, const char* y) { return std::string("v ") + x + ' ' + y + " 7\n"; };
    return corner(x0, y0) + corner(x1, y0) + corner(x1, y1) + corner(x0, y1) + "f 1 2 3 4\n";
  };
  const Model near = model(file("n.obj", square("0.125", "1.25", "0", "3")));
  const Model far = model(file("f.obj", square("40000000.125", "40000001.25", "-5000003", "-5000000")));
  EXPECT_EQ(triangles(far), triangles(near));
  EXPECT_EQ(far.units.origin, (std::array<double, 3>{40000000.6875, -5000001.5, 7}));
  const Model up = model(path("f.obj"), UpAxis::plus_z);
  EXPECT_EQ(up.units.origin, (std::array<double, 3>{40000000.6875, 7, 5000001.5}));
}

/// Assimp's readers have floats. Georeferenced files were drawn with corners in wrong places, or told to be damaged.
TEST_F(Import, PlacesTooFarAwayForAReaderAreSaid) {
  const auto off = [this](const std::string& digits) {
    std::string text = "OFF\n3 1 0\n";
    for (const char* corner : {"0 5 0", "1 5 0", "0 6 0"}) text += digits + corner + "\n";
    return file("a.off", text + "3 0 1 2\n");
  };
  EXPECT_TRUE(model(off("")).warnings.empty());
  EXPECT_TRUE(model(off("100")).warnings.empty());
  const std::vector<std::string> warnings = model(off("40000")).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("corners rounded by up to 0.024 units"), std::string::npos) << warnings[0];
  const std::string said = failure(off("400000000"));
  EXPECT_NE(said.find("so far from the origin"), std::string::npos) << said;
  // A model without a size was said to be far away, too.
  const std::string point = failure(file("a.off", "OFF\n3 1 0\n1 1 1\n1 1 1\n1 1 1\n3 0 1 2\n"));
  EXPECT_NE(point.find("; if it lies so far"), std::string::npos) << point;
}

/// Files with comments behind faces were refused, and of several files of materials in a line none was found.
TEST_F(Import, CommentsBehindNumbersAndSeveralFilesOfMaterialsAreRead) {
  file("a.mtl", "newmtl a\nKd 1 0 0\n");
  file("b.mtl", "newmtl b\nKd 0 1 0\n");
  file("two words.mtl", "newmtl a\nKd 0 0 1\n");
  const std::string square =
      "v 0 0 0 # a corner\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1 # ahead\nusemtl a\ns off # flat\n"
      "f 1//1 2//1 3//1 4//1 # quad\nusemtl b\nf 4//1 3//1 2//1 1//1#back\nl 1 3 # line\n";
  const Model both = model(file("both.obj", "mtllib a.mtl  b.mtl # ours\n" + square));
  EXPECT_EQ(triangles(both).size(), 4U);
  EXPECT_TRUE(both.warnings.empty()) << both.warnings[0];
  const auto colour_of = [](const Model& model, const std::string& name) {
    const auto at = std::ranges::find(model.material_names, name);
    return at == model.material_names.end()
               ? Colour{}
               : model.materials[static_cast<std::size_t>(at - model.material_names.begin())].colour;
  };
  EXPECT_EQ(colour_of(both, "a"), (Colour{255, 0, 0, 255}));
  EXPECT_EQ(colour_of(both, "b"), (Colour{0, 255, 0, 255}));
  const Model words = model(file("words.obj", "mtllib two words.mtl\n" + square));
  EXPECT_EQ(colour_of(words, "a"), (Colour{0, 0, 255, 255}));
  const Model half = model(file("half.obj", "mtllib a.mtl gone.mtl\n" + square));
  ASSERT_EQ(half.warnings.size(), 1U);
  EXPECT_NE(half.warnings[0].find("gone.mtl' cannot be opened"), std::string::npos) << half.warnings[0];
}

/// They were drawn in grey without a word.
TEST_F(Import, MaterialsOfObjThatAreNotDefinedAreSaid) {
  file("m.mtl", "newmtl a\nKd 1 0 0\n");
  const std::string begin = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
  for (const auto& [more, warning] : std::vector<std::pair<std::string, std::string>>{
           {"usemtl b\n", ""},
           {"usemtl b\nf 3 2 1\n", "material 'b' is not defined; surfaces with it are drawn without"},
           {"usemtl c\nf 3 2 1\nusemtl b\nf 1 2 3\n",
            "material 'b' and 1 more are not defined; surfaces with them are drawn without"}}) {
    const Model read = model(file("m.obj", begin + more));
    EXPECT_EQ(read.warnings, warning.empty() ? std::vector<std::string>{} : std::vector{warning});
  }
}

/// They were drawn in grey without a word.
TEST_F(Import, ATextureOfObjWithoutTextureCoordinatesIsSaid) {
  png("red.png", 2, 2, 0xF800);
  file("m.mtl", "newmtl a\nmap_Kd red.png\n");
  const Model read = model(file("m.obj", "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  EXPECT_EQ(read.warnings, std::vector<std::string>{"1 mesh drawn without a texture: no texture coordinates"});
}

/// Only the straight lines were drawn, without a word.
TEST_F(Import, CurvesOfDxfAreSaid) {
  const std::string line = "0\nLINE\n8\n0\n10\n0\n20\n0\n30\n0\n11\n1\n21\n0\n31\n0\n";
  const std::string arc = "  0\r\nARC\r\n  8\r\n0\r\n 10\r\n0\r\n 20\r\n0\r\n 40\r\n1\r\n";
  const auto with = [&](const std::string& entities) {
    return model(file("m.dxf", "0\nSECTION\n2\nBLOCKS\n" + arc + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + line +
                                   entities + "0\nENDSEC\n0\nEOF\n"));
  };
  EXPECT_TRUE(with("").warnings.empty());
  EXPECT_EQ(with(arc + "0\nSPLINE\n" + arc).warnings,
            std::vector<std::string>{"3 elements of DXF left out: only faces and straight lines are drawn"});
}

/// Assimp makes vertices without a colour transparent black.
TEST_F(Import, AmfWithoutColoursWasBlack) {
  const auto colours = [&](const std::string& of_object, const std::string& of_triangle) {
    std::string vertices;
    for (const char* place : {"<x>0</x><y>0</y><z>0</z>", "<x>1</x><y>0</y><z>0</z>", "<x>0</x><y>1</y><z>0</z>"}) {
      vertices += std::string("<vertex><coordinates>") + place + "</coordinates></vertex>";
    }
    const Model read = model(file("m.amf", R"(<?xml version="1.0" encoding="utf-8"?><amf><object id="1">)" + of_object +
                                               "<mesh><vertices>" + vertices +
                                               "</vertices><volume><triangle><v1>0</v1><v2>1</v2><v3>2</v3>" +
                                               of_triangle + "</triangle></volume></mesh></object></amf>"));
    std::set<std::array<int, 3>> found;
    for (const Mesh& mesh : read.meshes) {
      for (const Colour& c : mesh.colours) found.insert({c.r, c.g, c.b});
    }
    if (found.empty()) {
      const Colour c = read.materials[read.instances[0].material].colour;
      found.insert({c.r, c.g, c.b});
    }
    return found;
  };
  const std::set<std::array<int, 3>> red{std::array{255, 0, 0}}, black{std::array{0, 0, 0}};
  EXPECT_NE(colours("", ""), black);
  EXPECT_EQ(colours("<color><r>1</r><g>0</g><b>0</b></color>", ""), red);
  EXPECT_EQ(colours("<color><r>0</r><g>0</g><b>0</b></color>", ""), black);
  EXPECT_EQ(colours("", "<color><r>1</r><g>0</g><b>0</b></color>"), red);
}

/// The reader crashed where a face took several lines.
TEST_F(Import, NumbersOfOffMayStandOnAnyLines) {
  const Model expected = model(file("e.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"));
  ASSERT_FALSE(triangles(expected).empty());
  for (const char* off : {"OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3\n0\n1\n2\n3\n0\n2\n3\n\n",
                          "OFF 4 2\r\n0 # counts\r\n0 0 0 1 0 0\r\n1 1 0\r\n0 1\r\n0 3 0 1 2 3 0 2 3"}) {
    EXPECT_EQ(triangles(model(file("m.off", off))), triangles(expected)) << off;
  }
  const Model coloured =
      model(file("c.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n"));
  EXPECT_EQ(triangles(coloured), triangles(expected));
}

/// Of several groups one was read, and pointers to nothing followed.
TEST_F(Import, GroupsOfRaw) {
  const Model model = this->model(file("groups.RAW",
                                       "First\n1 0 0 0 0 0 0 1 0 1 0 0\n1 0 0 0 0 3 0 1 3 1 0 3\n\n"
                                       "Second one\n0 0 1 3 0 0 0 4 0 1 3 0\n\t+0 0 1 3 3 0 0 4 3 1 3 3"));
  EXPECT_EQ(triangles(model).size(), 4U);
  EXPECT_TRUE(model.warnings.empty());
}

}  // namespace
}  // namespace zstrip::sim::test
