// Effects of glTF 2.0 files made to measure: emission, alpha, unlit and two-sided materials, point and spot lights.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "gltf_file.hpp"
#include "import/model.hpp"
#include "import/quantise.hpp"
#include "render/stage.hpp"
#include "support.hpp"
#include "zstrip/effects.hpp"

namespace zstrip::sim::test {
namespace {

class GltfEffects : public FolderTest {
 protected:
  Model model(const GltfFile& gltf) const {
    Result<Model> imported = import_model(file("model.gltf", gltf.text()));
    EXPECT_TRUE(imported) << imported.failure().message;
    return std::move(*imported);
  }
  /// The effects that a picture of the file calls for.
  Effects effects(const GltfFile& gltf) const {
    const auto stage = open_stage(file("model.gltf", gltf.text()), {}, {}, {64, 48}, 1);
    EXPECT_TRUE(stage) << stage.failure().message;
    const Result<Staging> staging = (*stage)->place(0, 1);
    return without_shades(effects_of(staging->scene, staging->camera));
  }
  /// The finish of the only material.
  static Finish finish(const Model& model) {
    EXPECT_EQ(model.materials.size(), 1U);
    const std::uint8_t index = model.materials[0].finish;
    return index == kNoFinish ? Finish{} : model.finishes.at(index);
  }
};

const std::vector<std::string> kOneSquare{R"({"mesh":0})"};
/// Half transparent on the left, opaque on the right.
const std::string kHalfGlass = rgba_png(2, 1, {200, 100, 50, 128, 50, 100, 200, 255});

TEST_F(GltfEffects, PlainMaterialsHaveNone) {
  const GltfFile plain{.materials = {R"({"name":"plain"})"}, .nodes = kOneSquare};
  const Model imported = model(plain);
  EXPECT_EQ(imported.materials[0].finish, kNoFinish);
  EXPECT_FALSE(imported.materials[0].double_sided);
  EXPECT_TRUE(imported.finishes.empty());
  EXPECT_EQ(effects(plain), effect::lighting | effect::gouraud);
}

TEST_F(GltfEffects, EmissionIsLinearLight) {
  const GltfFile glowing{.materials = {R"({"emissiveFactor":[1,0.2140411,0]})"}, .nodes = kOneSquare};
  EXPECT_EQ(finish(model(glowing)).emissive, (Colour{255, 127, 0, 255}));
  EXPECT_TRUE(effects(glowing).has(effect::emissive));
}

TEST_F(GltfEffects, EmissionWithItsOwnTextureIsLeftOutAndSaid) {
  const char* const own_json = R"({"name":"lamp","emissiveFactor":[1,1,1],"emissiveTexture":{"index":0}})";
  const Model own = model({.materials = {own_json}, .nodes = kOneSquare, .pictures = kHalfGlass});
  EXPECT_EQ(own.materials[0].finish, kNoFinish);
  ASSERT_EQ(own.warnings.size(), 1U);
  EXPECT_NE(own.warnings[0].find("material 'lamp'"), std::string::npos) << own.warnings[0];
  // With the base colour's own picture it is what the renderer does: texels times the sum.
  const char* const same_json =
      R"({"emissiveFactor":[1,1,1],"emissiveTexture":{"index":0},"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
  const Model same = model({.materials = {same_json}, .nodes = kOneSquare, .pictures = kHalfGlass});
  EXPECT_EQ(finish(same).emissive, (Colour{255, 255, 255, 255}));
  EXPECT_TRUE(same.warnings.empty());
}

TEST_F(GltfEffects, MaskedWithItsCutoff) {
  const auto masked = [](const std::string& cutoff) {
    return GltfFile{
        .materials = {R"({"alphaMode":"MASK",)" + cutoff +
                      R"("pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.6],"baseColorTexture":{"index":0}}})"},
        .nodes = kOneSquare,
        .pictures = kHalfGlass};
  };
  const Model imported = model(masked(R"("alphaCutoff":0.75,)"));
  EXPECT_EQ(finish(imported).alpha_mode, AlphaMode::mask);
  EXPECT_EQ(finish(imported).alpha_cutoff, 191);
  EXPECT_EQ(imported.materials[0].colour.a, 153);
  EXPECT_EQ(finish(model(masked(""))).alpha_cutoff, 128) << "glTF's default is a half";
  EXPECT_TRUE(effects(masked("")).has(effect::alpha_test | effect::texture_alpha));
  // Beyond 1 nothing is left, at 0 nothing is missing.
  EXPECT_EQ(model(masked(R"("alphaCutoff":1.5,)")).materials[0].colour.a, 0);
  EXPECT_FALSE(effects(masked(R"("alphaCutoff":0,)")).any(effect::alpha_test | effect::texture_alpha));
}

