// Metals of model files: which of them mirror the studio, how they are tinted, and what stays as it was.
#include <algorithm>
#include <cmath>

#include "gltf_file.hpp"
#include "import/metals.hpp"
#include "import/model.hpp"
#include "render/stage.hpp"
#include "support.hpp"
#include "zstrip/effects.hpp"

namespace zstrip::sim::test {
namespace {

class ModelMetals : public FolderTest {
 protected:
  Model read(const GltfFile& gltf, MaterialStyle style = MaterialStyle::rich) const {
    return read(gltf.text(), "m.gltf", style);
  }
  Model read(const std::string& text, const std::string& name, MaterialStyle style = MaterialStyle::rich) const {
    Result<Model> model =
        import_model(file(name, text), {}, Texcoords::of_textures, BackFaces::lit_alike, {Highlights::none, style});
    EXPECT_TRUE(model) << model.failure().message;
    return model ? std::move(*model) : Model();
  }
  static bool mirrors(const Model& model, std::size_t instance = 0) {
    const Material& material = model.materials.at(model.instances.at(instance).material);
    return material.finish != kNoFinish && is_environment(model.finishes.at(material.finish).filter) &&
           material.texture != kNoTexture;
  }
};

const char* const kNode = R"({"mesh":0})";

std::string metal(const std::string& members) { return R"({"pbrMetallicRoughness":{)" + members + "}}"; }
const std::string kGold = R"("baseColorFactor":[1,0.766,0.336,1],"metallicFactor":1,"roughnessFactor":0.2)";

/// Radiance is linear: half of the light is not half of the channel.
TEST(StudioMap, IsTintedInProportionToLight) {
  const RgbImage grey = studio_map(8, {255, 255, 255}), tinted = studio_map(8, {188, 255, 0});  // 0.503 of the light
  const auto linear = [](int c) { return std::pow((c / 255.0 + 0.055) / 1.055, 2.4); };
  for (std::size_t i = 0; i < grey.rgb.size(); i += 3) {
    EXPECT_EQ(tinted.rgb[i + 1], grey.rgb[i + 1]);
    EXPECT_EQ(tinted.rgb[i + 2], 0);
    EXPECT_EQ(grey.rgb[i], grey.rgb[i + 2]);
    if (grey.rgb[i] == 255) continue;  // more light than the screen shows
    EXPECT_NEAR(linear(tinted.rgb[i]), 0.503 * linear(grey.rgb[i]), 0.006);
  }
}

TEST(StudioMap, RougherMetalMirrorsWithLessContrast) {
  const auto contrast = [](unsigned exponent) {
    const RgbImage map = studio_map(exponent, {128, 128, 128});
    const auto [least, most] = std::ranges::minmax_element(map.rgb);
    return *most - *least;
  };
  EXPECT_GT(contrast(128), contrast(32));
  EXPECT_GT(contrast(32), contrast(8));
  EXPECT_GT(contrast(8), contrast(2));
}

TEST_F(ModelMetals, SmoothOnesMirrorAStudioWithoutLight) {
  const Model model = read({.materials = {metal(kGold)}, .nodes = {kNode}});
  EXPECT_TRUE(mirrors(model));
  EXPECT_FALSE(model.materials.at(model.instances.at(0).material).lit);
  EXPECT_TRUE(model.warnings.empty());
}

TEST_F(ModelMetals, OnesOfEqualColourShareAMap) {
  const std::string other = R"("baseColorFactor":[0,0.766,0.336,1],"metallicFactor":1,"roughnessFactor":0.2)";
  const Model model = read(
      {.materials = {metal(kGold), metal(kGold), metal(other)}, .nodes = {kNode, R"({"mesh":1})", R"({"mesh":2})"}});
  EXPECT_EQ(model.textures.size(), 2);
}

TEST_F(ModelMetals, WhatIsNoSmoothMetalIsDrawnAsBefore) {
  for (const std::string& material :
       {std::string("{}"), metal(R"("roughnessFactor":0.9)"), metal(R"("metallicFactor":0.3,"roughnessFactor":0.2)"),
        std::string(R"({"extensions":{"KHR_materials_unlit":{}},"pbrMetallicRoughness":{"roughnessFactor":0.2}})"),
        std::string(R"({"emissiveFactor":[1,0,0],"pbrMetallicRoughness":{"roughnessFactor":0.2}})")}) {
    EXPECT_FALSE(mirrors(read({.materials = {material}, .nodes = {kNode}}))) << material;
  }
  const GltfFile gold{.materials = {metal(kGold)}, .nodes = {kNode}};
  EXPECT_FALSE(mirrors(read(gold, MaterialStyle::plain)));
  EXPECT_TRUE(read(gold, MaterialStyle::plain).textures.empty());
}

/// A night scene would have glowing metals.
TEST_F(ModelMetals, LightsOfAFileAreMultipliedWithTheStudio) {
  const Model model = read({.materials = {metal(kGold)},
                            .nodes = {R"({"mesh":0,"extensions":{"KHR_lights_punctual":{"light":0}}})"},
                            .lights = R"({"type":"directional"})"});
  EXPECT_TRUE(mirrors(model));
  EXPECT_TRUE(model.materials.at(model.instances.at(0).material).lit);
}

TEST_F(ModelMetals, TextureOfRoughnessAndMetalCountsByItsMean) {
  const std::string textured = metal(R"("metallicRoughnessTexture":{"index":0})");
  const auto with = [&](std::uint8_t roughness, std::uint8_t metallic) {
    return read({.materials = {textured},
                 .nodes = {kNode},
                 .pictures = rgba_png(2, 1, {0, roughness, metallic, 255, 0, roughness, metallic, 255})});
  };
  EXPECT_TRUE(mirrors(with(60, 255)));
  EXPECT_FALSE(mirrors(with(250, 255)));
  EXPECT_FALSE(mirrors(with(60, 20)));
}

/// It was black: only the diffuse part was drawn.
TEST_F(ModelMetals, SpecularGlossinessOfGoldIsGold) {
  const std::string gold = R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[0,0,0,1],)"
                           R"("specularFactor":[1,0.766,0.336],"glossinessFactor":0.8}}})";
  for (const MaterialStyle style : {MaterialStyle::plain, MaterialStyle::rich}) {
    const Model older = read({.materials = {gold}, .nodes = {kNode}}, style);
    const Model newer = read({.materials = {metal(kGold)}, .nodes = {kNode}}, style);
    EXPECT_EQ(older.materials.at(older.instances.at(0).material).colour,
              newer.materials.at(newer.instances.at(0).material).colour);
    EXPECT_EQ(older.texels, newer.texels);
  }
  const std::string plastic = R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[1,0,0,1],)"
                              R"("specularFactor":[0.04,0.04,0.04],"glossinessFactor":0.8}}})";
  EXPECT_FALSE(mirrors(read({.materials = {plastic}, .nodes = {kNode}})));
}

