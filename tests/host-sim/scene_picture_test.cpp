// How the pixels of a scene file are made: dithered, of samples, of texels of smaller levels, affine.
#include <nlohmann/json.hpp>

#include <set>

#include "command_fixture.hpp"

namespace zstrip::sim::test {
namespace {

class ScenePicture : public Command {};

/// In strips of any height and on any threads, also where the option says what the file does.
TEST_F(ScenePicture, DitheredSceneHasOneChecksum) {
  const std::string scene = ZSTRIP_SCENE_FILES "/dithered.toml";
  const auto drawn = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"render", scene, "-o", "d.png", "--quiet", "--json", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    if (outcome.status != 0) return std::string();
    const auto report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report.at("dither"), options.empty() || options[0] != "--no-dither");
    return report.at("frames").at(0).at("crc32").get<std::string>();
  };
  const std::string golden = drawn({});
  EXPECT_EQ(drawn({"--strip-rows", "1"}), golden);
  EXPECT_EQ(drawn({"--strip-rows", "7", "--strip-columns", "24"}), golden);
  EXPECT_EQ(drawn({"--dither", "--threads", "3", "--strip-rows", "5"}), golden);
  EXPECT_NE(drawn({"--no-dither"}), golden);
}

/// The failure names the line of the clip.
TEST_F(ScenePicture, ClipsThatTheModelLacksAreErrors) {
  const auto message = [&](const std::string& clip) {
    file("clips.toml", "[[model]]\nname = 'a'\nfile = '" ZSTRIP_SCENE_FILES "/figure/figure.gltf'\nclip = [" + clip +
                           "]\n[[instance]]\nmodel = 'a'\n");
    const Outcome outcome = zstrip({"render", "clips.toml", "-o", "a.png"});
    EXPECT_EQ(outcome.status, 4) << outcome.err;
    return outcome.err;
  };
  EXPECT_NE(message("{ animation = 'walk' }, { animation = 'fly' }")
                .find("line 4: [[model.clip]]: there is no animation 'fly' in the file; it has 'walk', 'wave'"),
            std::string::npos);
  EXPECT_NE(message("{ animation = 'walk', seconds = 0.1, fade = 0.2 }")
                .find("line 4: [[model.clip]]: its fade of 0.2 s must end within its 0.1 s"),
            std::string::npos);
  EXPECT_NE(message("{ animation = 'walk', seconds = 3000 }, { animation = 'wave', seconds = 3000 }")
                .find("line 4: [[model.clip]]: all clips together must be 3600 s at most"),
            std::string::npos);
}

/// As many as the option or the scene file says; in strips of any height and on any threads.
TEST_F(ScenePicture, SamplesAreAveraged) {
  const auto report_of = [&](const std::string& scene, const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"render", scene, "-o", "s.png", "--size", "75x58", "--quiet", "--json", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.status == 0 ? outcome.out : "{}");
  };
  const auto checksum = [](const nlohmann::json& report) {
    return report.at("frames").at(0).at("crc32").get<std::string>();
  };
  const nlohmann::json one = report_of("knot", {}), two = report_of("knot", {"--samples", "2"}),
                       four = report_of("knot", {"--samples", "4"});
  EXPECT_EQ(one.at("samples"), 1);
  EXPECT_EQ(two.at("samples"), 2);
  EXPECT_EQ(four.at("samples"), 4);
  // Static layers are refused then, and nothing is said of what they would take.
  const auto plan_of = [&](const char* samples) { return zstrip({"plan", "knot", "--samples", samples}).out; };
  EXPECT_NE(plan_of("1").find("as a static layer"), std::string::npos);
  EXPECT_EQ(plan_of("4").find("as a static layer"), std::string::npos);
  EXPECT_EQ(checksum(report_of("knot", {"--samples", "1"})), checksum(one));
  EXPECT_NE(checksum(two), checksum(one));
  EXPECT_NE(checksum(four), checksum(two));
  EXPECT_GT(four.at("frames").at(0).at("statistics").at("fragments"),
            3 * one.at("frames").at(0).at("statistics").at("fragments").get<int>());
  EXPECT_EQ(checksum(report_of("knot", {"--samples", "4", "--strip-rows", "5", "--threads", "3"})), checksum(four));
  EXPECT_EQ(checksum(report_of("knot", {"--samples", "4", "--strip-rows", "9", "--strip-columns", "24"})),
            checksum(four));
  file("knot.toml", "[picture]\nsamples = 4\n[[model]]\nname = 'k'\nbuilt_in = 'knot'\n[[instance]]\nmodel = 'k'\n");
  EXPECT_EQ(report_of("knot.toml", {}).at("samples"), 4);
  EXPECT_EQ(report_of("knot.toml", {"--samples", "2"}).at("samples"), 2);
}