TEST_F(GltfEffects, AlphaOfTexelsIsKeptWhereItIsUsed) {
  const auto with_mode = [](const std::string& mode) {
    return GltfFile{
        .materials = {R"({"alphaMode":")" + mode + R"(","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})"},
        .nodes = kOneSquare,
        .pictures = kHalfGlass};
  };
  const Model blended = model(with_mode("BLEND"));
  ASSERT_EQ(blended.textures.size(), 1U);
  EXPECT_EQ(blended.textures[0].format, TextureFormat::rgb565_alpha);
  ASSERT_EQ(blended.textures[0].texels.size(), 3U);
  EXPECT_EQ(blended.textures[0].texels[2], 255 << 8 | 128);
  EXPECT_TRUE(effects(with_mode("BLEND")).has(effect::blending | effect::texture_alpha));
  const Model opaque = model(with_mode("OPAQUE"));
  EXPECT_EQ(opaque.textures[0].format, TextureFormat::rgb565);
  EXPECT_EQ(opaque.textures[0].texels.size(), 2U);
  EXPECT_FALSE(effects(with_mode("OPAQUE")).any(effect::blending | effect::texture_alpha));
}

/// Faces that blend write no depth: inner ones were seen.
TEST_F(GltfEffects, NothingBlendsWithoutATransparentPlace) {
  const auto blends = [&](const std::string& base, const std::string& pictures) {
    const std::string material = R"({"alphaMode":"BLEND","pbrMetallicRoughness":{)" + base + "}}";
    return effects({.materials = {material}, .nodes = kOneSquare, .pictures = pictures})
        .any(effect::blending | effect::texture_alpha);
  };
  const std::string whole = rgba_png(2, 1, {9, 9, 9, 255, 9, 9, 9, 255}),
                    textured = R"("baseColorTexture":{"index":0})";
  EXPECT_FALSE(blends("", ""));
  EXPECT_FALSE(blends(R"("baseColorFactor":[1,0,0,1])", ""));
  EXPECT_FALSE(blends(textured, whole));
  EXPECT_TRUE(blends(R"("baseColorFactor":[1,0,0,0.9])", ""));
  EXPECT_TRUE(blends(R"("baseColorFactor":[1,0,0,0.9],)" + textured, whole));
  EXPECT_TRUE(blends(textured, rgba_png(2, 1, {9, 9, 9, 255, 9, 9, 9, 254})));
}

TEST_F(GltfEffects, OpaqueIgnoresAlpha) {
  const Model imported =
      model({.materials = {R"({"pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.25]}})"}, .nodes = kOneSquare});
  EXPECT_EQ(imported.materials[0].colour.a, 255);
}

/// The renderer sorts instances: what blends must not be gathered into one.
TEST_F(GltfEffects, BlendedNodesStayApart) {
  const char* const glass_json = R"({"alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorFactor":[1,0,0,0.5]}})";
  const std::vector<std::string> three{R"({"mesh":0})", R"({"mesh":0,"translation":[0,0,1]})",
                                       R"({"mesh":0,"translation":[0,0,2]})"};
  const Model glass = model({.materials = {glass_json}, .nodes = three});
  EXPECT_EQ(glass.instances.size(), 3U);
  EXPECT_EQ(glass.finishes.size(), 1U);
  EXPECT_EQ(glass.materials[0].colour.a, 128);
  EXPECT_EQ(model({.materials = {"{}"}, .nodes = three}).instances.size(), 1U);
}

