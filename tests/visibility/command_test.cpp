// `zstrip render --visibility` and `--show`, as a user runs them.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "command.hpp"

namespace zstrip::test {
namespace {

TEST_F(VisibilityCommand, ThePainterIsWrongAndTheZBufferIsNot) {
  for (const char* model : {"thesis.obj", "cycle.obj", "crossing.obj"}) {
    const std::string words =
        std::string("'") + MODELS + "/" + model + "' --size 96x96 --ortho --orbit 11,0,70 --show error -o '";
    const CommandOutcome painter = render(words + path("painter.png") + "' --visibility painter --sort-key nearest");
    EXPECT_EQ(painter.status, 0) << painter.text;
    EXPECT_EQ(painter.text.find("wrong      0 pixels"), std::string::npos) << painter.text;
    for (const char* method : {"zbuffer", "front-to-back", "hierarchical-z", "painter-newell", "painter-bsp"}) {
      const CommandOutcome right = render(words + path("right.png") + "' --visibility " + method);
      EXPECT_EQ(right.status, 0) << right.text;
      EXPECT_NE(right.text.find("wrong      0 pixels"), std::string::npos) << method << ": " << right.text;
    }
    EXPECT_NE(read(path("painter.png")), read(path("right.png")));
  }
}

TEST_F(VisibilityCommand, HierarchicalZWritesTheSameFile) {
  ASSERT_EQ(render("teapot --size 96x80 --image raw -o '" + path("a.raw") + "'").status, 0);
  const CommandOutcome other =
      render("teapot --size 96x80 --image raw --visibility hierarchical-z -o '" + path("b.raw") + "'");
  EXPECT_NE(other.text.find("bounds of depth"), std::string::npos) << other.text;
  EXPECT_EQ(read(path("a.raw")), read(path("b.raw")));
  EXPECT_FALSE(read(path("a.raw")).empty());
}

TEST_F(VisibilityCommand, ShowsWhatItIsAskedFor) {
  std::string last;
  for (const char* show : {"depth", "overdraw", "tiles", "error", "accuracy"}) {
    const std::string file = path(std::string(show) + ".png");
    const CommandOutcome shown =
        render(std::string("random50 --size 96x80 --visibility hierarchical-z --show ") + show + " -o '" + file + "'");
    EXPECT_EQ(shown.status, 0) << shown.text;
    EXPECT_NE(read(file), last);
    last = read(file);
    EXPECT_FALSE(last.empty());
  }
}

/// All that was lit was white: a shadow is found by writing over depths.
TEST_F(VisibilityCommand, DepthIsShownOfASceneWithShadows) {
  const std::string scene =
      "[picture]\nsize = [96, 80]\n[camera]\nr = 6\nphi = 20\ntheta = 60\n"
      "[[model]]\nname = 'knot'\nbuilt_in = 'knot_lit'\n[[instance]]\nmodel = 'knot'\n[[light]]\ndirection = [1, -1, "
      "0]\n";
  const auto shown = [&](const std::string& text, const std::string& options) {
    std::ofstream(path("scene.toml")) << text;
    const CommandOutcome outcome =
        render("'" + path("scene.toml") + "' --image raw -o '" + path("shown.raw") + "' " + options);
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    return read(path("shown.raw"));
  };
  const std::string with_shadow = scene + "shadow = { size = 256 }\n";
  EXPECT_NE(shown(with_shadow, ""), shown(scene, ""));
  for (const char* options : {"--show depth", "--show tiles --visibility hierarchical-z"}) {
    EXPECT_EQ(shown(with_shadow, options), shown(scene, options)) << options;
  }
}

/// The advice was to leave out --format, which only the scene file had chosen.
TEST_F(VisibilityCommand, DepthIsShownOfScenesWhoseFileChoosesPixels) {
  for (const char* scene : {"chess", "train"}) {
    const CommandOutcome shown = render(std::string("'") + ZSTRIP_SCENE_FILES + "/gallery/" + scene +
                                        ".toml' --show depth --frames 1 -o '" + path("depth.png") + "'");
    EXPECT_EQ(shown.status, 0) << shown.text;
    EXPECT_FALSE(read(path("depth.png")).empty());
  }
  const CommandOutcome given = render("teapot --show depth --format mono -o '" + path("mono.png") + "'");
  EXPECT_EQ(given.status, 2);
  EXPECT_NE(given.text.find("leave out --format"), std::string::npos) << given.text;
}

/// CRC-32 of ISO 3309, bit by bit, as the report writes it.
std::string crc32_words(const std::string& bytes) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const char byte : bytes) {
    crc ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320U : 0U);
  }
  char words[9];
  std::snprintf(words, sizeof words, "%08x", static_cast<unsigned>(~crc));
  return words;
}

