// Where `zstrip bake` leaves clipping out of a header, and why not.
#include "bake_fixture.hpp"

namespace zstrip::sim::test {
namespace {

/// What a header's kEffects say of clipping, and why.
class BakeClipping : public Bake {
 protected:
  /// The report on clipping. It agrees with the header.
  Json clipping(const std::string& scene, const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"bake", scene, "-o", "scene.hpp"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Json baked = report(arguments);
    const bool in_header = read(path("scene.hpp")).find(" | zstrip::effect::unclipped") != std::string::npos;
    const bool in_effects = baked.at("effects").dump().find("\"unclipped\"") != std::string::npos;
    EXPECT_EQ(in_header, baked.at("clipping").at("left_out")) << scene;
    EXPECT_EQ(in_effects, baked.at("clipping").at("left_out")) << scene;
    return baked.at("clipping");
  }
  std::string why(const std::string& scene, const std::vector<std::string>& options) {
    const Json found = clipping(scene, options);
    EXPECT_FALSE(found.at("left_out")) << scene;
    return found.at("why");
  }
  int poses(const std::string& scene, const std::vector<std::string>& options) {
    const Json found = clipping(scene, options);
    EXPECT_TRUE(found.at("left_out")) << scene << ": " << found.at("why");
    return found.at("poses");
  }
};

TEST_F(BakeClipping, IsLeftOutWhereTheWholeMotionIsInFrontOfTheCamera) {
  EXPECT_EQ(poses(kHouseModel, {"--turntable"}), 65536) << "an angle has 16 bits";
  EXPECT_EQ(poses(kHouseModel, {"--turntable", "--samples", "4", "--mode", "binned"}), 65536);
  EXPECT_EQ(poses(kHouseModel, {"--turntable", "--edges"}), 65536);
  EXPECT_EQ(poses(ZSTRIP_SCENE_FILES "/table.toml", {}), 6000) << "the milliseconds of its animation";
  EXPECT_NE(read(path("scene.hpp")).find("in any of the 6,000 milliseconds of the animation.\n"), std::string::npos);
  // Many instances, two for each sheet, are checked in fewer poses, boards' among them.
  std::string crowd;
  for (int i = 0; i < 50; ++i) crowd += "usemtl m" + std::to_string(i) + '\n' + kTriangleObj;
  EXPECT_EQ(poses(file("crowd.obj", crowd), {"--turntable"}), 32768);
}

TEST_F(BakeClipping, StaysWhereSomethingComesTooNear) {
  EXPECT_EQ(why(kHouseModel, {"--turntable", "--orbit", "2,30,60"}),
            "instance 0 crosses the near plane in frame 11 of 64 of a rotation");
  EXPECT_EQ(why("room", {"--turntable"}), "instance 0 crosses the near plane in frame 0 of 64 of a rotation");
  EXPECT_EQ(why(ZSTRIP_SCENE_FILES "/perspective.toml", {"--turntable"}),
            "instance 0 leaves the thousand pixels around the picture's centre in frame 6 of 64 of a rotation");
  const Outcome words = zstrip({"bake", kHouseModel, "-o", "scene.hpp", "--turntable", "--orbit", "2,30,60"});
  EXPECT_NE(words.out.find("  clipping   stays: instance 0 crosses the near plane in frame 11 of 64 of a rotation\n"),
            std::string::npos)
      << words.out;
}

/// The header of `edges` draws the pixels of all edges (BakedHeader).
TEST_F(BakeClipping, EdgesThatTheMotionNeverShowsTakeNoFlash) {
  const auto edges = [&](const std::string& output, const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"bake", kHouseModel, "-o", output, "--edges"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Json baked = report(arguments);
    return std::pair<int, int>{baked.at("flash_bytes").at("edges"), baked.at("edges_left_out")};
  };
  const auto [kept, left_out] = edges("scene.hpp", {"--turntable"});
  EXPECT_GT(left_out, 0);
  EXPECT_NE(read(path("scene.hpp")).find("--clipping on keeps them"), std::string::npos);
  const std::pair all{kept + 8 * left_out, 0};
  EXPECT_EQ(edges("scene.hpp", {"--turntable", "--clipping", "on"}), all) << "the program moves otherwise";
  EXPECT_EQ(edges("scene.hpp", {}), all) << "it is not known how the scene moves";
  EXPECT_EQ(edges("scene.zsc", {"--turntable"}), all) << "a blob is shown from anywhere";
}

TEST_F(BakeClipping, StaysWhereItIsAskedForOrNothingIsKnown) {
  EXPECT_EQ(why(kHouseModel, {"--turntable", "--clipping", "on"}), "--clipping on");
  EXPECT_EQ(why(kHouseModel, {}), "without --turntable it is not known how the scene moves");
  EXPECT_EQ(why(ZSTRIP_SCENE_FILES "/outlines.toml", {"--turntable"}),
            "outlines need it: hulls reach beyond the boxes of their instances");
  EXPECT_EQ(report({"bake", kHouseModel, "-o", "scene.zsc", "--turntable"}).at("clipping"), nullptr)
      << "of a blob the program decides";
  EXPECT_EQ(zstrip({"bake", kHouseModel, "-o", "scene.hpp", "--clipping", "off"}).status, 2);
}

}  // namespace
}  // namespace zstrip::sim::test
