// What glTF 2.0 says of surfaces, one feature a file: colours times texels, transforms and borders of textures, sides.
#include <fmt/format.h>
#include <webp/encode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "gltf_file.hpp"
#include "import/model.hpp"
#include "import/read_model.hpp"
#include "render/default_look.hpp"
#include "render/render_frame.hpp"
#include "render/stage.hpp"
#include "support.hpp"

namespace zstrip::sim::test {
namespace {

using Rgb = std::array<int, 3>;

class GltfSurface : public FolderTest {
 protected:
  Model model(const std::string& content) const {
    Result<Model> imported = import_model(file("model.gltf", content));
    EXPECT_TRUE(imported) << imported.failure().message;
    return imported ? std::move(*imported) : Model();
  }
  SourceModel source(const std::string& content) const {
    Result<SourceModel> read = read_model(file("model.gltf", content), UpAxis::plus_y);
    EXPECT_TRUE(read) << read.failure().message;
    return read ? std::move(*read) : SourceModel();
  }
  /// The colour in the middle of a picture, seen from here.
  Rgb seen(const std::string& content, const std::array<double, 3>& eye,
           const std::array<double, 3>& look_at = {}) const {
    const View view{64, 48};
    const auto stage = open_stage(file("model.gltf", content), {}, {.eye = eye, .look_at = look_at}, view, 1);
    EXPECT_TRUE(stage) << stage.failure().message;
    if (!stage) return {};
    const Result<Staging> staging = (*stage)->place(0, 1);
    FrameRenderer renderer(view, Budget{});
    const auto report = renderer.render(*staging);
    EXPECT_TRUE(report) << report.failure().message;
    const std::byte* const at = renderer.pixels().data() + 2 * (24 * 64 + 32);
    const unsigned word = std::to_integer<unsigned>(at[0]) | std::to_integer<unsigned>(at[1]) << 8;
    return {static_cast<int>(word >> 11) * 255 / 31, static_cast<int>(word >> 5 & 63) * 255 / 63,
            static_cast<int>(word & 31) * 255 / 31};
  }
  static void expect_near(const Rgb& found, const Rgb& wanted) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], wanted[i], 8) << i;
  }
  /// A square of side 2 that faces +z, with these coordinates on a texture, bottom left first, against the clock.
  static std::string square(const std::string& material, const std::vector<float>& texcoords, const std::string& png,
                            const std::string& sampler = "{}", const std::vector<float>& colours = {}) {
    GltfData data;
    data.add_floats({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, "VEC3");
    data.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    data.add_floats(texcoords, "VEC2");
    data.add_indices({0, 1, 2, 0, 2, 3});
    if (!colours.empty()) data.add_floats(colours, "VEC3");
    return gltf_of(R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"material":0,"indices":3,"attributes":{)"
                   R"("POSITION":0,"NORMAL":1,"TEXCOORD_0":2)" +
                   std::string(colours.empty() ? "" : R"(,"COLOR_0":4)") + R"(}}]}],"materials":[)" + material +
                   R"(],"textures":[{"source":0,"sampler":0}],"samplers":[)" + sampler +
                   R"(],"images":[{"name":"tiles","uri":"data:image/png;base64,)" + base64(png) + R"("}],)" +
                   data.json());
  }
};

const std::vector<float> kWhole{0, 1, 1, 1, 1, 0, 0, 0};
const std::array<double, 3> kInFront{0, 0, 5}, kBehind{0, 0, -5};
const std::string kUnlit = R"("extensions":{"KHR_materials_unlit":{}})";
/// Of one colour; of two, the left one first.
const std::string kBrick = rgba_png(1, 1, {200, 100, 50, 255});
const std::string kRedGreen = rgba_png(2, 1, {255, 0, 0, 255, 0, 255, 0, 255});