/// With one box for all of them they were drawn in the file's order.
TEST_F(GltfEffects, BlendedNodesHaveBoxesOfTheirOwn) {
  const char* const glass_json = R"({"alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorFactor":[1,0,0,0.5]}})";
  const std::vector<std::string> nodes{R"({"mesh":0,"translation":[0,0,2]})", R"({"mesh":0})",
                                       R"({"mesh":0,"translation":[0.5,0,1],"scale":[0.3,0.3,1]})"};
  const Model glass = model({.materials = {glass_json}, .nodes = nodes});
  ASSERT_EQ(glass.meshes.size(), 3U);
  EXPECT_EQ(glass.meshes[0].centre.z, kFixedOne);
  EXPECT_EQ(glass.meshes[1].centre.z, -kFixedOne);
  EXPECT_EQ(glass.meshes[2].centre.z, 0);
  EXPECT_EQ(glass.meshes[2].centre.x, kFixedOne / 2);
  EXPECT_EQ(glass.meshes[2].half_extent.z, 0);
  for (const Mesh& mesh : glass.meshes) {
    for (const Position& position : mesh.positions) EXPECT_GE(std::abs(position.x), 32760);
  }
}

TEST_F(GltfEffects, UnlitAndDoubleSided) {
  const Model imported =
      model({.materials = {R"({"extensions":{"KHR_materials_unlit":{}},"emissiveFactor":[1,1,1],"doubleSided":true})"},
             .nodes = kOneSquare});
  EXPECT_FALSE(imported.materials[0].lit);
  EXPECT_TRUE(imported.materials[0].double_sided);
  EXPECT_EQ(imported.materials[0].finish, kNoFinish) << "an unlit material has no emission";
}

/// A node with light 0, at a place and with a turn.
std::string light_node(const std::string& place) {
  return R"({"name":"lamp","extensions":{"KHR_lights_punctual":{"light":0}},)" + place + "}";
}

/// The square is 2 wide, so that the file's units are the scene's. The light's distance from its middle is 2.
TEST_F(GltfEffects, PointLight) {
  const GltfFile lit{.materials = {"{}"},
                     .nodes = {kOneSquare[0], light_node(R"("translation":[0,0,2])")},
                     .lights = R"({"type":"point","color":[1,0.5,0],"intensity":80,"range":5})"};
  const Model imported = model(lit);
  EXPECT_TRUE(imported.lights.empty());
  ASSERT_EQ(imported.punctual_lights.size(), 1U);
  const PunctualLight& light = imported.punctual_lights[0];
  EXPECT_EQ(light.type, PunctualLightType::point);
  EXPECT_EQ(light.colour, (Colour{255, 128, 0, 255}));
  EXPECT_EQ(light.position.z, 2 * kFixedOne);
  EXPECT_EQ(light.intensity, 4 * kFixedOne) << "full light where it meets the model";
  EXPECT_EQ(light.range, 5 * kFixedOne);
  EXPECT_TRUE(effects(lit).has(effect::punctual_lights));
  // The look of models without lights adds none, and no more light from all sides.
  const auto lights = [&](const DefaultLook& look) {
    const auto stage = open_stage(path("model.gltf"), {.look = look}, {}, {64, 48}, 1);
    EXPECT_TRUE(stage) << stage.failure().message;
    const Scene scene = (*stage)->place(0, 1)->scene;
    return std::tuple(scene.lights.size(), scene.lights[0].colour.r, scene.ambient.r, scene.punctual_lights.size());
  };
  EXPECT_EQ(lights(look_for_people(PixelFormat::rgb565)), lights(kPlainLook));
}

TEST_F(GltfEffects, SpotLight) {
  // Half a right angle about -x: what shone along -z now shines down and away.
  const double half = std::numbers::pi / 8;
  const GltfFile lit{
      .materials = {"{}"},
      .nodes = {kOneSquare[0], light_node(R"("translation":[0,3,0],"rotation":[)" + std::to_string(-std::sin(half)) +
                                          ",0,0," + std::to_string(std::cos(half)) + "]")},
      .lights = R"({"type":"spot","intensity":9,"spot":{"innerConeAngle":0.25,"outerConeAngle":0.5}})"};
  const Model imported = model(lit);
  ASSERT_EQ(imported.punctual_lights.size(), 1U);
  const PunctualLight& light = imported.punctual_lights[0];
  EXPECT_EQ(light.type, PunctualLightType::spot);
  EXPECT_EQ(light.position.y, 3 * kFixedOne);
  EXPECT_EQ(light.intensity, 9 * kFixedOne);
  EXPECT_EQ(light.range, 0) << "no end";
  EXPECT_NEAR(light.x, 0, 2);
  EXPECT_NEAR(light.y, -23170, 2);
  EXPECT_NEAR(light.z, -23170, 2);
  EXPECT_NEAR(light.cosine_inner, 32767 * std::cos(0.25), 1);
  EXPECT_NEAR(light.cosine_outer, 32767 * std::cos(0.5), 1);
}

