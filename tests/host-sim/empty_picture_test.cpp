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
  const std::string far = "times as long as the part where most of it lies; take out the parts far away";
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
      const Outcome outcome = zstrip({"render", name, "-o", output, "--quiet", "--background", "000000"});
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

/// The camera was said not to see it.
TEST_F(Command, WhatIsSmallerThanAPixelIsCalledSo) {
  file("cube.obj", cube_obj());
  file("dot.toml",
       "[[material]]\nname = 'a'\n[[ellipsoid]]\nmaterial = 'a'\nradius = 0.001\ntranslation = [1, 0, 0]\n"
       "[[ellipsoid]]\nmaterial = 'a'\nradius = 0.001\n[camera]\nlook_at = [0.5, 0, 0]\nr = 30\n");
  const std::vector<std::string> far{"render", "cube.obj", "-o", "a.png", "--quiet", "--orbit"};
  const auto said = [&](const std::vector<std::string>& arguments, const std::string& words) {
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.err.find("zstrip: warning: no pixel was drawn: " + words), std::string::npos) << outcome.err;
  };
  const auto with = [](std::vector<std::string> arguments, std::initializer_list<const char*> more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  const std::string small = "all that the camera sees is smaller than a pixel; bring it nearer",
                    out = "the camera does not";
  said(with(far, {"2000,0,45"}), small);
  said(with(far, {"2000,0,45", "--ortho"}), small);
  said(with(far, {"2000,0,45", "--look-at", "5000,0,0"}), out);
  said({"render", "dot.toml", "-o", "a.png", "--quiet"}, small);
  said({"render", "cube.obj", "-o", "a.png", "--quiet", "--eye", "0,0,4", "--look-at", "0,0,8"}, out);
  said({"render", "cube.obj", "-o", "a.png", "--quiet", "--eye", "0.1,0,0", "--look-at", "0,0,0"}, out);
}

}  // namespace
}  // namespace zstrip::sim::test