/// Both were ignored, in silence.
TEST_F(GltfSurface, UnlitTexelsTimesFactorTimesVertexColour) {
  const auto unlit = [](const std::string& factor) {
    return "{" + kUnlit + R"(,"pbrMetallicRoughness":{"baseColorTexture":{"index":0}, "baseColorFactor":)" + factor +
           "}}";
  };
  // 0.2140411 of linear light is half of the screen's scale.
  const std::string half = "[0.2140411,0.2140411,1,1]";
  expect_near(seen(square(unlit("[1,1,1,1]"), kWhole, kBrick), kInFront), {200, 100, 50});
  expect_near(seen(square(unlit(half), kWhole, kBrick), kInFront), {100, 50, 50});
  const std::vector<float> one{1, 0.2140411F, 0, 1, 0.2140411F, 0, 1, 0.2140411F, 0, 1, 0.2140411F, 0};
  expect_near(seen(square(unlit("[1,1,1,1]"), kWhole, kBrick, "{}", one), kInFront), {200, 50, 0});
  // Red on the left, green on the right: half of both in the middle.
  const std::vector<float> two{1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0};
  expect_near(seen(square(unlit(half), kWhole, kBrick, "{}", two), kInFront), {50, 25, 0});
}

TEST_F(GltfSurface, UnlitColoursKeepOthersTexels) {
  const Model one =
      model(square("{" + kUnlit + R"(,"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})", kWhole, kBrick));
  EXPECT_FALSE(one.materials[0].lit);
  EXPECT_EQ(one.materials[0].finish, kNoFinish);
  EXPECT_EQ(one.textures.size(), 1U);
}

/// Scaled, turned about the upper left corner, moved; of the second set.
TEST_F(GltfSurface, TextureTransform) {
  const auto with = [](const std::string& transform) {
    return R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{)" +
           transform + "}}}}}";
  };
  const auto corner = [&](const std::string& transform, std::size_t index) {
    const SourceModel read = source(square(with(transform), kWhole, kBrick));
    return read.meshes[0].vertices[index].texcoord;
  };
  const auto expect_at = [](const std::array<float, 2>& found, float u, float v) {
    EXPECT_NEAR(found[0], u, 1e-6F);
    EXPECT_NEAR(found[1], v, 1e-6F);
  };
  // Corner 1 is at (1, 1), corner 3 at (0, 0).
  expect_at(corner(R"("offset":[0.25,0.5])", 3), 0.25F, 0.5F);
  expect_at(corner(R"("scale":[3,2])", 1), 3, 2);
  const std::string quarter = R"("rotation":)" + std::to_string(std::numbers::pi / 2);
  expect_at(corner(quarter, 3), 0, 0);
  expect_at(corner(quarter, 1), 1, -1);
  expect_at(corner(quarter + R"(,"scale":[3,2],"offset":[0.5,0])", 1), 2.5F, -3);
}

/// Floats of that size have no fractions: the texture became one texel.
TEST_F(GltfSurface, FarOffsetsKeepTheirFractions) {
  const auto at = [&](double offset, const std::string& sampler) {
    const std::string material = fmt::format(
        R"({{"pbrMetallicRoughness":{{"baseColorTexture":{{"index":0,"extensions":{{"KHR_texture_transform":)"
        R"({{"offset":[{0:.17g},{0:.17g}]}}}}}}}}}})",
        offset);
    return source(square(material, kWhole, kBrick, sampler)).meshes[0].vertices[3].texcoord;
  };
  for (const char* sampler : {"{}", R"({"wrapS":33648,"wrapT":33648})"}) {
    for (const double textures : {1e8, -1e8, 1e12, 18.0, -18.0}) {
      for (const float part : at(textures + 0.25, sampler)) {
        EXPECT_EQ(std::remainder(part - 0.25F, 2.0F), 0) << textures;
        EXPECT_LE(std::abs(part), 16.25F) << textures;
      }
    }
    EXPECT_EQ(std::fmod(at(1e20, sampler)[0], 2), 0);
  }
  // What is clamped does not repeat.
  EXPECT_EQ(at(1e8, R"({"wrapS":33071,"wrapT":33071})")[0], 1e8F);
}