/// Of several lights the brightest sets the exposure for all.
TEST_F(GltfEffects, LightsShareTheExposure) {
  const GltfFile lit{
      .materials = {"{}"},
      .nodes = {kOneSquare[0], light_node(R"("translation":[0,0,2])"),
                R"({"name":"sun","extensions":{"KHR_lights_punctual":{"light":1}}})"},
      .lights = R"({"type":"point","intensity":4},{"type":"directional","intensity":0.5,"color":[1,1,0]})"};
  const Model imported = model(lit);
  ASSERT_EQ(imported.lights.size(), 1U);
  ASSERT_EQ(imported.punctual_lights.size(), 1U);
  EXPECT_EQ(imported.punctual_lights[0].intensity, 4 * kFixedOne);
  EXPECT_EQ(imported.lights[0].colour, (Colour{128, 128, 0, 255}));
}

TEST_F(GltfEffects, TooManyAndUselessLightsAreSaid) {
  std::vector<std::string> nodes = kOneSquare;
  std::string lights;
  for (int i = 0; i < 6; ++i) {
    lights += std::string(i > 0 ? "," : "") + R"({"type":"point","intensity":)" + (i == 5 ? "1e-9" : "4") + "}";
    nodes.push_back(R"({"name":"l)" + std::to_string(i) + R"(","extensions":{"KHR_lights_punctual":{"light":)" +
                    std::to_string(i) + R"(}},"translation":[0,0,2]})");
  }
  const Model imported = model({.materials = {"{}"}, .nodes = nodes, .lights = lights});
  EXPECT_EQ(imported.punctual_lights.size(), 4U);
  ASSERT_EQ(imported.warnings.size(), 2U) << imported.warnings[0];
  EXPECT_NE(imported.warnings[0].find("1 light left out: only the brightest"), std::string::npos);
  EXPECT_NE(imported.warnings[1].find("1 light left out: too far away or too dim"), std::string::npos);
}

TEST_F(GltfEffects, OriginsNameTheFile) {
  const auto stage = open_stage(
      file("tree.gltf", GltfFile{.materials = {R"({"name":"leaf","alphaMode":"MASK"})"}, .nodes = kOneSquare}.text()),
      {}, {}, {64, 48}, 1);
  ASSERT_TRUE(stage);
  const Result<Staging> staging = (*stage)->place(0, 1);
  const auto found = find_effects(staging->scene, staging->camera, effect::alpha_test, (*stage)->origins());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].materials, std::vector<std::string>{"leaf"});
  EXPECT_EQ(found[0].origin, "tree.gltf");
}

/// Scene files lost it: a texture that they name was read without its alpha.
TEST_F(GltfEffects, AlphaOfATextureThatASceneFileNames) {
  const GltfFile opaque{.materials = {R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})"},
                        .nodes = kOneSquare,
                        .pictures = rgba_png(1, 1, {90, 90, 90, 255})};
  file("square.gltf", opaque.text());
  file("glass.png", kHalfGlass);
  const std::string scene = file("scene.toml",
                                 "[[model]]\nname = 'square'\nfile = 'square.gltf'\n"
                                 "[[material]]\nname = 'glass'\ntexture = 'glass.png'\nalpha_mode = 'blend'\n"
                                 "[[instance]]\nmodel = 'square'\nmaterial = 'glass'\n");
  const auto stage = open_stage(scene, {}, {}, {64, 48}, 1);
  ASSERT_TRUE(stage) << stage.failure().message;
  const Result<Staging> staging = (*stage)->place(0, 1);
  const Texture& glass = staging->scene.textures[staging->scene.materials.back().texture];
  EXPECT_EQ(glass.format, TextureFormat::rgb565_alpha);
  EXPECT_EQ(glass.texels.back(), 128 | 255 << 8);
  EXPECT_TRUE(effects_of(staging->scene, staging->camera).has(effect::texture_alpha));
}

}  // namespace
}  // namespace zstrip::sim::test