/// It was that of the picture without --show.
TEST_F(VisibilityCommand, TheChecksumIsOfWhatIsShown) {
  for (const char* show :
       {"", "--show depth ", "--show overdraw ", "--show tiles ", "--show error ", "--show accuracy "}) {
    const std::string file = path("shown.raw");
    const CommandOutcome shown = render(std::string("random50 --size 96x80 --image raw --visibility hierarchical-z ") +
                                        show + "--json - -o '" + file + "'");
    EXPECT_EQ(shown.status, 0) << shown.text;
    EXPECT_NE(shown.text.find("\"crc32\": \"" + crc32_words(read(file)) + "\""), std::string::npos)
        << show << shown.text;
  }
}

TEST_F(VisibilityCommand, TransparencyGoesWithWhatCanAndIsRefusedByNameElsewhere) {
  const std::string words = "blend --size 96x80 --image raw -o '";
  ASSERT_EQ(render(words + path("plain.raw") + "'").status, 0);
  for (const char* method : {"front-to-back", "hierarchical-z", "half-range"}) {
    const CommandOutcome drawn = render(words + path("other.raw") + "' --visibility " + method);
    EXPECT_EQ(drawn.status, 0) << drawn.text;
    EXPECT_EQ(read(path("plain.raw")), read(path("other.raw"))) << method;
  }
  const CommandOutcome refused = render(words + path("none.raw") + "' --visibility painter-bsp");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.text.find("--visibility painter-bsp cannot draw effects of this scene: blending"),
            std::string::npos)
      << refused.text;
}

/// Of the report of `zstrip render --show accuracy`.
double accuracy_of(const std::string& text, const std::string& key) {
  const std::size_t at = text.find("\"" + key + "\": ", text.find("\"accuracy\""));
  return at == std::string::npos ? -1 : std::stod(text.substr(at + key.size() + 4));
}

TEST_F(VisibilityCommand, TheHeatMapKnowsWhatMakesThePictureMoreLikeTheTruth) {
  const auto report = [this](const std::string& words) {
    const CommandOutcome shown = render(words + " --show accuracy --json - --quiet -o '" + path("heat.png") + "'");
    EXPECT_EQ(shown.status, 0) << shown.text;
    return shown.text;
  };
  const std::string plain = report("knot --size 96x80"), sampled = report("knot --size 96x80 --samples 4"),
                    edged = report("knot --size 96x80 --edges"), mono = report("knot --size 96x80 --format mono");
  EXPECT_GT(accuracy_of(plain, "worst"), accuracy_of(plain, "mean"));
  EXPECT_GT(accuracy_of(plain, "seen_percent"), 0);
  EXPECT_LT(accuracy_of(sampled, "mean"), 0.8 * accuracy_of(plain, "mean"));
  EXPECT_LT(accuracy_of(edged, "mean"), 0.9 * accuracy_of(plain, "mean"));
  EXPECT_GT(accuracy_of(mono, "mean"), 2 * accuracy_of(plain, "mean"));
  // The painter's wrong pixels are seen.
  const std::string cycle =
      std::string("'") + MODELS + "/cycle.obj' --size 96x96 --ortho --orbit 11,0,70 --visibility ";
  const std::string painter = report(cycle + "painter"), right = report(cycle + "zbuffer");
  EXPECT_GT(accuracy_of(painter, "mean"), 1.5 * accuracy_of(right, "mean"));
  EXPECT_GT(accuracy_of(painter, "worst"), 2 * accuracy_of(right, "worst"));
  const CommandOutcome refused =
      render(std::string("'") + ZSTRIP_SCENE_FILES + "/point.toml' --show accuracy -o '" + path("none.png") + "'");
  EXPECT_EQ(refused.status, 4) << refused.text;
  EXPECT_NE(refused.text.find("no truth can be drawn of effects in this scene: punctual_lights (point.toml line"),
            std::string::npos)
      << refused.text;
}

