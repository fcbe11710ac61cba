// The memory of a picture where the command line does not say how much there is.
#include <cstdint>
#include <nlohmann/json.hpp>

#include "command_fixture.hpp"

namespace zstrip::sim::test {
namespace {

constexpr std::uint64_t kUsual = 24 * 1024;

class Defaults : public Command {
 protected:
  /// The first frame of `render`.
  nlohmann::json frame(const std::string& scene, const std::vector<std::string>& options) const {
    std::vector<std::string> words{"render", scene, "-o", "p.png", "--quiet", "--json", "-"};
    words.insert(words.end(), options.begin(), options.end());
    const Outcome outcome = zstrip(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.status == 0 ? nlohmann::json::parse(outcome.out).at("frames").at(0) : nlohmann::json();
  }
  static std::uint64_t ram(const nlohmann::json& frame) {
    const auto& bytes = frame.at("ram_bytes");
    return bytes.at("arena").get<std::uint64_t>() + bytes.at("strip_pixels").get<std::uint64_t>();
  }
};

/// Took 230 KB for a picture of 240x240.
TEST_F(Defaults, APictureTakes24KilobytesAndHasTheSamePixelsAsInOneStrip) {
  for (const char* scene : {"teapot_meshlets", "room", ZSTRIP_SCENE_FILES "/gallery/watch.toml"}) {
    const nlohmann::json usual = frame(scene, {"--size", "240x240"}),
                         whole = frame(scene, {"--size", "240x240", "--ram", "max"});
    EXPECT_LE(ram(usual), kUsual) << scene;
    EXPECT_GT(usual.at("strips"), 1) << scene;
    EXPECT_EQ(whole.at("strips"), 1) << scene;
    EXPECT_EQ(usual.at("crc32"), whole.at("crc32")) << scene;
  }
}

/// A co5300 accepts only pairs of rows: its picture was one strip, which took 875,136 bytes.
TEST_F(Defaults, APanelThatAcceptsGroupsOfRowsTakes24KilobytesToo) {
  for (const char* panel : {"co5300", "ssd1306"}) EXPECT_LE(ram(frame("teapot", {"--panel", panel})), kUsual) << panel;
}

TEST_F(Defaults, RenderPlanAndBakeTakeTheSameBytes) {
  const std::string model = file("ball.obj", sphere_obj(40, 20));
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{}, {"--ram", "40K"}, {"--ram", "max"}, {"--board", "bluepill"}}) {
    const auto run = [&](std::vector<std::string> words) {
      words.insert(words.end(), options.begin(), options.end());
      const Outcome outcome = zstrip(words);
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      return nlohmann::json::parse(outcome.status == 0 ? outcome.out : "{}");
    };
    const auto planned = run({"plan", model, "--json"}).at("plan").at("bytes");
    // Bins take flash, and bake takes them only where they are asked for.
    const auto streamed = run({"plan", model, "--mode", "streamed", "--json"}).at("plan").at("bytes");
    const auto baked = run({"bake", model, "-o", "ball.hpp", "--quiet", "--json", "-"}).at("plan").at("ram_bytes");
    const nlohmann::json rendered = frame(model, options);
    EXPECT_EQ(rendered.at("ram_bytes").at("arena"), planned.at("arena"));
    // A board with DMA has two strips.
    const std::uint64_t strip = rendered.at("ram_bytes").at("strip_pixels").get<std::uint64_t>();
    const std::uint64_t second = options == std::vector<std::string>{"--board", "bluepill"} ? strip : 0;
    EXPECT_EQ(ram(rendered) + second, planned.at("total").get<std::uint64_t>());
    EXPECT_EQ(baked.at("arena"), streamed.at("arena"));
  }
}

TEST_F(Defaults, ABoardsRamIsTheLimit) {
  const auto total = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{"plan", "knot_meshlets", "--json"};
    words.insert(words.end(), options.begin(), options.end());
    const Outcome outcome = zstrip(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.status == 0 ? outcome.out : "{}")
        .at("plan")
        .at("bytes")
        .at("total")
        .get<int>();
  };
  EXPECT_GT(total({"--board", "bluepill"}), 12 * 1024);
  EXPECT_LE(total({"--board", "bluepill"}), 16 * 1024);
  EXPECT_GT(total({"--board", "pico"}), 64 * 1024);
  EXPECT_LE(total({"--board", "pico", "--ram", "14K"}), 14 * 1024) << "a limit that is given counts";
  const Outcome refused = zstrip({"render", "cube", "--size", "2048x16", "--samples", "4", "--board", "bluepill"});
  EXPECT_EQ(refused.status, 5);
  const Outcome unknown = zstrip({"plan", "cube", "--board", "bluepil"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("bluepill"), std::string::npos) << unknown.err;
}

TEST_F(Defaults, ASceneThatNeedsMoreGetsItUnlessALimitIsGiven) {
  EXPECT_GT(ram(frame("cube", {"--size", "2048x16", "--samples", "4"})), kUsual);
  const Outcome refused = zstrip({"render", "cube", "--size", "2048x16", "--samples", "4", "--ram", "24K"});
  EXPECT_EQ(refused.status, 5);
  EXPECT_NE(refused.err.find("RAM of 24,576 bytes is too little"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace zstrip::sim::test