/// They became 0 without a word.
TEST_F(GltfSurface, TextureCoordinatesThatAreNoNumbersAreSaid) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::string textured = R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
  EXPECT_EQ(model(square(textured, {0, 1, nan, 1, 1, nan, 0, 0}, kBrick)).warnings,
            std::vector<std::string>{"2 texture coordinates not finite (NaN or infinite): drawn as 0"});
  EXPECT_TRUE(model(square("{}", {0, 1, nan, 1, 1, nan, 0, 0}, kBrick)).warnings.empty());
}

TEST_F(GltfSurface, SecondSetOfTextureCoordinates) {
  GltfData data;
  data.add_floats({-1, -1, 0, 1, -1, 0, 1, 1, 0}, "VEC3");
  data.add_floats({0, 0, 0, 0, 0, 0}, "VEC2");
  data.add_floats({0, 1, 1, 1, 1, 0.5}, "VEC2");
  for (const char* use : {R"("texCoord":1)", R"("extensions":{"KHR_texture_transform":{"texCoord":1}})"}) {
    const SourceModel read =
        source(gltf_of(R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"material":0,"attributes":{"POSITION":0,)"
                       R"("TEXCOORD_0":1,"TEXCOORD_1":2}}]}],"materials":[{"pbrMetallicRoughness":{"baseColorTexture":)"
                       R"({"index":0,)" +
                       std::string(use) + R"(}}}],"textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,)" +
                       base64(kBrick) + R"("}],)" + data.json()));
    EXPECT_EQ(read.meshes.at(0).vertices.at(2).texcoord, (std::array<float, 2>{1, 0.5F})) << use;
  }
}

/// All textures were repeated, in silence.
TEST_F(GltfSurface, MirroredTexturesAreDoubled) {
  const std::string textured = "{" + kUnlit + R"(,"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
  const std::string mirrored = R"({"wrapS":33648})";
  // The middle of the square is at 1.25: the mirror image has green there, the repeated picture red.
  const std::vector<float> wide{-0.75, 1, 3.25, 1, 3.25, 0, -0.75, 0};
  expect_near(seen(square(textured, wide, kRedGreen), kInFront), {255, 0, 0});
  expect_near(seen(square(textured, wide, kRedGreen, mirrored), kInFront), {0, 255, 0});
  // Within one picture nothing is doubled; in an odd one it is turned round.
  const Model turned = model(square(textured, {1, 1, 1.5, 1, 1.5, 0, 1, 0}, kRedGreen, mirrored));
  EXPECT_EQ(turned.textures[0].log2_width, 1);
  expect_near(seen(square(textured, {1.1F, 1, 1.4F, 1, 1.4F, 0, 1.1F, 0}, kRedGreen, mirrored), kInFront), {0, 255, 0});
}