TEST_F(VisibilityCommand, ASceneFileNamesTheMethodAndTheOptionCountsMore) {
  const auto scene = [this](const std::string& method) {
    std::ofstream(path("cycle.toml")) << "[picture]\nsize = [96, 96]\nvisibility = \"" << method
                                      << "\"\n[camera]\nr = 9\nprojection = \"orthographic\"\n[[model]]\nname "
                                         "= \"bars\"\nfile = \""
                                      << MODELS << "/cycle.obj\"\n[[instance]]\nmodel = \"bars\"\n";
    return std::string("'") + path("cycle.toml") + "' --frames 1 -o '";
  };
  const CommandOutcome painter = render(scene("painter") + path("painter.png") + "' --sort-key nearest");
  EXPECT_EQ(painter.status, 0) << painter.text;
  EXPECT_NE(painter.text.find("painter: 0 comparisons"), std::string::npos) << painter.text;
  const CommandOutcome plain = render(scene("painter") + path("plain.png") + "' --visibility zbuffer");
  EXPECT_EQ(plain.status, 0) << plain.text;
  EXPECT_NE(read(path("painter.png")), read(path("plain.png")));
  const CommandOutcome refused = render(scene("best") + path("none.png") + "'");
  EXPECT_EQ(refused.status, 4) << refused.text;
  EXPECT_NE(refused.text.find("'visibility' names no method 'best'; there are zbuffer, painter"), std::string::npos)
      << refused.text;
}

TEST_F(VisibilityCommand, BillboardsHaveNoOrderOfTheirOwn) {
  const std::string scene = path("billboards.toml");
  std::ofstream(scene) << "[[model]]\nname = 'a'\nbuilt_in = 'knot'\n[[instance]]\nmodel = 'a'\nlayer = 'static'\n"
                          "billboard = 'viewer'\n";
  for (const char* method : {"painter-bsp", "painter-newell"}) {
    const CommandOutcome refused = run("render '" + scene + "' -o '" + path("none.png") + "' --visibility " + method);
    EXPECT_EQ(refused.status, 2) << refused.text;
    EXPECT_NE(refused.text.find("billboards cannot be split: they turn with the camera"), std::string::npos)
        << refused.text;
  }
  // The judge of wrong pixels turns them by itself.
  const CommandOutcome drawn = run("render '" + scene + "' --size 64x48 --show error -o '" + path("error.png") + "'");
  EXPECT_EQ(drawn.status, 0) << drawn.text;
  EXPECT_NE(drawn.text.find("wrong      0 pixels"), std::string::npos) << drawn.text;
}

/// It named itself twice, and advised painter-bsp, which may refuse the model as well.
TEST_F(VisibilityCommand, NewellGivesUpInOneSentence) {
  const std::string model = path("floor.obj");
  {
    std::ofstream grid(model);
    constexpr int kSide = 102;  // 2 * 101 * 101 triangles
    for (int i = 0; i < kSide * kSide; ++i) grid << "v " << i % kSide << " 0 " << i / kSide << '\n';
    for (int row = 1; row < kSide; ++row) {
      for (int at = (row - 1) * kSide + 1; at < row * kSide; ++at) {
        grid << "f " << at << ' ' << at + kSide << ' ' << at + 1 << "\nf " << at + 1 << ' ' << at + kSide << ' '
             << at + kSide + 1 << '\n';
      }
    }
  }
  const CommandOutcome refused = render("'" + model + "' --visibility painter-newell -o '" + path("none.png") + "'");
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.text,
            "zstrip: --visibility painter-newell: to order the triangles takes more than 20,000 pieces or 50 million "
            "comparisons; choose another method\n");
}