TEST_F(ScenePicture, SamplesThatCannotBeAreRefused) {
  const auto refusal = [&](const std::vector<std::string>& arguments) {
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.out;
    return outcome.err;
  };
  for (const char* samples : {"0", "3", "8", "-1", "four"}) {
    EXPECT_NE(refusal({"render", "cube", "--samples", samples}).find("--samples"), std::string::npos) << samples;
  }
  EXPECT_NE(refusal({"render", "cube", "--size", "2049x10", "--samples", "2"})
                .find("--samples 2: a picture has at most 4096 samples in a row or column, so that it may be 2048x4096 "
                      "with them, not 2049x10"),
            std::string::npos);
  EXPECT_NE(refusal({"render", "cube", "--samples", "4", "--show", "depth"}).find("use --samples 1"),
            std::string::npos);
  EXPECT_NE(refusal({"plan", "cube", "--samples", "4", "--static-layer"}).find("use --samples 1"), std::string::npos);
}

TEST_F(ScenePicture, MipmapsMayBeTakenAway) {
  const std::string scene = ZSTRIP_SCENE_FILES "/mipmaps.toml";
  EXPECT_EQ(zstrip({"bake", scene, "-o", "p.zsc", "--size", "160x120", "--mipmaps", "off", "--quiet"}).status, 0);
  EXPECT_NE(checksum("p.zsc", {"--size", "160x120"}), checksum(scene, {"--size", "160x120"}));
}

/// Rows of a level floor have one depth, so that only its triangles' corners matter; a room's walls have not.
TEST_F(ScenePicture, TexturesMayBeAffine) {
  const auto drawn = [&](const std::string& scene, const std::string& run, const std::vector<std::string>& options) {
    std::vector<std::string> all{"--size", "160x120", "--perspective", run};
    all.insert(all.end(), options.begin(), options.end());
    return checksum(scene, all);
  };
  const std::string floor = ZSTRIP_SCENE_FILES "/perspective.toml";
  EXPECT_EQ(drawn(floor, "affine", {"--strip-rows", "7"}), checksum(floor, {"--size", "160x120"}));
  EXPECT_EQ(drawn(floor, "16", {}), drawn(floor, "1", {}));
  EXPECT_NE(drawn(floor, "16", {}), drawn(floor, "affine", {}));
  std::set<std::string> different;
  for (const char* run : {"affine", "16", "8", "1"}) different.insert(drawn("room", run, {}));
  EXPECT_EQ(different.size(), 4U);
  EXPECT_EQ(drawn("room", "affine", {"--ortho"}), drawn("room", "1", {"--ortho"}));
}