TEST_F(GltfSurface, ClampedTextures) {
  const std::string textured = "{" + kUnlit + R"(,"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
  const std::string clamped = R"({"wrapS":33071,"wrapT":33071})";
  // At the border itself the last texel, which is not the first one.
  const std::vector<float> border{1, 1, 1, 1, 1, 0, 1, 0};
  expect_near(seen(square(textured, border, kRedGreen), kInFront), {255, 0, 0});
  expect_near(seen(square(textured, border, kRedGreen, clamped), kInFront), {0, 255, 0});
  EXPECT_TRUE(model(square(textured, border, kRedGreen, clamped)).warnings.empty());
  // As a whole beyond it; across it; so far beyond it that it is said.
  expect_near(seen(square(textured, {1.2F, 1, 1.2F, 1, 1.2F, 0, 1.2F, 0}, kRedGreen, clamped), kInFront), {0, 255, 0});
  expect_near(seen(square(textured, {-0.5F, 1, 2.9F, 1, 2.9F, 0, -0.5F, 0}, kRedGreen, clamped), kInFront),
              {0, 255, 0});
  expect_near(seen(square(textured, {-1.5F, 1, 1, 1, 1, 0, -1.5F, 0}, kRedGreen, clamped), kInFront), {255, 0, 0});
  EXPECT_TRUE(model(square(textured, {-0.9F, 1, 1.5F, 1, 1.5F, 0, -0.9F, 0}, kRedGreen, clamped)).warnings.empty());
  const Model beyond = model(square(textured, {0, 1, 9, 1, 9, 0, 0, 0}, kRedGreen, clamped));
  ASSERT_EQ(beyond.warnings.size(), 1U);
  EXPECT_NE(beyond.warnings[0].find("texture 'tiles' repeated"), std::string::npos) << beyond.warnings[0];
}

/// Emission with a texture of its own was left out.
TEST_F(GltfSurface, EmissionThatAloneIsSeenHasItsTexture) {
  const std::string emission = R"("emissiveFactor":[1,1,1],"emissiveTexture":{"index":0})";
  const std::string black = R"("pbrMetallicRoughness":{"baseColorFactor":[0,0,0,1]})";
  const std::string glowing = square("{" + emission + "," + black + "}", kWhole, kBrick);
  EXPECT_TRUE(model(glowing).warnings.empty());
  expect_near(seen(glowing, kInFront), {200, 100, 50});
  // Brighter than its base colour it is not lit, from whichever side the light comes.
  const std::string dark = R"("pbrMetallicRoughness":{"baseColorFactor":[0.002,0.002,0.002,1]})";
  const Model screen = model(square("{" + emission + "," + dark + "}", kWhole, kBrick));
  EXPECT_TRUE(screen.warnings.empty());
  ASSERT_EQ(screen.instances.size(), 1U);
  EXPECT_FALSE(screen.materials[screen.instances[0].material].lit);
  expect_near(seen(square("{" + emission + "," + dark + "}", kWhole, kBrick), kInFront), {207, 107, 57});
  // Beside a bright colour it is added to that, and lit with it: said.
  const Model lit = model(square(R"({"name":"lamp",)" + emission + "}", kWhole, kBrick));
  ASSERT_EQ(lit.warnings.size(), 1U);
  EXPECT_NE(lit.warnings[0].find("material 'lamp' drawn with its emission lit"), std::string::npos) << lit.warnings[0];
}

/// They were drawn white.
TEST_F(GltfSurface, MeshesWithoutTexcoordsKeepTheirColourBesideEmission) {
  const std::string green =
      R"({"pbrMetallicRoughness":{"baseColorFactor":[0,0.5,0,1]},"emissiveFactor":[1,1,1],"emissiveTexture":{"index":0}})";
  std::string text = square(green, kWhole, kBrick);
  const std::string texcoords = R"(,"TEXCOORD_0":2)";
  const Model plain = model(text.erase(text.find(texcoords), texcoords.size()));
  ASSERT_EQ(plain.instances.size(), 1U);
  const Material& material = plain.materials[plain.instances[0].material];
  EXPECT_EQ(material.colour.r, 0);
  EXPECT_EQ(material.colour.g, 188);
  EXPECT_TRUE(material.lit);
}

