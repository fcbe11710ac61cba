// Light that `zstrip bake --lighting baked` stores in colours of vertices: the same pixels for less flash, and only
// where nothing moves.
#include "reduced_model.hpp"

namespace zstrip::sim::test {
namespace {

class BakedLight : public ReducedModel {
 protected:
  Json bake(const std::string& scene, const std::string& lighting, std::vector<std::string> options = {}) {
    options.insert(options.begin(), {"bake", scene, "-o", lighting + ".zsc", "--lighting", lighting});
    return report(options);
  }
  static bool has_lighting(const Json& baked) {
    return std::ranges::any_of(baked.at("effects"), [](const Json& e) { return e.at("name") == "lighting"; });
  }
};

TEST_F(BakedLight, PixelsAtRestAreTheSameForLessFlash) {
  texture("colours.tga", 16);
  const std::string model = textured_sphere(16, 8);
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{}, std::vector<std::string>{"--light=1,-1,0.3", "--eye", "3,-2,4"}}) {
    std::vector<std::string> folded{"--texture-size", "0"};
    folded.insert(folded.end(), options.begin(), options.end());
    const Json drawn = bake(model, "drawn", folded), baked = bake(model, "baked", folded);
    EXPECT_EQ(baked.at("light_baked"), 2);
    EXPECT_TRUE(has_lighting(drawn));
    EXPECT_FALSE(has_lighting(baked));
    EXPECT_EQ(baked.at("flash_bytes").at("normals"), 0);
    EXPECT_LT(baked.at("flash_bytes").at("total"), 0.85 * drawn.at("flash_bytes").at("total").get<double>());
    EXPECT_EQ(crcs("baked.zsc", {}, 1), crcs("drawn.zsc", {}, 1));
  }
}

TEST_F(BakedLight, TheCameraGoesAroundASceneThatWouldTurn) {
  texture("colours.tga", 16);
  const std::string model = textured_sphere(16, 8);
  bake(model, "baked", {"--texture-size", "0", "--light", "1,0,0"});
  const std::vector<std::string> seen = crcs("baked.zsc", {}, 4);
  EXPECT_NE(seen[1], seen[3]) << "the lit side turns away";
  report({"bake", model, "-o", "scene.hpp", "--lighting", "baked", "--texture-size", "0"});
  EXPECT_NE(read(path("scene.hpp")).find("Turning::camera"), std::string::npos);
}

TEST_F(BakedLight, TexturesStayLit) {
  texture("colours.tga", 16);
  const std::string model = textured_sphere(16, 8);
  EXPECT_EQ(bake(model, "drawn").at("light_baked"), 0);
  EXPECT_EQ(bake(model, "baked").at("light_baked"), 0);
  EXPECT_EQ(read(path("baked.zsc")), read(path("drawn.zsc")));
}

TEST_F(BakedLight, PointLightsShadowsAndWhatMovesStayLit) {
  for (const char* name : {"point", "shadows", "csg", "specular", "outlines", "per_pixel"}) {
    const std::string scene = std::string(ZSTRIP_SCENE_FILES) + "/" + name + ".toml";
    const Json drawn = bake(scene, "drawn"), baked = bake(scene, "baked");
    EXPECT_EQ(has_lighting(baked), has_lighting(drawn)) << name;
    EXPECT_EQ(crcs("baked.zsc", {}, 1), crcs("drawn.zsc", {}, 1)) << name;
  }
  // Frames of an animation: parts that move are lit as they move.
  const std::string scene = ZSTRIP_SCENE_FILES "/clips.toml";
  bake(scene, "drawn"), bake(scene, "baked");
  EXPECT_EQ(crcs("baked.zsc", {}, 4), crcs("drawn.zsc", {}, 4));
}

/// Skins refer to meshes by their address: blobs of clips could not be opened.
TEST_F(BakedLight, ClipsOfSkinsAndMorphTargetsMoveAsWithoutIt) {
  for (const std::string name : {"talker", "walker"}) {
    const std::string scene = BAKE_MODELS "/" + name + ".toml";
    bake(scene, "drawn"), bake(scene, "baked");
    EXPECT_EQ(crcs("baked.zsc", {}, 4), crcs("drawn.zsc", {}, 4)) << name;
  }
}

/// An unlit material of another alpha than 255 rounds colours of vertices: pixels were darker by one step.
TEST_F(BakedLight, TranslucentMaterialsStayLit) {
  const std::string model = textured_sphere(16, 8);
  file("sphere.mtl", "newmtl upper\nKd 0.7 0.3 0.1\nd 0.6\nnewmtl lower\nKd 0.7 0.3 0.1\n");
  bake(model, "drawn");
  EXPECT_EQ(bake(model, "baked").at("light_baked"), 1);
  EXPECT_EQ(crcs("baked.zsc", {}, 1), crcs("drawn.zsc", {}, 1));
}

}  // namespace
}  // namespace zstrip::sim::test
