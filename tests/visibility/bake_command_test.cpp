// Visibility methods of `zstrip bake` and `zstrip plan`, as a user runs them.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "command.hpp"

namespace zstrip::test {
namespace {

TEST_F(VisibilityCommand, ATreeIsBakedAndDrawnInPlace) {
  for (const char* scene : {"knot_meshlets", "random50", "cycle"}) {
    const std::string name = std::string(scene) == "cycle" ? std::string("'") + MODELS + "/cycle.obj'" : scene;
    const std::string baked = path("baked.zsc"), words = " --size 160x120 --image raw --visibility painter-bsp";
    const CommandOutcome made = run("bake " + name + " -o '" + baked + "' --size 160x120 --visibility painter-bsp");
    ASSERT_EQ(made.status, 0) << made.text;
    EXPECT_NE(made.text.find("tree of painter-bsp: "), std::string::npos) << made.text;
    EXPECT_NE(made.text.find("visibility painter-bsp: "), std::string::npos) << made.text;
    EXPECT_NE(made.text.find("of z-buffer saved"), std::string::npos) << made.text;
    const CommandOutcome drawn = render("'" + baked + "'" + words + " -o '" + path("baked.raw") + "'");
    ASSERT_EQ(drawn.status, 0) << drawn.text;
    ASSERT_EQ(render(name + words + " -o '" + path("made.raw") + "'").status, 0);
    EXPECT_EQ(read(path("baked.raw")), read(path("made.raw"))) << scene;
    EXPECT_EQ(read(path("baked.raw")).size(), 160U * 120 * 2);
    // In strips, and with the judge.
    ASSERT_EQ(render("'" + baked + "'" + words + " --strip-rows 9 -o '" + path("strips.raw") + "'").status, 0);
    EXPECT_EQ(read(path("baked.raw")), read(path("strips.raw"))) << scene;
    const CommandOutcome judged =
        render("'" + baked + "' --size 160x120 --visibility painter-bsp --show error -o '" + path("error.png") + "'");
    EXPECT_EQ(judged.status, 0) << judged.text;
    // Without the option it is a scene like others.
    EXPECT_EQ(render("'" + baked + "' --size 160x120 -o '" + path("plain.png") + "'").status, 0);
  }
}

/// They were all called sorting, and most were bounds.
TEST_F(VisibilityCommand, BytesOfTwoKindsHaveBothNames) {
  const std::string words = "random50 --size 96x80 --strip-rows 80 --visibility front-to-back-hierarchical-z -o '";
  for (const CommandOutcome& told : {render(words + path("a.png") + "'"), run("bake " + words + path("a.hpp") + "'")}) {
    EXPECT_EQ(told.status, 0) << told.text;
    EXPECT_NE(told.text.find(", sorting and bounds of depth 1,608)"), std::string::npos) << told.text;
  }
}

TEST_F(VisibilityCommand, PlanAndBakeKnowTheMethodsBytes) {
  const auto says = [this](const std::string& command, const char* part) {
    const CommandOutcome outcome = run(command);
    EXPECT_EQ(outcome.status, 0) << command << outcome.text;
    EXPECT_NE(outcome.text.find(part), std::string::npos) << outcome.text;
  };
  says("plan random50 --size 96x80 --strip-rows 80 --visibility painter",
       "painter: 800 bytes for sorting, 15,360 bytes of z-buffer saved");
  says("plan random50 --size 96x80 --strip-rows 80 --visibility painter --json", "\"visibility\": 800");
  says("plan random50 --size 96x80 --strip-rows 80 --visibility hierarchical-z",
       "hierarchical-z: 808 bytes for bounds of depth");
  says("plan random50 --size 96x80 --visibility midpoint", "midpoint: no memory of its own");
  says("plan random50 --size 96x80 --visibility painter-bsp", "painter-bsp: ");
  says("bake random50 --size 96x80 --strip-rows 80 -o '" + path("a.hpp") + "' --visibility front-to-back",
       "front-to-back: 800 bytes for sorting");
  says("bake random50 --size 96x80 --strip-rows 80 -o '" + path("a.hpp") + "' --visibility front-to-back --json -",
       "\"visibility\": 800");
  EXPECT_NE(read(path("a.hpp")).find("zstrip::method::front_to_back"), std::string::npos);
  for (const char* words :
       {"plan room --visibility painter-bsp", "plan blend --visibility painter-newell", "plan room --visibility best",
        "plan room --visibility hierarchical-z --static-layer", "plan room --visibility painter --depth-format z24",
        "bake rooms.toml -o none.zsc --visibility best"}) {
    const CommandOutcome refused = run(words);
    EXPECT_EQ(refused.status, 2) << words << refused.text;
    EXPECT_NE(refused.text.find("--visibility"), std::string::npos) << refused.text;
  }
  const CommandOutcome moving =
      run(std::string("bake '") + ROOMS + "' -o '" + path("none.zsc") + "' --visibility painter-bsp");
  EXPECT_EQ(moving.status, 2) << moving.text;
  EXPECT_NE(moving.text.find("stand still"), std::string::npos) << moving.text;
}

/// The order was of one camera, but the header said how to move the scene.
TEST_F(VisibilityCommand, NewellsOrderIsBakedForOneCameraOnly) {
  const std::string header = path("order.hpp");
  const CommandOutcome turned = run("bake knot_meshlets --turntable --visibility painter-newell -o '" + header + "'");
  EXPECT_EQ(turned.status, 2) << turned.text;
  EXPECT_NE(turned.text.find("leave out --turntable"), std::string::npos) << turned.text;
  EXPECT_FALSE(std::filesystem::exists(header));
  const auto says = [&](const std::string& method, const char* part) {
    const CommandOutcome baked = run("bake random50 -o '" + header + "' --visibility " + method);
    EXPECT_EQ(baked.status, 0) << baked.text;
    return read(header).find(part) != std::string::npos;
  };
  EXPECT_TRUE(says("painter-newell", "camera only: bake again"));
  EXPECT_FALSE(says("painter-newell", "To move the scene"));
  EXPECT_FALSE(says("painter-bsp", "camera only"));
  EXPECT_TRUE(says("painter-bsp", "To move the scene"));
}

}  // namespace
}  // namespace zstrip::test