/// Normal and occlusion maps were left out.
class GltfSurfaceDetail : public GltfSurface {
 protected:
  /// A square with a grey base texture, a picture of 2x2 as its map, and these texture coordinates.
  static std::string mapped(const std::string& material, const std::vector<float>& texcoords, const std::string& map) {
    std::string text = square(material, texcoords,
                              rgba_png(2, 2,
                                       {120, 120, 120, 255, 120, 120, 120, 255,  //
                                        120, 120, 120, 255, 120, 120, 120, 255}));
    const auto add = [&](const std::string& before, const std::string& more) {
      text.insert(text.find(before) + before.size(), more);
    };
    add(R"("textures":[)", R"({"source":1},)");
    add(R"("images":[)", R"({"uri":"data:image/png;base64,)" + base64(map) + R"("},)");
    // The base texture, which was the first, is now the second of both.
    const std::string first = R"({"source":1},{"source":0,)", second = R"({"source":0},{"source":1,)";
    text.replace(text.find(first), first.size(), second);
    return text;
  }
  /// The base texture's green, 0 to 63, of the texels left and right in the upper row.
  std::array<int, 2> greens(const std::string& text, MaterialStyle style = MaterialStyle::rich) const {
    const Result<Model> imported = import_model(file("model.gltf", text), {}, Texcoords::of_textures,
                                                BackFaces::lit_alike, {Highlights::none, style});
    EXPECT_TRUE(imported) << imported.failure().message;
    if (!imported || imported->texels.size() != 1) return {};
    return {imported->texels[0][0] >> 5 & 63, imported->texels[0][1] >> 5 & 63};
  }
  /// The default light of models on a wall that faces +z, once its normal is bent to (x, y, z), and a share of the
  /// light from all sides is left; relative to the flat wall.
  static double expected(double x, double y, double z, double seen = 1) {
    const DefaultLook look = look_for_people(PixelFormat::rgb565);
    const double length = std::hypot(0.1, 0.8, 0.6);
    const auto light = [&](double nx, double ny, double nz, double share) {
      const double cosine = std::max((0.1 * nx + 0.8 * ny + 0.6 * nz) / length, 0.0);
      return look.ambient.g * share + look.light.colour.g * cosine;
    };
    return std::clamp(light(x, y, z, seen) / light(0, 0, 1, 1), 0.5, 1.5);
  }
  static void expect_times(const std::array<int, 2>& greens, double left, double right) {
    EXPECT_NEAR(greens[0], 120 * left * 63 / 255, 0.75);
    EXPECT_NEAR(greens[1], 120 * right * 63 / 255, 0.75);
  }
};

/// (0.6, 0, 0.8) and (0, -0.6, 0.8) of each row.
const std::string kBent =
    rgba_png(2, 2, {204, 128, 230, 255, 128, 51, 230, 255, 204, 128, 230, 255, 128, 51, 230, 255});

const std::string kBase = R"("pbrMetallicRoughness":{"baseColorTexture":{"index":1}})";
const std::string kBumpy = "{" + kBase + R"(,"normalTexture":{"index":0}})";

TEST_F(GltfSurfaceDetail, NormalMapsArePaintedIntoTheTexels) {
  const double right = expected(0.6, 0, 0.8), down = expected(0, -0.6, 0.8), up = expected(0, 0.6, 0.8);
  expect_times(greens(mapped(kBumpy, kWhole, kBent)), right, down);
  // Repeated three times.
  expect_times(greens(mapped(kBumpy, {0, 3, 3, 3, 3, 0, 0, 0}, kBent)), right, down);
  // The texture is rotated: its right side is up, and its lower side to the right.
  expect_times(greens(mapped(kBumpy, {0, 0, 0, 1, 1, 1, 1, 0}, kBent)), up, right);
  // Mirrored.
  expect_times(greens(mapped(kBumpy, {1, 1, 0, 1, 0, 0, 1, 0}, kBent)), expected(-0.6, 0, 0.8), down);
}

TEST_F(GltfSurfaceDetail, OcclusionDimsTheLightFromAllSides) {
  const std::string hidden = rgba_png(2, 2, {0, 255, 255, 255, 255, 0, 0, 255, 0, 255, 255, 255, 255, 0, 0, 255});
  const auto material = [](const std::string& strength) {
    return "{" + kBase + R"(,"occlusionTexture":{"index":0)" + strength + "}}";
  };
  expect_times(greens(mapped(material(""), kWhole, hidden)), expected(0, 0, 1, 0), 1);
  expect_times(greens(mapped(material(R"(,"strength":0.5)"), kWhole, hidden)), expected(0, 0, 1, 0.5), 1);
}

