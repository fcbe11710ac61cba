// `--lod`: near, a scene is as it is without; far, it has fewer triangles and looks alike, in blobs, too.
#include <limits>
#include <string>
#include <vector>

#include "reduced_model.hpp"

namespace zstrip::sim::test {
namespace {

class LevelsOfDetail : public ReducedModel {
 protected:
  std::string sphere() {
    texture("colours.tga", 64);
    return textured_sphere(48, 24);
  }
  /// A near sphere and a far one.
  std::string two_spheres() {
    sphere();
    return file("two.toml", R"(background = "#203040"
camera = { eye = [0, 0, 4], look_at = [0, 0, 0], far = 200 }
model = [{ name = "ball", file = "sphere.obj" }]
instance = [{ model = "ball", translation = [-0.5, 0, 0] }, { model = "ball", translation = [12, 4, -60] }]
)");
  }
  Json rendered(const std::string& scene, std::vector<std::string> options) {
    options.insert(options.begin(), {"render", scene, "-o", "p.png", "--size", "160x160"});
    return report(options).at("frames").at(0);
  }
  static std::vector<std::string> from(const char* distance, bool lod) {
    std::vector<std::string> options{"--eye", std::string("0,0,") + distance, "--look-at", "0,0,0"};
    if (lod) options.emplace_back("--lod");
    return options;
  }
};

TEST_F(LevelsOfDetail, NearNothingChangesAndFarThereAreFewerTriangles) {
  const std::string model = sphere();
  EXPECT_EQ(rendered(model, from("1.8", true)).at("crc32"), rendered(model, from("1.8", false)).at("crc32"));
  std::uint64_t last = std::numeric_limits<std::uint64_t>::max();
  for (const char* const distance : {"30", "80"}) {
    const Json whole = rendered(model, from(distance, false)), levels = rendered(model, from(distance, true));
    const auto vertices = [](const Json& frame) { return frame.at("statistics").at("vertices").get<std::uint64_t>(); };
    EXPECT_LT(2 * vertices(levels), vertices(whole)) << distance;
    EXPECT_LE(vertices(levels), last) << "farther is never finer";
    last = vertices(levels);
    const RgbImage a = picture(model, from(distance, false)), b = picture(model, from(distance, true));
    std::size_t covered = 0, off = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
      covered += a.rgb[i] != a.rgb[0] || a.rgb[i + 1] != a.rgb[1];
      off += std::abs(a.rgb[i + 1] - b.rgb[i + 1]) > 24;
    }
    EXPECT_GT(covered, 4U) << distance;
    EXPECT_LE(off, 2 + covered / 8) << "at the outline, where it moves by half a pixel; " << distance;
  }
}

TEST_F(LevelsOfDetail, ABlobHasThemAndSaysWhatTheyTake) {
  const std::string scene = two_spheres();
  const Json plain = report({"bake", scene, "-o", "plain.zsc", "--size", "160x160"});
  const Json baked = report({"bake", scene, "-o", "levels.zsc", "--size", "160x160", "--lod"});
  const Json& levels = baked.at("levels");
  EXPECT_GE(levels.at("coarser_meshes"), 2);
  EXPECT_TRUE(plain.at("levels").is_null());
  EXPECT_EQ(baked.at("flash_bytes").at("total"), read(path("levels.zsc")).size());
  EXPECT_LT(baked.at("flash_bytes").at("total"), 2 * plain.at("flash_bytes").at("total").get<int>());
  EXPECT_EQ(baked.at("plan").at("ram_bytes").at("instances"), 52 * baked.at("counts").at("instances").get<int>());
  EXPECT_EQ(baked.at("plan").at("ram_bytes").at("arena"), plain.at("plan").at("ram_bytes").at("arena"))
      << "planned for the finest";
  const Outcome planned = zstrip({"plan", scene, "--size", "160x160", "--lod", "--json"});
  ASSERT_EQ(planned.status, 0) << planned.err;
  EXPECT_EQ(Json::parse(planned.out).at("level_bytes"), baked.at("plan").at("ram_bytes").at("instances"));

  const Json drawn = rendered("levels.zsc", {});
  EXPECT_EQ(drawn.at("crc32"), rendered(scene, {"--lod"}).at("crc32"));
  EXPECT_NE(drawn.at("crc32"), rendered(scene, {}).at("crc32"));
  EXPECT_LT(drawn.at("statistics").at("vertices"), rendered("plain.zsc", {}).at("statistics").at("vertices"));
  EXPECT_LT(mean_difference(picture(scene, {}), picture("levels.zsc", {})), 0.3);
  EXPECT_EQ(crcs("levels.zsc", {"--size", "160x160"}, 3), crcs(scene, {"--size", "160x160", "--lod"}, 3));

  report({"bake", "levels.zsc", "-o", "again.zsc", "--size", "160x160"});
  EXPECT_EQ(read(path("again.zsc")), read(path("levels.zsc")));
}

TEST_F(LevelsOfDetail, WithSmoothEdgesFarEdgesAreSmoothToo) {
  const std::string scene = two_spheres();
  report({"bake", scene, "-o", "levels.zsc", "--size", "160x160", "--lod", "--edges"});
  EXPECT_LT(mean_difference(picture(scene, {"--edges"}), picture("levels.zsc", {})), 0.3);
}

TEST_F(LevelsOfDetail, AHeaderHasTheTableAndItsProgramChooses) {
  const std::string scene = two_spheres();
  report({"bake", scene, "-o", "scene.hpp", "--size", "160x160", "--lod"});
  const std::string header = read(path("scene.hpp"));
  EXPECT_NE(header.find("inline constexpr zstrip::DetailLevel kLevels["), std::string::npos);
  EXPECT_NE(header.find("zstrip::choose_levels(kLevels, kScene, camera, instances)"), std::string::npos);
  for (const char* const program : {"scene.ino", "scene.cpp"}) {
    report({"bake", scene, "-o", program, "--size", "160x160", "--lod"});
    EXPECT_NE(read(path(program)).find("baked::kTurn, baked::kLevels}"), std::string::npos) << program;
    report({"bake", scene, "-o", program, "--size", "160x160"});
    EXPECT_EQ(read(path(program)).find("kLevels"), std::string::npos) << program;
  }
}

TEST_F(LevelsOfDetail, WithWhatDoesNotKnowThemTheyAreUsageErrors) {
  const std::string model = sphere();
  const auto status = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"bake", model, "-o", "scene.zsc", "--size", "64x48", "--lod"});
    return zstrip(options).status;
  };
  EXPECT_EQ(status({"--ortho"}), 2);
  EXPECT_EQ(status({"--visibility", "painter-bsp"}), 2);
  EXPECT_EQ(status({"--visible-sets", "sets.zvs"}), 2);
  EXPECT_EQ(status({}), 0);
}

}  // namespace
}  // namespace zstrip::sim::test
