// zstrip plan as its users see it.
#include <nlohmann/json.hpp>

#include "command_fixture.hpp"

namespace zstrip::sim::test {
namespace {

TEST_F(Command, PlansCountSamples) {
  const auto plan = [&](const char* samples) {
    const Outcome outcome =
        zstrip({"plan", "knot_meshlets", "--size", "160x120", "--strip-rows", "16", "--samples", samples, "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.status == 0 ? outcome.out : "{}");
  };
  const nlohmann::json one = plan("1"), four = plan("4");
  EXPECT_EQ(four.at("samples"), 4);
  const auto bytes = [](const nlohmann::json& report) { return report.at("plan").at("bytes"); };
  EXPECT_EQ(bytes(four).at("depth"), 160 * 16 * 2 * 4);
  EXPECT_EQ(bytes(four).at("colour"), 160 * 16 * 2 * 4);
  EXPECT_EQ(bytes(four).at("arena"), bytes(one).at("arena").get<int>() + 160 * 16 * (2 * 4 - 2 + 2 * 4));
  EXPECT_GT(four.at("plan").at("estimated_m3_instructions"), one.at("plan").at("estimated_m3_instructions"));
}

/// Regression: its bins overflowed, and every frame was streamed.
TEST_F(Command, BinsOfAPlanHoldAFigureThatIsSeenFromItsLargerSide) {
  for (const char* ram : {"72K", "96K", "160K"}) {
    const Outcome outcome = zstrip({"plan", "character", "--size", "240x320", "--ram", ram, "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto plan = nlohmann::json::parse(outcome.out).at("plan");
    EXPECT_EQ(plan.at("mode"), "binned") << ram;
    EXPECT_FALSE(plan.at("bins_overflowed").get<bool>()) << ram;
  }
}

/// Regression: nothing said that estimates know no price of these, and they were up to ten times too low.
TEST_F(Command, PlanSaysWhichEffectsItsEstimateLeavesOut) {
  const auto left_out = [this](const std::vector<std::string>& scene) {
    std::vector<std::string> words{"plan"};
    words.insert(words.end(), scene.begin(), scene.end());
    const std::string text = zstrip(words).out;
    words.emplace_back("--json");
    const auto names = nlohmann::json::parse(zstrip(words).out).at("estimate_leaves_out");
    EXPECT_EQ(text.find("The estimate leaves out: ") == std::string::npos, names.empty()) << text;
    for (const auto& name : names) EXPECT_NE(text.find(name.get<std::string>()), std::string::npos) << text;
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(left_out({"knot_textured"}), Names{});
  EXPECT_EQ(left_out({"teapot", "--samples", "4"}), Names{});
  EXPECT_EQ(left_out({"character"}), Names{});
  EXPECT_EQ(left_out({ZSTRIP_SCENE_FILES "/gallery/robot.toml"}), Names{});
  EXPECT_EQ(left_out({"fog", "--edges"}), Names{});
  EXPECT_EQ(left_out({ZSTRIP_SCENE_FILES "/csg.toml"}), Names{"csg"});
}

/// Regression: frames a second were those of zstrip's own place of the camera, whatever camera a bake was for.
TEST_F(Command, PlanCountsWhatTheCameraOfTheOptionsSees) {
  file("t.obj", kTriangleObj);
  const auto instructions = [this](const std::vector<std::string>& camera) {
    std::vector<std::string> words{"plan", "t.obj", "--size", "160x120", "--json"};
    words.insert(words.end(), camera.begin(), camera.end());
    const Outcome outcome = zstrip(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out).at("plan").at("estimated_m3_instructions").get<int>();
  };
  const int near = instructions({"--eye", "0.3,0.3,1"}), far = instructions({"--eye", "0.3,0.3,20"});
  EXPECT_GT(near, 2 * far) << "it fills the picture, or nearly nothing of it";
  EXPECT_EQ(zstrip({"plan", "t.obj", "--camera", "none"}).status, 4);
  EXPECT_EQ(zstrip({"plan", "teapot", "--light", "0,1,0"}).status, 2);
}

TEST_F(Command, PlanSaysFlashAndFramesASecondOfBoards) {
  const std::string scene = ZSTRIP_SCENE_FILES "/gallery/watch.toml";
  const auto plan = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{"plan", scene, "--ram", "22K", "--json"};
    words.insert(words.end(), options.begin(), options.end());
    return nlohmann::json::parse(zstrip(words).out);
  };
  const auto rate = [](const nlohmann::json& planned, const char* name) {
    for (const auto& board : planned.at("boards")) {
      if (board.at("board") == name) return board.at("frames_a_second");
    }
    return nlohmann::json("no such board");
  };
  const nlohmann::json four = plan({"--samples", "4", "--no-edges"}), one = plan({"--samples", "1", "--no-edges"});
  EXPECT_EQ(rate(four, "microbit"), nullptr) << "it has 16 KB";
  EXPECT_GT(rate(one, "pico").at("least").get<double>(), 1.5 * rate(four, "pico").at("least").get<double>());
  EXPECT_LT(rate(four, "esp32s3").at("least").get<double>(), rate(four, "esp32s3").at("most").get<double>());
  const Outcome baked =
      zstrip({"bake", scene, "-o", path("scene.hpp"), "--ram", "22K", "--samples", "4", "--no-edges", "--json", "-"});
  EXPECT_EQ(four.at("flash_bytes"), nlohmann::json::parse(baked.out).at("flash_bytes").at("total")) << baked.out;
}

TEST_F(Command, PlanListsAPurposeOnlyIfTheSceneHasIt) {
  const auto arena = [this](const std::string& scene) {
    const Outcome outcome = zstrip({"plan", scene, "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out).at("plan").at("bytes");
  };
  EXPECT_EQ(arena("knot").at("effects"), 0);
  EXPECT_EQ(zstrip({"plan", "knot"}).out.find("effects"), std::string::npos);
  for (const char* scene : {"fog", "specular", "punctual", "blend"}) {
    const auto bytes = arena(scene);
    EXPECT_GT(bytes.at("effects"), 0) << scene;
    std::uint64_t sum = 0;
    for (const char* purpose : {"instances", "extents", "vertices", "depth", "colour", "bins", "effects"}) {
      sum += bytes.at(purpose).get<std::uint64_t>();
    }
    EXPECT_EQ(bytes.at("arena"), sum) << scene;
    EXPECT_NE(zstrip({"plan", scene}).out.find("effects"), std::string::npos) << scene;
  }
}

TEST_F(Command, PlanSaysWhatThePictureTakesAndKeepsToTheLimit) {
  const Outcome outcome = zstrip({"plan", "knot_meshlets", "--ram", "16K", "--split-columns", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  const auto& bytes = json.at("plan").at("bytes");
  EXPECT_LE(bytes.at("total"), 16384);
  EXPECT_GT(bytes.at("total"), bytes.at("arena"));
  EXPECT_LT(json.at("plan").at("strip_columns"), 320);
  std::uint64_t sum = 0;
  for (const char* purpose : {"instances", "extents", "vertices", "depth", "colour", "bins", "effects"}) {
    sum += bytes.at(purpose).get<std::uint64_t>();
  }
  EXPECT_EQ(bytes.at("arena"), sum);
  const auto& curve = json.at("curve");
  ASSERT_GT(curve.size(), 5U);
  for (std::size_t i = 1; i < curve.size(); ++i) {
    EXPECT_GT(curve[i].at("bytes").at("total"), curve[i - 1].at("bytes").at("total"));
    EXPECT_LT(curve[i].at("estimated_m3_instructions"), curve[i - 1].at("estimated_m3_instructions"));
  }
  EXPECT_EQ(curve.back().at("strips"), 1);
}

TEST_F(Command, PlanMeasuresTheStaticLayerAndCountsItWhereItIsAskedFor) {
  const Outcome without = zstrip({"plan", "room", "--size", "128x64", "--json"});
  ASSERT_EQ(without.status, 0) << without.err;
  const auto plain = nlohmann::json::parse(without.out);
  EXPECT_EQ(plain.at("plan").at("bytes").at("layer"), 0);
  for (const char* pool : {"depth_bytes", "colour_bytes"}) {
    const auto& bytes = plain.at("static_layer").at(pool);
    EXPECT_GT(bytes.at("average"), 0);
    EXPECT_GE(bytes.at("largest"), bytes.at("average"));
    EXPECT_GE(bytes.at("worst"), bytes.at("largest"));
    EXPECT_EQ(bytes.at("worst"), 8 + 4 * 4 + 128 + 2 * 128 * 64);  // as docs/formats.md says
  }
  const Outcome with = zstrip({"plan", "room", "--size", "128x64", "--static-layer", "--ram", "24K", "--json"});
  ASSERT_EQ(with.status, 0) << with.err;
  const auto json = nlohmann::json::parse(with.out);
  const auto& bytes = json.at("plan").at("bytes");
  const auto& layer = json.at("static_layer");
  EXPECT_EQ(bytes.at("layer"), layer.at("depth_bytes").at("largest").get<int>() +
                                   layer.at("colour_bytes").at("largest").get<int>() + 4 * 8);
  EXPECT_LE(bytes.at("total"), 24 * 1024);
  EXPECT_EQ(json.at("plan").at("strip_rows").get<int>() % 8, 0);
  EXPECT_EQ(zstrip({"plan", "room", "--static-layer", "--depth-format", "z24"}).status, 2);
  EXPECT_EQ(zstrip({"plan", ZSTRIP_SCENE_FILES "/shadows.toml", "--static-layer"}).status, 2);
  EXPECT_EQ(zstrip({"plan", "room", "--static-layer", "--format", "gray4"}).status, 2);
}

TEST_F(Command, PlanAdvisesADepthFormat) {
  const auto advised = [this](std::vector<std::string> words) {
    words.insert(words.begin(), {"plan", "room", "--size", "128x64", "--json"});
    const Outcome outcome = zstrip(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out).at("depth").at("advised_format").get<std::string>();
  };
  EXPECT_EQ(advised({}), "z16");
  EXPECT_EQ(advised({"--separation", "0.0001"}), "z24");
  // Over the whole range of the camera z16 has few codes left where the room is.
  EXPECT_EQ(advised({"--static-layer", "--separation", "0.002"}), "float");
  EXPECT_EQ(zstrip({"plan", "room", "--separation", "0"}).status, 2);
  EXPECT_EQ(zstrip({"plan", "room", "--separation", "nan"}).status, 2);
}

TEST_F(Command, PlanChoosesTheDepthFormat) {
  const auto chosen = [this](std::vector<std::string> words) {
    words.insert(words.begin(),
                 {"plan", "room", "--size", "128x64", "--ram", "max", "--depth-format", "auto", "--json"});
    const Outcome outcome = zstrip(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const nlohmann::json report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report.at("depth").at("advised_format"), report.at("depth_format"));
    return report;
  };
  const nlohmann::json narrow = chosen({}), wide = chosen({"--separation", "0.0001"});
  EXPECT_EQ(narrow.at("depth_format"), "z16");
  EXPECT_EQ(wide.at("depth_format"), "z24");
  EXPECT_EQ(wide.at("plan").at("bytes").at("depth"), 2 * narrow.at("plan").at("bytes").at("depth").get<int>());
  EXPECT_NE(zstrip({"plan", "room", "--depth-format", "auto"}).out.find("depth: z16, chosen"), std::string::npos);
  EXPECT_EQ(zstrip({"plan", "room", "--depth-format", "least"}).status, 2);
}

/// What the scene's file says does not stand in the way: a static layer cannot keep z24, and an empty picture needs
/// no format in particular.
TEST_F(Command, PlanChoosesTheDepthFormatWhateverTheSceneSays) {
  const auto chosen = [this](const char* instances, std::vector<std::string> words) {
    std::string scene = "[[model]]\nname = 'a'\nbuilt_in = 'cube'\n";
    scene += instances;
    scene += "[camera]\neye = [0, 1, 5]\n[picture]\ndepth_format = 'z24'\n";
    file("deep.toml", scene);
    words.insert(words.begin(), {"plan", "deep.toml", "--size", "128x64", "--depth-format", "auto", "--json"});
    const Outcome outcome = run(ZSTRIP_COMMAND, words, path(""));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out).at("depth_format").get<std::string>();
  };
  const char* const cube = "[[instance]]\nmodel = 'a'\n";
  EXPECT_EQ(chosen(cube, {}), "z16");
  EXPECT_EQ(chosen(cube, {"--static-layer"}), "z16");
  EXPECT_EQ(chosen("[[instance]]\nmodel = 'a'\ntranslation = [0, 0, 100]\n", {}), "z16");
}

TEST_F(Command, PlanNamesTheCheapestChangeThatWouldFit) {
  const Outcome rows = zstrip({"plan", "knot_meshlets", "--ram", "16K", "--strip-rows", "120"});
  EXPECT_EQ(rows.status, 5);
  EXPECT_NE(rows.err.find("--strip-rows auto would fit"), std::string::npos) << rows.err;
  const Outcome columns = zstrip({"plan", "knot_meshlets", "--ram", "1500"});
  EXPECT_EQ(columns.status, 5);
  EXPECT_NE(columns.err.find("--split-columns would fit"), std::string::npos) << columns.err;
  const Outcome nothing = zstrip({"plan", "knot_meshlets", "--ram", "800", "--split-columns"});
  EXPECT_EQ(nothing.status, 5);
  EXPECT_NE(nothing.err.find("the smallest needs 888 bytes"), std::string::npos) << nothing.err;
  EXPECT_EQ(zstrip({"plan", "knot_meshlets", "--strip-columns", "12"}).status, 2);
}

/// Ended with an internal error, because the static layer that it looked at cannot keep the z-buffer of shadows.
TEST_F(Command, PlanOfAnySceneFile) {
  for (const auto& entry : std::filesystem::directory_iterator(ZSTRIP_SCENE_FILES)) {
    if (entry.path().extension() != ".toml") continue;
    const Outcome outcome = zstrip({"plan", entry.path().string(), "--size", "64x48", "--json"});
    EXPECT_EQ(outcome.status, 0) << entry.path() << outcome.err;
    if (outcome.status != 0) continue;
    const std::string name = entry.path().stem();
    const bool shadows = name == "shadows" || name == "first", edges = name == "edges";
    const bool samples = name == "anti_aliasing" || name == "overlay" || name == "clips";
    EXPECT_EQ(nlohmann::json::parse(outcome.out).at("static_layer").is_null(), shadows || samples || edges)
        << entry.path();
  }
}

}  // namespace
}  // namespace zstrip::sim::test
