// Pictures in which nothing of the scene is seen: the warning has the cause.
#include <fmt/format.h>

#include "command_fixture.hpp"
#include "gltf_file.hpp"

namespace zstrip::sim::test {
namespace {

/// Of a square.
std::string with_material(const std::string& material, const std::vector<std::uint8_t>& texel = {}) {
  const std::string picture = texel.empty() ? "" : rgba_png(1, 1, texel);
  return GltfFile{.materials = {material}, .nodes = {R"({"mesh":0})"}, .pictures = picture}.text();
}

/// Many small triangles, and one with a corner far away.
std::string with_far_corner(const std::string& far) {
  return sphere_obj(16, 8) + fmt::format("v {} 0 0\nf 1 2 -1\n", far);
}

/// What alpha hid was silent; where one vertex was far away the camera was blamed.
TEST_F(Command, EmptyPicturesSayWhy) {
  const std::string textured = R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0}})";
  const std::string faint = R"("pbrMetallicRoughness":{"baseColorFactor":[1,0,0,0.1]})";
  const std::string nothing = R"("pbrMetallicRoughness":{"baseColorFactor":[1,0,0,0]})";
  const std::string black = R"("pbrMetallicRoughness":{"baseColorFactor":[0,0,0,1]})";
  const std::string below = "nothing is seen in the picture: the alpha of material 'leaf' is below its cutoff";
  const std::string zero = "nothing is seen in the picture: the alpha of material 'glass' is 0";
  const std::string dark = "nothing is seen in the picture: all that is drawn has the colour of the background";
  const std::string far = "times as long as where most of it lies; take out what lies far away";
  const struct {
    std::string name, content, words;  // without words no warning
  } cases[] = {
      {"mask.gltf", with_material(R"({"name":"leaf","alphaMode":"MASK",)" + faint + "}"), below},
      {"never.gltf", with_material(R"({"name":"leaf","alphaMode":"MASK","alphaCutoff":2})"), below},
      {"masktexels.gltf", with_material(R"({"name":"leaf","alphaMode":"MASK",)" + textured + "}", {9, 9, 9, 60}),
       below},
      {"blend.gltf", with_material(R"({"name":"glass","alphaMode":"BLEND",)" + nothing + "}"), zero},
      {"blendtexels.gltf", with_material(R"({"name":"glass","alphaMode":"BLEND",)" + textured + "}", {9, 9, 9, 0}),
       zero},
      {"unnamed.gltf", with_material(R"({"alphaMode":"BLEND",)" + nothing + "}"), "the alpha of its material is 0"},
      {"black.gltf", with_material("{" + black + "}"), dark},
      {"opaque.gltf", with_material("{" + nothing + "}"), ""},
      {"seen.gltf", with_material(R"({"alphaMode":"BLEND",)" + faint + "}"), ""},
      {"near.obj", with_far_corner("10"), ""},
      {"far.obj", with_far_corner("1e4"), far},
      {"farther.obj", with_far_corner("1e9"), far},
      {"farthest.obj", with_far_corner("1e30"), "a trillion or more " + far},
  };
  for (const auto& [name, content, words] : cases) {
    file(name, content);
    for (const char* output : {"one.png", "turn/"}) {
      const Outcome outcome = zstrip({"render", name, "-o", output, "--quiet"});
      EXPECT_EQ(outcome.status, 0) << name;
      if (words.empty()) {
        EXPECT_EQ(outcome.err, "") << name;
        continue;
      }
      EXPECT_NE(outcome.err.find(words), std::string::npos) << name << ": " << outcome.err;
      EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
      EXPECT_EQ(outcome.err.find("camera"), std::string::npos) << outcome.err;
    }
  }
  // Nothing wrong is black, too.
  EXPECT_EQ(zstrip({"render", "opaque.gltf", "--show", "error", "-o", "one.png", "--quiet"}).err, "");
}

}  // namespace
}  // namespace zstrip::sim::test