TEST_F(GltfSurfaceDetail, MapsThatNoTexelCanShowAreNamed) {
  expect_times(greens(mapped(kBumpy, kWhole, kBent), MaterialStyle::plain), 1, 1);
  const std::string elsewhere = "{" + kBase + R"(,"normalTexture":{"index":0,"texCoord":1}})";
  const Result<Model> imported =
      import_model(file("model.gltf", mapped(elsewhere, kWhole, kBent)), {}, Texcoords::of_textures,
                   BackFaces::lit_alike, {Highlights::none, MaterialStyle::rich});
  ASSERT_TRUE(imported);
  EXPECT_EQ(imported->warnings, std::vector<std::string>{"1 material drawn without normal maps: a map needs a base "
                                                         "texture at the same coordinates"});
}

TEST_F(GltfSurface, PicturesInWebp) {
  std::uint8_t* out = nullptr;
  const std::uint8_t brick[] = {200, 100, 50};
  const std::size_t size = WebPEncodeLosslessRGB(brick, 1, 1, 3, &out);
  std::string text = square("{" + kUnlit + R"(,"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})", kWhole,
                            std::string(reinterpret_cast<const char*>(out), size));
  WebPFree(out);
  const std::string source = R"("source":0)";
  text.replace(text.find(source), source.size(), R"("extensions":{"EXT_texture_webp":{"source":0}})");
  expect_near(seen(text, kInFront), {200, 100, 50});
}

/// It was named `*0`.
TEST_F(GltfSurface, ATextureThatCannotBeReadIsNamed) {
  const Model plain = model(square(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})", kWhole, "nothing"));
  ASSERT_EQ(plain.warnings.size(), 1U);
  EXPECT_EQ(plain.warnings[0].rfind("texture 'tiles' is not a picture in PNG", 0), 0U) << plain.warnings[0];
}

/// The back was 49 where the front was 165.
/// A wall of two triangles, a lamp before its middle: the picture against the light's definition, in double.
TEST_F(GltfSurface, ALampBeforeALargeWallLightsItsMiddle) {
  GltfData data;
  data.add_floats({-2, -2, 0, 2, -2, 0, 2, 2, 0, -2, 2, 0}, "VEC3");
  data.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  data.add_indices({0, 1, 2, 0, 2, 3});
  // Three dim ones besides, so that no room is left for the light that is added to a file's own.
  const auto wall = [&](double distance) {
    return gltf_of(R"("nodes":[{"mesh":0,"children":[1,2,3,4,5]},{"translation":[0,0,)" + std::to_string(distance) +
                   R"(],"extensions":{"KHR_lights_punctual":{"light":0}}})" +
                   [] {
                     std::string suns;
                     for (int i = 0; i < 4; ++i) {
                       suns += R"(,{"rotation":[0,1,0,0],"extensions":{"KHR_lights_punctual":{"light":1}}})";
                     }
                     return suns;
                   }() +
                   R"(],"extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","intensity":1},)"
                   R"({"type":"directional","intensity":1e-6}]}},"meshes":[{"primitives":[{"indices":2,)"
                   R"("attributes":{"POSITION":0,"NORMAL":1}}]}],)" +
                   data.json());
  };
  const std::string near = wall(2);
  EXPECT_EQ(model(near).materials[0].smooth, Shading::gouraud) << "scene files have lights of their own";
  for (double x = -1.5; x <= 1.5; x += 0.5) {
    for (double y = -1; y <= 1; y += 0.5) {
      const double squared = x * x + y * y + 4;
      const double lamp = 4 / squared * 2 / std::sqrt(squared);  // full light at distance 2
      const int wanted = static_cast<int>(std::lround(255 * std::min(1.0, lamp + 48.0 / 255)));
      expect_near(seen(near, {x, y, 5}, {x, y, 0}), {wanted, wanted, wanted});
    }
  }
  // Far away a lamp lights the wall alike: nothing calls for light at pixels.
  const auto stage = open_stage(file("far.gltf", wall(20)), {}, {}, {64, 48}, 1);
  ASSERT_TRUE(stage);
  const Result<Staging> staging = (*stage)->place(0, 1);
  EXPECT_EQ(staging->scene.materials[0].smooth, Shading::gouraud);
}