TEST_F(ScenePicture, AffineTexturesThatCannotBeAreRefused) {
  const auto refusal = [&](const std::vector<std::string>& words) {
    std::vector<std::string> arguments{"render", "cube", "-o", "p.png", "--perspective", "affine"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    return outcome.err;
  };
  for (const auto& [option, value] : {std::pair{"--depth-format", "z24"},
                                      {"--visibility", "hierarchical-z"},
                                      {"--visibility", "half-range"},
                                      {"--cull", "none"}}) {
    const std::string words = refusal({option, value});
    EXPECT_NE(words.find("--perspective"), std::string::npos) << words;
    EXPECT_NE(words.find(option), std::string::npos) << words;
  }
}

TEST_F(ScenePicture, OfProductsOnlyClosedMeshesThatGoTogetherAreDrawn) {
  const std::string part =
      "[[model]]\nname = 'm'\nfile = 'm.obj'\n[[material]]\nname = 'glass'\nalpha_mode = 'blend'\n"
      "[[csg]]\nexpression = 'a'\n[[instance]]\nmodel = 'm'\nname = 'a'\n";
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const auto said = [&](const std::string& faces, const std::string& more) {
    file("m.obj", corners + faces);
    const auto drawn = zstrip({"render", file("part.toml", part + more), "-o", "part.png", "--size", "32x24"});
    EXPECT_EQ(drawn.status != 0, drawn.err.find("line 8: [[csg]]: ") != std::string::npos) << drawn.err;
    return drawn.err;
  };
  const auto has = [](const std::string& text, const char* what) { return text.find(what) != std::string::npos; };
  const std::string closed = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  EXPECT_FALSE(has(said(closed, ""), "[[csg]]"));
  EXPECT_TRUE(has(said("f 1 3 2\nf 1 2 4\nf 2 3 4\n", ""), "'a' has 3 open edges"));
  EXPECT_TRUE(has(said(closed, "material = 'glass'\n"), "a material that is not opaque"));
  EXPECT_TRUE(has(said(closed, "outline = {}\n"), "an outline"));
  EXPECT_TRUE(has(said(closed, "billboard = 'upright'\n"), "a billboard"));
  EXPECT_TRUE(has(said(closed, "layer = 'static'\n"), "lies in the static layer"));
  EXPECT_TRUE(has(said(closed, "[[light]]\ndirection = [0, -1, 0]\nshadow = {}\n"), "shadow of a light"));
}

// A misspelt one replaced nothing, in silence.
TEST_F(ScenePicture, MaterialsThatTheModelDoesNotHaveAreRefused) {
  file("m.mtl", "newmtl tiles\nKd 1 1 1\n");
  file("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl tiles\nf 1 2 3\n");
  const auto drawn_with = [&](const std::string& name) {
    return zstrip({"render",
                   file("s.toml",
                        "[[model]]\nname = 'm'\nfile = 'm.obj'\n[[material]]\nname = 'red'\n"
                        "[[instance]]\nmodel = 'm'\nmaterials = { '" +
                            name + "' = 'red' }\n"),
                   "-o", "s.png", "--size", "32x24"});
  };
  EXPECT_EQ(drawn_with("tiles").status, 0);
  const auto wrong = drawn_with("tilse");
  EXPECT_EQ(wrong.status, 4);
  EXPECT_NE(wrong.err.find("line 6: [[instance]]: 'materials' names no material 'tilse' of the model 'm'; did you mean "
                           "'tiles'?"),
            std::string::npos)
      << wrong.err;
}

TEST_F(ScenePicture, MipmapsOfAMaterialWithoutTextureAreRefused) {
  const std::string scene = file("m.toml",
                                 "[[model]]\nname = 'pot'\nbuilt_in = 'teapot'\n"
                                 "[[material]]\nname = 'clay'\nmipmaps = true\n"
                                 "[[instance]]\nmodel = 'pot'\nmaterial = 'clay'\n");
  const Outcome outcome = zstrip({"render", scene, "-o", "p.png"});
  EXPECT_NE(outcome.status, 0);
  EXPECT_NE(outcome.err.find("line 6: material 'clay' has mipmaps, but neither a texture of its own nor one of the "
                             "model 'pot'"),
            std::string::npos)
      << outcome.err;
}

/// The command aborted.
TEST_F(ScenePicture, AnOutlineOfAModelThatIsTooSmallIsLeftOutWithAWarning) {
  file("cube.obj", cube_obj());
  const std::string model = "[[model]]\nname = 'c'\nfile = 'cube.obj'\n[[instance]]\nmodel = 'c'\n";
  for (const char* size : {"scale = 1e-6\n", "scale = [1e-6, 1e-6, 1]\n"}) {
    file("scene.toml", model + "[[instance]]\nmodel = 'c'\noutline = { width = 2 }\n" + size);
    const Outcome outcome = zstrip({"render", "scene.toml", "-o", "small.png", "--quiet"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err,
              "zstrip: warning: 'scene.toml' line 8: [instance.outline] is left out: the model is too small for this "
              "scene\n");
  }
  file("plain.toml", model);
  file("scene.toml", model + "outline = { colour = '#ff0000' }\n[[instance]]\nmodel = 'c'\nscale = 1e-6\n");
  EXPECT_NE(checksum("scene.toml", {}), checksum("plain.toml", {})) << "a model of usual size keeps its outline";
}

}  // namespace
}  // namespace zstrip::sim::test