TEST_F(ModelMetals, ObjWithMetalAndRoughnessMirrors) {
  const auto obj = [&](const std::string& lines) {
    file("m.mtl", "newmtl gold\nKd 1 0.8 0.3\n" + lines);
    return read("mtllib m.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nusemtl gold\nf 1 2 3\n", "m.obj");
  };
  EXPECT_TRUE(mirrors(obj("Pm 1\nPr 0.2\n")));
  EXPECT_FALSE(mirrors(obj("Pm 1\nPr 0.9\n")));
  EXPECT_FALSE(mirrors(obj("Pr 0.2\n")));
  EXPECT_FALSE(mirrors(obj("Pm nan\nPr -1e999\n")));
}

TEST_F(ModelMetals, PictureCallsForAnEnvironment) {
  const std::string path = file("m.gltf", GltfFile{.materials = {metal(kGold)}, .nodes = {kNode}}.text());
  for (const MaterialStyle style : {MaterialStyle::plain, MaterialStyle::rich}) {
    const auto stage = open_stage(path, {.style = style}, {}, {64, 48}, 1);
    ASSERT_TRUE(stage) << stage.failure().message;
    const Result<Staging> staging = (*stage)->place(0, 1);
    ASSERT_TRUE(staging);
    EXPECT_EQ(effects_of(staging->scene, staging->camera).has(effect::environment), style == MaterialStyle::rich);
  }
}

}  // namespace
}  // namespace zstrip::sim::test