TEST_F(VisibilityCommand, MessagesNameTheMethodAndTheOptionThatWereGiven) {
  const auto refused = [this](const std::string& words, const char* part) {
    const CommandOutcome outcome = render(words + " -o '" + path("none.png") + "'");
    EXPECT_EQ(outcome.status, 2) << words << outcome.text;
    EXPECT_NE(outcome.text.find(part), std::string::npos) << outcome.text;
  };
  refused("cube --visibility painter-bsp", "--visibility painter-bsp: triangles with textures cannot be split");
  refused("cube --visibility painter-newell", "--visibility painter-newell: triangles with textures cannot be split");
  refused("cube --visibility half-range --cull spheres", "leave out --visibility half-range");
  refused("cube --cull spheres --depth-format z24", "leave out --depth-format");
  refused("cube --visibility painter --depth-format z24", "--visibility painter goes with depth as z16 only");
  refused("teapot --visibility half-range --depth-format z24",
          "--visibility half-range goes with depth as z16 only: leave out --depth-format");
  refused(
      "cube --iterations 3",
      "--iterations means nothing to --visibility zbuffer; leave it out, or choose one of: midpoint, midpoint-safe");
  for (const char* method : {"zbuffer", "half-range", "hierarchical-z", "midpoint", "painter-newell", "painter-bsp"}) {
    refused(std::string("random50 --sort-key nearest --visibility ") + method,
            "leave it out, or choose one of: painter, front-to-back, front-to-back-hierarchical-z");
  }
  refused("cube --cull temporal", "--cull temporal needs the bounds of --visibility hierarchical-z, and not zbuffer");
  refused("cube --cull fronts", "--cull 'fronts' is not one of: back-faces, small, spheres, temporal, none");
}

TEST_F(VisibilityCommand, TemporalCoherenceDrawsTheSameFramesAndIsCounted) {
  const std::string words = "knot_meshlets --size 96x80 --frames 6 --image raw --visibility hierarchical-z --json '" +
                            path("counts.json") + "' -o '";
  ASSERT_EQ(render(words + path("plain") + "'").status, 0);
  EXPECT_EQ(read(path("counts.json")).find("\"drawn_first\": 1"), std::string::npos);
  ASSERT_EQ(render(words + path("coherent") + "' --cull back-faces,small,temporal").status, 0);
  for (int frame = 0; frame < 6; ++frame) {
    const std::string name = "/frame_000" + std::to_string(frame) + ".raw";
    EXPECT_EQ(read(path("plain") + name), read(path("coherent") + name)) << frame;
    EXPECT_EQ(read(path("plain") + name).size(), 96U * 80 * 2);
  }
  const std::string counts = read(path("counts.json"));
  const std::size_t first = counts.find("\"drawn_first\": "), second = counts.find("\"drawn_first\": ", first + 1);
  EXPECT_EQ(counts.substr(first, 17), "\"drawn_first\": 0,") << "nothing is known yet";
  ASSERT_NE(second, std::string::npos);
  EXPECT_NE(counts.substr(second, 17), "\"drawn_first\": 0,");
}

