// Highlights of glTF 2.0 materials against the peak of the lobe that the format defines.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gltf_file.hpp"
#include "import/model.hpp"
#include "render/stage.hpp"
#include "support.hpp"
#include "zstrip/effects.hpp"

namespace zstrip::sim::test {
namespace {

class GltfHighlights : public FolderTest {
 protected:
  Finish finish(const std::string& material, Highlights highlights = Highlights::of_materials,
                const std::string& picture = "") const {
    const GltfFile gltf{.materials = {material}, .nodes = {R"({"mesh":0})"}, .pictures = picture};
    const Result<Model> model =
        import_model(file("model.gltf", gltf.text()), {}, Texcoords::of_textures, BackFaces::lit_alike, highlights);
    EXPECT_TRUE(model) << model.failure().message;
    EXPECT_TRUE(model->warnings.empty()) << model->warnings[0];
    const std::uint8_t index = model->materials.at(0).finish;
    return index == kNoFinish ? Finish{} : model->finishes.at(index);
  }
};

struct Surface {
  double roughness = 1, metallic = 0, base = 1, ior = 1.5, factor = 1, tint = 1;

  std::string json() const {
    const auto text = [](double value) { return std::to_string(value); };
    return R"({"pbrMetallicRoughness":{"roughnessFactor":)" + text(roughness) + R"(,"metallicFactor":)" +
           text(metallic) + R"(,"baseColorFactor":[)" + text(base) + "," + text(base / 2) +
           R"(,0,1]},"extensions":{"KHR_materials_ior":{"ior":)" + text(ior) +
           R"(},"KHR_materials_specular":{"specularFactor":)" + text(factor) + R"(,"specularColorFactor":[)" +
           text(tint) + ",1,0]}}}";
  }
  /// What arrives at the eye where normal, light and eye are one direction, of light that a white wall shows as 1: the
  /// format's GGX lobe, D F / 4, times pi; less what is drawn beside it, the wall that metal is not.
  double peak(double colour, double tint_here) const {
    const double amplitude = (ior - 1) / (ior + 1);
    const double dielectric = std::min(amplitude * amplitude * tint_here, 1.0) * factor;
    const double reflected = dielectric + (colour - dielectric) * metallic;
    const double alpha = roughness * roughness, lobe = 1 / (std::numbers::pi * alpha * alpha);
    return std::numbers::pi * lobe * reflected / 4 - metallic * colour;
  }
};

/// Of exponents from 1 to 255; what is smoother has its peak lowered with its exponent.
TEST_F(GltfHighlights, PeaksAreThoseOfTheFormatsLobe) {
  int shown = 0;
  for (const double roughness : {0.3, 0.34, 0.4, 0.5, 0.6, 0.75, 0.9}) {
    for (const double metallic : {0.0, 0.25, 1.0}) {
      for (const Surface& other :
           {Surface{}, Surface{.base = 0.4}, Surface{.ior = 1.1, .tint = 0.5}, Surface{.ior = 2.4, .factor = 0.6},
            Surface{.ior = 0}, Surface{.ior = 1.5, .tint = 9}}) {
        Surface surface = other;
        surface.roughness = roughness;
        surface.metallic = metallic;
        const auto channel = [](double value) {
          return static_cast<int>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
        };
        const int red = channel(surface.peak(surface.base, surface.tint)),
                  green = channel(surface.peak(surface.base / 2, 1)), blue = channel(surface.peak(0, 0));
        const Finish found = finish(surface.json());
        const bool visible = std::max({red, green, blue}) >= 8;
        EXPECT_NEAR(found.specular.r, visible ? red : 0, 1) << surface.json();
        EXPECT_NEAR(found.specular.g, visible ? green : 0, 1) << surface.json();
        EXPECT_NEAR(found.specular.b, visible ? blue : 0, 1) << surface.json();
        if (!visible) continue;
        ++shown;
        EXPECT_NEAR(found.shininess, 2 / std::pow(roughness, 4) - 2, 0.5) << surface.json();
      }
    }
  }
  EXPECT_GT(shown, 60);
}

TEST_F(GltfHighlights, SmoothestAndRoughestStayWithinTheExponents) {
  EXPECT_EQ(finish(Surface{.roughness = 0}.json()).shininess, 255);
  EXPECT_EQ(finish(Surface{.roughness = 0}.json()).specular.g, 255);
  EXPECT_EQ(finish(Surface{.roughness = 1, .ior = 0}.json()).shininess, 1);
  EXPECT_EQ(finish(Surface{.roughness = 1, .ior = 0}.json()).specular.g, 96) << "3/8";
}

TEST_F(GltfHighlights, NoneUnlessAskedOrWhereThereIsNoLight) {
  const std::string smooth = Surface{.roughness = 0.4}.json();
  EXPECT_EQ(finish(smooth, Highlights::none), Finish{});
  EXPECT_NE(finish(smooth), Finish{});
  EXPECT_EQ(finish(R"({"pbrMetallicRoughness":{"roughnessFactor":0.4},"extensions":{"KHR_materials_unlit":{}}})"),
            Finish{});
  EXPECT_EQ(finish(R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{"glossinessFactor":0.9}}})"), Finish{});
  EXPECT_EQ(finish("{}"), Finish{}) << "rough metal is drawn as its colour";
}

/// Green is roughness, blue metal; red means nothing.
TEST_F(GltfHighlights, TextureOfRoughnessCountsByItsMean) {
  const std::string picture = rgba_png(2, 1, {255, 204, 0, 255, 0, 0, 0, 255});
  const char* const textured =
      R"({"pbrMetallicRoughness":{"roughnessFactor":1,"metallicFactor":1,"metallicRoughnessTexture":{"index":0}}})";
  const Finish found = finish(textured, Highlights::of_materials, picture);
  EXPECT_EQ(found.shininess, 76) << "as of roughness 0.4";
  EXPECT_EQ(found.specular, (Colour{100, 100, 100, 255}));
}

/// It counted as white without a word.
TEST_F(GltfHighlights, MissingTextureOfRoughnessIsSaid) {
  const std::string textured =
      R"({"pbrMetallicRoughness":{"roughnessFactor":0.4,"metallicRoughnessTexture":{"index":0}}})";
  const GltfFile gltf{{textured, textured}, {R"({"mesh":0})", R"({"mesh":1})"}, "nothing"};
  const auto warnings = [&](Highlights highlights) {
    const Result<Model> model =
        import_model(file("model.gltf", gltf.text()), {}, Texcoords::of_textures, BackFaces::lit_alike, highlights);
    EXPECT_TRUE(model) << model.failure().message;
    return model ? model->warnings : std::vector<std::string>();
  };
  EXPECT_EQ(
      warnings(Highlights::of_materials),
      std::vector<std::string>{"texture 'images[0]' is not a picture in PNG, JPEG, WebP, BMP or TGA; highlights are "
                               "drawn without"});
  EXPECT_TRUE(warnings(Highlights::none).empty());
}

TEST_F(GltfHighlights, PictureCallsForThem) {
  const GltfFile gltf{.materials = {Surface{.roughness = 0.4}.json()}, .nodes = {R"({"mesh":0})"}};
  const std::string path = file("model.gltf", gltf.text());
  for (const Highlights highlights : {Highlights::none, Highlights::of_materials}) {
    const auto stage = open_stage(path, {.highlights = highlights}, {}, {64, 48}, 1);
    ASSERT_TRUE(stage) << stage.failure().message;
    const Result<Staging> staging = (*stage)->place(0, 1);
    ASSERT_TRUE(staging);
    EXPECT_EQ(effects_of(staging->scene, staging->camera).has(effect::specular),
              highlights == Highlights::of_materials);
  }
}

}  // namespace
}  // namespace zstrip::sim::test
