// Alpha of materials and of their maps in OBJ, FBX and Collada.
#include <fmt/format.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gltf_file.hpp"
#include "import/read_model.hpp"
#include "import_fixture.hpp"

namespace zstrip::sim::test {
namespace {

using ModeAndAlpha = std::pair<AlphaMode, int>;
constexpr ModeAndAlpha kSolid{AlphaMode::opaque, 255}, kHidden{AlphaMode::blend, 0}, kMasked{AlphaMode::mask, 255},
    kSmooth{AlphaMode::blend, 255};

constexpr ModeAndAlpha blended(int alpha) { return {AlphaMode::blend, alpha}; }

class ImportAlpha : public Import {
 protected:
  SourceModel source(const std::string& path) const {
    Result<SourceModel> model = read_model(path, {});
    EXPECT_TRUE(model) << model.failure().message;
    return model ? std::move(*model) : SourceModel{};
  }
  /// A triangle of material a, and one of material b if there is one.
  SourceModel obj(const std::string& mtl) const {
    file("m.mtl", mtl);
    const std::string second = mtl.find("newmtl b") == std::string::npos ? "" : "usemtl b\nf 1/1 2/2 3/3\n";
    return source(file("m.obj",
                       "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\n"
                       "f 1/1 2/2 3/3\n" +
                           second));
  }
  void grey_png(const std::string& name, std::uint32_t width, std::uint32_t height,
                const std::vector<std::uint8_t>& values) const {
    std::vector<std::uint8_t> rgba;
    for (const std::uint8_t value : values) rgba.insert(rgba.end(), {value, value, value, 255});
    file(name, rgba_png(width, height, rgba));
  }
};

const SourceMaterial& material(const SourceModel& model, const std::string& name = "a") {
  const auto found = std::ranges::find(model.materials, name, &SourceMaterial::name);
  EXPECT_NE(found, model.materials.end()) << name;
  return found == model.materials.end() ? model.materials.front() : *found;
}

ModeAndAlpha alpha(const SourceMaterial& material) { return {material.alpha_mode, material.alpha}; }

std::vector<std::uint8_t> texels_alpha(const SourceModel& model) {
  const std::uint32_t texture = material(model).texture;
  return texture < model.textures.size() ? model.textures[texture].alpha : std::vector<std::uint8_t>{};
}

TEST_F(ImportAlpha, FactorsOfMtl) {
  for (const auto& [lines, expected] : std::map<std::string, ModeAndAlpha>{{"", kSolid},
                                                                           {"d 1", kSolid},
                                                                           {"Tr 0", kSolid},
                                                                           {"d 0.4", blended(102)},
                                                                           {"d .4", blended(102)},
                                                                           {"d -halo 0.4", blended(102)},
                                                                           {"Tr 0.6", blended(102)},
                                                                           {"Tr 1\nd 0.4", blended(102)},
                                                                           {"d 0.4\nTr 1", blended(102)},
                                                                           {"d 1\nTr 1", kSolid},
                                                                           {"d 7", kSolid},
                                                                           {"d -1", kSolid},
                                                                           {"d nan", kSolid},
                                                                           {"d", kSolid}}) {
    const SourceModel model = obj("newmtl a\nKd 1 0 0\n" + lines + "\n");
    EXPECT_EQ(alpha(material(model)), expected) << lines;
    EXPECT_TRUE(model.warnings.empty()) << lines;
  }
}

TEST_F(ImportAlpha, MapsBecomeTheAlphaOfTheTexture) {
  png("colour.png", 2, 2, 0xF800);
  grey_png("mask.png", 2, 2, {0, 255, 255, 0});
  grey_png("smooth.png", 2, 2, {0, 64, 128, 255});
  grey_png("white.png", 2, 2, {255, 255, 255, 255});
  file("own.png", rgba_png(2, 1, {9, 9, 9, 0, 255, 255, 255, 255}));
  const auto with = [&](const std::string& lines) { return obj("newmtl a\n" + lines + "\n"); };
  const SourceModel masked = with("map_Kd colour.png\nmap_d mask.png");
  EXPECT_EQ(alpha(material(masked)), kMasked);
  EXPECT_EQ(texels_alpha(masked), (std::vector<std::uint8_t>{0, 255, 255, 0}));
  EXPECT_EQ(masked.textures[material(masked).texture].rgb[0], 255) << "colours stay";
  EXPECT_EQ(masked.textures[material(masked).texture].rgb[1], 0);
  EXPECT_TRUE(masked.warnings.empty());
  const SourceModel smooth = with("map_Kd colour.png\nmap_d -clamp on -imfchan l smooth.png");
  EXPECT_EQ(alpha(material(smooth)), kSmooth);
  EXPECT_EQ(texels_alpha(smooth), (std::vector<std::uint8_t>{0, 64, 128, 255}));
  EXPECT_EQ(alpha(material(with("map_Kd colour.png\nmap_d white.png"))), kSolid);
  EXPECT_EQ(alpha(material(with("map_Kd colour.png\nmap_d mask.png\nd 0.4"))), blended(102));
  EXPECT_EQ(alpha(material(with("map_Kd colour.png\nmap_d mask.png\nd 0"))), kMasked) << "the map replaces 0";
  // If the map is the base texture itself, its alpha counts, not its luminance. Without map_d it has no effect.
  const SourceModel own = with("map_Kd own.png\nmap_d OWN.png");
  EXPECT_EQ(alpha(material(own)), kMasked);
  EXPECT_EQ(texels_alpha(own), (std::vector<std::uint8_t>{0, 255}));
  EXPECT_EQ(alpha(material(with("map_Kd colour.png\nmap_d colour.png"))), kSolid);
  EXPECT_EQ(alpha(material(with("map_Kd own.png"))), kSolid);
  // A picture of its own with alpha: that alpha.
  EXPECT_EQ(texels_alpha(with("map_Kd colour.png\nmap_d own.png")), (std::vector<std::uint8_t>{0, 255, 0, 255}));
}

TEST_F(ImportAlpha, SizesOfMapsMayDiffer) {
  png("colour.png", 2, 2, 0xF800);
  grey_png("large.png", 4, 2, {0, 0, 255, 255, 0, 0, 255, 255});
  grey_png("small.png", 1, 2, {0, 255});
  EXPECT_EQ(texels_alpha(obj("newmtl a\nmap_Kd colour.png\nmap_d large.png\n")),
            (std::vector<std::uint8_t>{0, 255, 0, 255}));
  EXPECT_EQ(texels_alpha(obj("newmtl a\nmap_Kd colour.png\nmap_d small.png\n")),
            (std::vector<std::uint8_t>{0, 0, 255, 255}));
}

TEST_F(ImportAlpha, AMapNeedsNoTextureOfColours) {
  grey_png("mask.png", 2, 1, {0, 255});
  const SourceModel model = obj("newmtl a\nKd 0 0 1\nmap_d mask.png\n");
  EXPECT_EQ(alpha(material(model)), kMasked);
  EXPECT_EQ(material(model).colour, (std::array<std::uint8_t, 3>{0, 0, 255}));
  EXPECT_EQ(model.textures[material(model).texture].rgb, (std::vector<std::uint8_t>(6, 255)));
  const SourceModel missing = obj("newmtl a\nKd 0 0 1\nmap_d gone.png\n");
  EXPECT_EQ(alpha(material(missing)), kSolid);
  ASSERT_EQ(missing.warnings.size(), 1U);
  EXPECT_NE(missing.warnings[0].find("gone.png"), std::string::npos);
}

/// Some exporters write transparency in place of alpha: 0 for opaque materials.
TEST_F(ImportAlpha, AlphaIsReversedInFilesWithoutAnOpaqueMaterial) {
  grey_png("black.png", 1, 1, {0});
  for (const char* mtl : {"newmtl a\nKd 1 0 0\nd 0\n", "newmtl a\nTr 1\nnewmtl b\nTr 1.0\n",
                          "newmtl a\nd 0\nnewmtl b\nmap_d black.png\n", "newmtl a\nd 0\nnewmtl unused\nd 1\n"}) {
    const SourceModel model = obj(mtl);
    EXPECT_EQ(alpha(material(model)), kSolid) << mtl;
    ASSERT_EQ(model.warnings.size(), 1U) << mtl;
    EXPECT_NE(model.warnings[0].find("drawn with 1 - alpha"), std::string::npos) << model.warnings[0];
  }
  const SourceModel window = obj("newmtl a\nd 0\nnewmtl b\nd 0.4\n");
  EXPECT_EQ(alpha(material(window)), kSolid);
  EXPECT_EQ(alpha(material(window, "b")), blended(153));
  EXPECT_EQ(window.warnings.size(), 1U);
  const SourceModel glass = obj("newmtl a\nd 0.2\nnewmtl b\nd 0.4\n");
  EXPECT_EQ(alpha(material(glass)), blended(51));
  EXPECT_TRUE(glass.warnings.empty());
  const SourceModel one = obj("newmtl a\nd 0\nnewmtl b\nd 1\n");
  EXPECT_EQ(alpha(material(one)), kHidden);
  EXPECT_TRUE(one.warnings.empty());
}

TEST_F(ImportAlpha, KindsOfCollada) {
  const auto transparent = [](const char* opaque, const char* colour) {
    return fmt::format("<transparent{}><color>{}</color></transparent>", opaque, colour);
  };
  const auto transparency = [](const char* value) {
    return fmt::format("<transparency><float>{}</float></transparency>", value);
  };
  const std::map<std::string, ModeAndAlpha> expected{
      {"", kSolid},
      {transparency("0.4"), blended(102)},
      {transparent("", "1 1 1 0.4"), blended(102)},
      {transparent(R"( opaque="A_ONE")", "1 1 1 0.8") + transparency("0.5"), blended(102)},
      {transparent(R"( opaque="A_ONE")", "0 0 0 1") + transparency("1"), kSolid},
      {transparent(R"( opaque="RGB_ZERO")", "0.6 0.6 0.6 1") + transparency("1"), blended(102)},
      {transparent(R"( opaque="RGB_ZERO")", "0 0 0 1") + transparency("1"), kSolid},
      {transparent(R"( opaque="RGB_ZERO")", "1 1 1 1") + transparency("0"), kSolid},
      {transparency("0"), kSolid},  // with the warning of AlphaIsReversedInFilesWithoutAnOpaqueMaterial
  };
  for (const auto& [effect, of_material] : expected) {
    const SourceModel model = source(file("m.dae", collada_triangle(effect)));
    EXPECT_EQ(alpha(material(model, "m")), of_material) << effect;
    EXPECT_EQ(model.warnings.size(), effect == transparency("0") ? 1U : 0U) << effect;
  }
}

TEST_F(ImportAlpha, MapsOfCollada) {
  grey_png("mask.png", 2, 2, {0, 255, 255, 0});
  grey_png("smooth.png", 2, 2, {0, 64, 128, 255});
  file("own.png", rgba_png(2, 1, {9, 9, 9, 0, 255, 255, 255, 255}));
  const auto with = [&](const std::string& opaque, const char* picture) {
    return source(file(
        "m.dae",
        collada_triangle("<transparent" + opaque + R"(><texture texture="t" texcoord="c"/></transparent>)", picture)));
  };
  const auto texels = [](const SourceModel& model) { return model.textures.at(material(model, "m").texture).alpha; };
  for (const char* opaque : {"", R"( opaque="A_ONE")", R"( opaque="RGB_ONE")"}) {
    const SourceModel masked = with(opaque, "mask.png"), smooth = with(opaque, "smooth.png");
    EXPECT_EQ(alpha(material(masked, "m")), kMasked) << opaque;
    EXPECT_EQ(texels(masked), (std::vector<std::uint8_t>{0, 255, 255, 0})) << opaque;
    EXPECT_EQ(material(masked, "m").colour, (std::array<std::uint8_t, 3>{255, 0, 0})) << opaque;
    EXPECT_EQ(alpha(material(smooth, "m")), kSmooth) << opaque;
    EXPECT_EQ(texels(smooth), (std::vector<std::uint8_t>{0, 64, 128, 255})) << opaque;
    EXPECT_TRUE(masked.warnings.empty()) << opaque;
  }
  EXPECT_EQ(texels(with(R"( opaque="A_ONE")", "own.png")), (std::vector<std::uint8_t>{0, 255})) << "its own alpha";
  const SourceModel inverted = with(R"( opaque="RGB_ZERO")", "smooth.png");
  EXPECT_EQ(alpha(material(inverted, "m")), kSmooth) << "white is transparent";
  EXPECT_EQ(texels(inverted), (std::vector<std::uint8_t>{255, 191, 127, 0}));
}

/// An FBX of one triangle, written by hand. `maps`: pictures, and the properties of the material that each of them
/// sets.
std::string fbx_triangle(const std::string& properties,
                         const std::vector<std::pair<std::string, std::string>>& maps = {}) {
  std::string textures, connections;
  for (const auto& [picture, property] : maps) {
    const std::size_t number = 10 + connections.size();
    textures += fmt::format(
        "Texture: {0}, \"Texture::t\", \"\" {{\nType: \"TextureVideoClip\"\nVersion: 202\n"
        "TextureName: \"Texture::t\"\nFileName: \"{1}\"\nRelativeFilename: \"{1}\"\n}}\n",
        number, picture);
    connections += fmt::format("C: \"OP\",{},3, \"{}\"\n", number, property);
  }
  return "; FBX 7.3.0 project file\nFBXHeaderExtension:  {\nFBXHeaderVersion: 1003\nFBXVersion: 7300\n}\n"
         "GlobalSettings:  {\nVersion: 1000\nProperties70:  {\nP: \"UpAxis\", \"int\", \"Integer\", \"\",1\n}\n}\n"
         "Objects:  {\nGeometry: 1, \"Geometry::g\", \"Mesh\" {\nVertices: *9 {\na: 0,0,0,1,0,0,0,1,0\n}\n"
         "PolygonVertexIndex: *3 {\na: 0,1,-3\n}\nLayerElementMaterial: 0 {\nVersion: 101\nName: \"\"\n"
         "MappingInformationType: \"AllSame\"\nReferenceInformationType: \"IndexToDirect\"\nMaterials: *1 {\na: 0\n}\n"
         "}\nLayerElementUV: 0 {\nVersion: 101\nName: \"\"\nMappingInformationType: \"ByPolygonVertex\"\n"
         "ReferenceInformationType: \"Direct\"\nUV: *6 {\na: 0,0,1,0,0,1\n}\n}\n"
         "Layer: 0 {\nVersion: 100\nLayerElement:  {\nType: \"LayerElementMaterial\"\nTypedIndex: 0\n}\n"
         "LayerElement:  {\nType: \"LayerElementUV\"\nTypedIndex: 0\n}\n}\n}\n"
         "Model: 2, \"Model::m\", \"Mesh\" {\nVersion: 232\n}\nMaterial: 3, \"Material::a\", \"\" {\nVersion: 102\n"
         "ShadingModel: \"lambert\"\nMultiLayer: 0\nProperties70:  {\n"
         "P: \"DiffuseColor\", \"Color\", \"\", \"A\",1,0,0\n" +
         properties + "}\n}\n" + textures + "}\nConnections:  {\nC: \"OO\",2,0\nC: \"OO\",1,2\nC: \"OO\",3,2\n" +
         connections + "}\n";
}

TEST_F(ImportAlpha, KindsOfFbx) {
  const auto colour = [](const std::string& value) {
    return fmt::format("P: \"TransparentColor\", \"Color\", \"\", \"A\",{0},{0},{0}\n", value);
  };
  const auto factor = [](const std::string& value) {
    return fmt::format("P: \"TransparencyFactor\", \"Number\", \"\", \"A\",{}\n", value);
  };
  const auto opacity = [](const std::string& value) {
    return fmt::format("P: \"Opacity\", \"double\", \"Number\", \"\",{}\n", value);
  };
  for (const auto& [properties, expected] :
       std::map<std::string, ModeAndAlpha>{{"", kSolid},
                                           {opacity("0.4"), blended(102)},
                                           {colour("0.6") + factor("1") + opacity("0.4"), blended(102)},  // Maya
                                           {colour("0.6") + factor("1"), blended(102)},
                                           {colour("1") + factor("0.6"), blended(102)},
                                           {factor("0.6"), blended(102)},
                                           {colour("0") + factor("0.6"), blended(102)},
                                           {colour("0") + factor("1"), kSolid},
                                           {colour("1") + factor("0"), kSolid},
                                           {colour("0.8") + factor("0.6") + opacity("0.4"), blended(102)},  // Blender
                                           {factor("1"), kSolid}}) {
    const SourceModel model = source(file("m.fbx", fbx_triangle(properties)));
    EXPECT_EQ(alpha(material(model)), expected) << properties;
    EXPECT_TRUE(model.warnings.empty()) << properties;
  }
  const SourceModel hidden = source(file("m.fbx", fbx_triangle(colour("1") + factor("1") + opacity("0"))));
  EXPECT_EQ(alpha(material(hidden)), kSolid);
  EXPECT_EQ(hidden.warnings.size(), 1U);
}

/// Blender 2.75 and 2.76 write a share of 1 of black for no reflection: their models were drawn as mirrors.
TEST_F(ImportAlpha, BlackReflectionOfBlendersFbxIsNoMetal) {
  for (const auto& [colour, metallic] : {std::pair{"0,0,0", 0.0}, std::pair{"1,1,1", 1.0}}) {
    std::string text =
        fbx_triangle(fmt::format("P: \"ShininessExponent\", \"Number\", \"\", \"A\",20\n"
                                 "P: \"ReflectionColor\", \"Color\", \"\", \"A\",{}\n"
                                 "P: \"ReflectionFactor\", \"Number\", \"\", \"A\",1\n",
                                 colour));
    text.insert(text.find("FBXVersion"), "Creator: \"Blender (stable FBX IO) - 2.76\"\n");
    EXPECT_EQ(material(source(file("m.fbx", text))).metallic, metallic) << colour;
  }
}

TEST_F(ImportAlpha, MapsOfFbx) {
  png("colour.png", 2, 2, 0xF800);
  grey_png("mask.png", 2, 2, {0, 255, 255, 0});
  grey_png("smooth.png", 2, 2, {0, 64, 128, 255});
  file("own.png", rgba_png(2, 1, {9, 9, 9, 0, 255, 255, 255, 255}));
  const auto with = [&](const std::vector<std::pair<std::string, std::string>>& maps) {
    return source(file("m.fbx", fbx_triangle("", maps)));
  };
  for (const char* property : {"TransparentColor", "TransparencyFactor"}) {
    const SourceModel masked = with({{"colour.png", "DiffuseColor"}, {"mask.png", property}});
    EXPECT_EQ(alpha(material(masked)), kMasked) << property;
    EXPECT_EQ(texels_alpha(masked), (std::vector<std::uint8_t>{0, 255, 255, 0})) << property;
    EXPECT_EQ(masked.textures[material(masked).texture].rgb[0], 255) << "colours stay";
    const SourceModel smooth = with({{"smooth.png", property}});
    EXPECT_EQ(alpha(material(smooth)), kSmooth) << property;
    EXPECT_EQ(texels_alpha(smooth), (std::vector<std::uint8_t>{0, 64, 128, 255})) << property;
    EXPECT_EQ(material(smooth).colour, (std::array<std::uint8_t, 3>{255, 0, 0})) << property;
    EXPECT_TRUE(masked.warnings.empty() && smooth.warnings.empty()) << property;
  }
  // Blender and 3ds Max name the base texture again for its alpha. Without that its alpha has no effect.
  const SourceModel own = with({{"own.png", "DiffuseColor"}, {"own.png", "TransparentColor"}});
  EXPECT_EQ(alpha(material(own)), kMasked);
  EXPECT_EQ(texels_alpha(own), (std::vector<std::uint8_t>{0, 255}));
  EXPECT_EQ(alpha(material(with({{"own.png", "DiffuseColor"}}))), kSolid);
}

}  // namespace
}  // namespace zstrip::sim::test
