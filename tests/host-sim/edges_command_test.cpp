// The command's anti-aliasing of edges: as an option, as a key of scene files, in plans and baked.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "command_fixture.hpp"

namespace zstrip::sim::test {
namespace {

class EdgesCommand : public Command {
 protected:
  nlohmann::json plan_of(const std::vector<std::string>& options) {
    std::vector<std::string> all{"plan", "knot", "--size", "160x120", "--strip-rows", "16", "--json"};
    all.insert(all.end(), options.begin(), options.end());
    const Outcome outcome = zstrip(all);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  }
  std::string refusal(const std::vector<std::string>& arguments) {
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 2);
    return outcome.err;
  }
};

TEST_F(EdgesCommand, AreAnOptionAndAKey) {
  const std::string without = checksum("knot", {"--size", "80x60"});
  const std::string with = checksum("knot", {"--size", "80x60", "--edges"});
  EXPECT_NE(with, without);
  EXPECT_EQ(checksum("knot", {"--size", "80x60", "--edges", "--strip-rows", "5", "--threads", "3"}), with);
  EXPECT_EQ(checksum("knot", {"--size", "80x60", "--edges", "--ram", "44K"}), with);
  EXPECT_EQ(checksum("knot", {"--size", "80x60", "--no-edges"}), without);
  file("knot.toml", "[picture]\nedges = true\n[[model]]\nname = 'k'\nbuilt_in = 'knot'\n[[instance]]\nmodel = 'k'\n");
  const std::string of_file = checksum("knot.toml", {"--size", "80x60"});
  EXPECT_NE(of_file, checksum("knot.toml", {"--size", "80x60", "--no-edges"}));
  ASSERT_EQ(zstrip({"bake", "knot.toml", "-o", "knot.zsc", "--size", "80x60", "--quiet"}).status, 0);
  EXPECT_EQ(checksum("knot.zsc", {"--size", "80x60"}), of_file);
  EXPECT_EQ(checksum("knot.zsc", {"--size", "80x60", "--edges"}), of_file);
  EXPECT_EQ(checksum("knot.zsc", {"--size", "80x60", "--no-edges"}),
            checksum("knot.toml", {"--size", "80x60", "--no-edges"}));
}

TEST_F(EdgesCommand, AreSmoothedInAPictureWithAShadow) {
  file("shadow.toml",
       "[[light]]\ndirection = [0.4, -1, -0.3]\nshadow = { size = 64 }\n"
       "[[model]]\nname = 'k'\nbuilt_in = 'knot'\n[[instance]]\nmodel = 'k'\n");
  const std::string with = checksum("shadow.toml", {"--size", "80x60", "--edges"});
  EXPECT_NE(with, checksum("shadow.toml", {"--size", "80x60"}));
  EXPECT_EQ(checksum("shadow.toml", {"--size", "80x60", "--edges", "--strip-rows", "7"}), with);
  ASSERT_EQ(zstrip({"bake", "shadow.toml", "--edges", "-o", "shadow.zsc", "--size", "80x60", "--quiet"}).status, 0);
  EXPECT_EQ(checksum("shadow.zsc", {"--size", "80x60"}), with);
}

TEST_F(EdgesCommand, AreInThePlan) {
  EXPECT_NE(zstrip({"plan", "knot", "--edges"}).out.find("edges"), std::string::npos);
  EXPECT_NE(plan_of({"--edges"}), plan_of({}));
}

TEST_F(EdgesCommand, WhatDoesNotGoWithThemIsSaid) {
  const auto says = [this](std::vector<std::string> options, const char* words) {
    options.insert(options.begin(), {"render", "knot", "--size", "80x60", "-o", "x.png", "--edges"});
    const std::string said = refusal(options);
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  says({"--samples", "4"}, "smoothed edges and several samples exclude each other");
  says({"--depth-format", "z24"},
       "'edges' does not go with --depth-format: edges are compared with the codes of z16; leave one of them out");
  says({"--visibility", "half-range"}, "'edges' does not go with --visibility half-range: edges are compared with");
  says({"--visibility", "painter"}, "edges");
  says({"--visibility", "hierarchical-z"}, "edges");
  says({"--show", "depth"}, "leave out --edges");
  says({"--cull", "none"}, "--cull and --visible-sets exclude effects of this scene: edges");
  ASSERT_EQ(zstrip({"bake", "knot", "--edges", "-o", "knot.zsc", "--size", "80x60", "--quiet"}).status, 0);
  EXPECT_NE(refusal({"render", "knot.zsc", "-o", "x.png", "--samples", "2"}).find("exclude each other; use --no-edges"),
            std::string::npos);
  EXPECT_NE(refusal({"plan", "knot", "--edges", "--static-layer"}).find("--no-edges"), std::string::npos);
  EXPECT_NE(refusal({"plan", "knot.zsc", "--static-layer"}).find("--no-edges"), std::string::npos);
}

TEST_F(EdgesCommand, WithADepthThatThePlannerChoosesWereRefused) {
  const auto format = [this](const char* edges) {
    return plan_of({"--depth-format", "auto", "--separation", "0.0001", edges})["depth_format"];
  };
  EXPECT_EQ(format("--no-edges"), "z24");
  EXPECT_EQ(format("--edges"), "z16");
}

TEST_F(EdgesCommand, OfASceneAreLeftOutOfWhatIsShownInsteadAndItIsSaid) {
  ASSERT_EQ(zstrip({"bake", "knot", "--edges", "-o", "knot.zsc", "--size", "80x60", "--quiet"}).status, 0);
  const Outcome shown = zstrip({"render", "knot.zsc", "-o", "x.png", "--show", "depth"});
  EXPECT_EQ(shown.status, 0);
  EXPECT_NE(shown.err.find("edges are not smoothed"), std::string::npos);
  EXPECT_EQ(zstrip({"render", "knot.zsc", "-o", "x.png"}).err.find("edges are not smoothed"), std::string::npos);
}

TEST_F(EdgesCommand, BesideOutlinesAndCsgWereBakedAndAnInternalErrorOfRender) {
  const std::string box = "[[instance]]\nname = 'a'\nmodel = 'k'\n";
  const std::string moved = "[[instance]]\nname = 'b'\nmodel = 'k'\ntranslation = [0.3, 0.3, 0.3]\n";
  for (const auto& [part, words] : {std::pair{box + "outline = { width = 2 }\n", "outlines"},
                                    {box + moved + "[[csg]]\nexpression = 'a - b'\n", "CSG"}}) {
    for (const bool is_key : {true, false}) {
      const std::string picture = is_key ? "[picture]\nedges = true\n" : "";
      file("s.toml", picture + "[[model]]\nname = 'k'\nbuilt_in = 'knot_lit'\n" + part);
      for (std::vector<std::string> arguments : {std::vector<std::string>{"render", "s.toml", "-o", "x.png"},
                                                 {"plan", "s.toml"},
                                                 {"bake", "s.toml", "-o", "s.zsc"},
                                                 {"bake", "s.toml", "-o", "s.hpp"}}) {
        if (!is_key) arguments.emplace_back("--edges");
        const std::string said = refusal(arguments);
        EXPECT_NE(said.find(words), std::string::npos) << arguments[0] << ": " << said;
        EXPECT_NE(said.find("--no-edges"), std::string::npos) << arguments[0] << ": " << said;
      }
      EXPECT_EQ(zstrip({"render", "s.toml", "-o", "x.png", "--size", "40x30", "--no-edges"}).status, 0);
    }
  }
}

TEST_F(EdgesCommand, BesideOtherDepthWereRefusedByBakeAndPlanWithoutSayingWhy) {
  for (std::vector<std::string> arguments :
       {std::vector<std::string>{"plan", "knot", "--edges", "--depth-format", "z24"},
        {"bake", "knot.toml", "-o", "knot.hpp"},
        {"plan", "knot.toml"}}) {
    file("knot.toml",
         "[picture]\nedges = true\ndepth_format = 'z24'\n[[model]]\nname = 'k'\nbuilt_in = 'knot'\n"
         "[[instance]]\nmodel = 'k'\n");
    const std::string said = refusal(arguments);
    EXPECT_NE(said.find("'edges' does not go with "), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace zstrip::sim::test