TEST_F(GltfSurface, AlphaThatAllVerticesHaveIsTheMaterials) {
  const auto alpha_of = [&](const char* mode, const std::vector<float>& alphas) {
    GltfData data;
    data.add_floats({-1, -1, 0, 1, -1, 0, 1, 1, 0}, "VEC3");
    std::vector<float> colours;
    for (const float alpha : alphas) colours.insert(colours.end(), {1, 1, 1, alpha});
    data.add_floats(colours, "VEC4");
    const Model found = model(
        gltf_of(R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"material":0,"attributes":{"POSITION":0,)"
                R"("COLOR_0":1}}]}],"materials":[{"alphaMode":")" +
                std::string(mode) + R"(","pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.8]}}],)" + data.json()));
    const bool warned = !found.warnings.empty();
    return std::pair(int{found.materials[found.instances[0].material].colour.a}, warned);
  };
  EXPECT_EQ(alpha_of("BLEND", {0.5F, 0.5F, 0.5F}), std::pair(102, false));
  EXPECT_EQ(alpha_of("MASK", {0.5F, 0.5F, 0.5F}), std::pair(102, false));
  EXPECT_EQ(alpha_of("BLEND", {0.5F, 0.5F, 1}), std::pair(204, true));
  EXPECT_EQ(alpha_of("OPAQUE", {0.5F, 0.5F, 1}), std::pair(255, false));
}

TEST_F(GltfSurface, BothSidesAreLitAlike) {
  GltfData data;
  data.add_floats({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, "VEC3");
  data.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  data.add_indices({0, 1, 2, 0, 2, 3});
  // Three dim ones besides, so that no room is left for the light that is added to a file's own.
  const auto lit_from = [&](double z, const std::string& material) {
    std::string lights;
    for (const char* index : {"0", "1", "1", "1"}) {
      lights += R"(,{"rotation":)" + std::string(z > 0 ? "[0,0,0,1]" : "[0,1,0,0]") +
                R"(,"extensions":{"KHR_lights_punctual":{"light":)" + index + "}}}";
    }
    return gltf_of(R"("nodes":[{"mesh":0,"children":[1,2,3,4]})" + lights +
                   R"(],"meshes":[{"primitives":[{"material":0,"indices":2,"attributes":{"POSITION":0,"NORMAL":1}}]}],)"
                   R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"directional"},)"
                   R"({"type":"directional","intensity":0.01}]}},"materials":[)" +
                   material + "]," + data.json());
  };
  const std::string grey =
      R"({"doubleSided":true,"pbrMetallicRoughness":{"baseColorFactor":[0.2140411,0.2140411,0.2140411,1]}})";
  const Rgb front = seen(lit_from(1, grey), kInFront), back = seen(lit_from(-1, grey), kBehind);
  EXPECT_GT(front[1], 100);
  expect_near(back, front);
  const Model both = model(lit_from(1, grey));
  EXPECT_EQ(both.instances.size(), 2U);
  const std::string unlit = R"({"doubleSided":true,"extensions":{"KHR_materials_unlit":{}}})";
  EXPECT_EQ(model(lit_from(1, unlit)).instances.size(), 1U) << "unlit sides look alike anyway";
}

}  // namespace
}  // namespace zstrip::sim::test