TEST_F(VisibilityCommand, ASceneFileHasTheOptionsToo) {
  const auto scene = [this](const std::string& lines) {
    std::ofstream(path("knot.toml")) << "[picture]\nsize = [96, 80]\n"
                                     << lines
                                     << "[camera]\nr = 3\n[[model]]\nname = 'knot'\nbuilt_in = 'knot_meshlets'\n"
                                        "[[instance]]\nmodel = 'knot'\n";
    return std::string("'") + path("knot.toml") + "' --frames 1 --image raw --json - -o '" + path("a.raw") + "'";
  };
  const CommandOutcome split = render(scene("visibility = 'midpoint'\niterations = 0\n"));
  EXPECT_NE(split.text.find("\"splits\": 0,"), std::string::npos) << split.text;
  const CommandOutcome deeper = render(scene("visibility = 'midpoint'\niterations = 0\n") + " --iterations 3");
  EXPECT_EQ(deeper.text.find("\"splits\": 0,"), std::string::npos) << deeper.text;
  const CommandOutcome usual = render(scene("visibility = 'hierarchical-z'\n"));
  EXPECT_EQ(usual.text.find("\"back_faces\": 0,"), std::string::npos) << usual.text;
  const CommandOutcome none = render(scene("visibility = 'hierarchical-z'\ncull = ['none']\n"));
  EXPECT_NE(none.text.find("\"back_faces\": 0,"), std::string::npos) << none.text;
  const CommandOutcome wide = render(scene("visibility = 'painter'\ndepth_format = 'z24'\n"));
  EXPECT_EQ(wide.status, 2) << wide.text;
  EXPECT_NE(wide.text.find("leave out 'depth_format' in the scene file"), std::string::npos) << wide.text;
  const CommandOutcome temporal = render(scene("cull = ['temporal']\n"));
  EXPECT_EQ(temporal.status, 4) << temporal.text;
  EXPECT_NE(temporal.text.find("knot.toml' line 3: [picture]: 'cull' with temporal needs"), std::string::npos)
      << temporal.text;
  const CommandOutcome other =
      render(scene("visibility = 'hierarchical-z'\ncull = ['temporal']\n") + " --visibility zbuffer");
  EXPECT_EQ(other.status, 2) << other.text;
  EXPECT_NE(other.text.find("the scene file's 'cull' with temporal needs"), std::string::npos) << other.text;
  const CommandOutcome sets = render(scene("visible_sets = 'none.zpv'\n"));
  EXPECT_EQ(sets.status, 4) << sets.text;
  EXPECT_NE(sets.text.find(path("none.zpv")), std::string::npos) << sets.text;
}

TEST_F(VisibilityCommand, WhatCannotBeIsAUsageError) {
  for (const char* words :
       {"teapot --visibility best", "teapot --visibility painter --show depth", "teapot --show tiles",
        "teapot --show what", "teapot --iterations 7", "teapot --visibility painter --depth-format float",
        "teapot --cull none,small", "cube --visibility painter-bsp", "teapot --show depth --format mono",
        "teapot --show accuracy --panel st7789"}) {
    const CommandOutcome refused = render(std::string(words) + " -o '" + path("none.png") + "'");
    EXPECT_EQ(refused.status, 2) << words << ": " << refused.text;
    EXPECT_FALSE(std::filesystem::exists(path("none.png"))) << words;
  }
}

TEST_F(VisibilityCommand, ShadowsGoWithDepthThatTheyCanRead) {
  const std::string scene = ZSTRIP_SCENE_FILES "/shadows.toml";
  const CommandOutcome refused = render("'" + scene + "' --visibility half-range -o '" + path("none.png") + "'");
  EXPECT_EQ(refused.status, 2) << refused.text;
  EXPECT_NE(refused.text.find("'shadows' does not go with --visibility half-range: a shadow is found by what a depth "
                              "code stands for"),
            std::string::npos)
      << refused.text;
}

TEST_F(VisibilityCommand, ErrorsAreNotJudgedWhereTheJudgeDoesNotKnowTheScene) {
  for (const char* scene : {"spheres", "mask", "blend"}) {
    const CommandOutcome refused = render(std::string(scene) + " --show error -o '" + path("none.png") + "'");
    EXPECT_EQ(refused.status, 2) << refused.text;
    EXPECT_NE(refused.text.find("--show error judges opaque triangles"), std::string::npos) << refused.text;
  }
}

}  // namespace
}  // namespace zstrip::test
