// `zstrip bake` of what bends: skins, morph targets, clips and events, in headers and blobs.
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "bake_fixture.hpp"

namespace zstrip::sim::test {
namespace {

/// A blob has all animations of its file, or the one that was chosen.
TEST_F(Bake, BlobsDrawTheClipsOfAFigure) {
  const std::string figure = ZSTRIP_SCENE_FILES "/figure/figure.gltf";
  const Json baked = report({"bake", figure, "-o", "figure.zsc"});
  EXPECT_EQ(crcs("figure.zsc", {}, 7), crcs(figure, {}, 7));
  report({"bake", figure, "-o", "wave.zsc", "--animation", "wave"});
  EXPECT_EQ(crcs("wave.zsc", {}, 7), crcs(figure, {"--animation", "wave"}, 7));
  EXPECT_EQ(crcs("wave.zsc", {"--animation", "wave"}, 7), crcs("wave.zsc", {}, 7));
  EXPECT_NE(crcs("figure.zsc", {"--animation", "wave"}, 3), crcs("figure.zsc", {}, 3));
  const Outcome unknown = run(ZSTRIP_COMMAND, {"render", "figure.zsc", "--animation", "run"}, path(""));
  EXPECT_EQ(unknown.status, 4);
  EXPECT_NE(unknown.err.find("it has 'walk', 'wave'"), std::string::npos) << unknown.err;
  // The RAM of a meshlet's vertices and of the joints.
  const Json& ram = baked.at("plan").at("ram_bytes");
  EXPECT_EQ(ram.at("moved_vertices"), 64 * 10);
  EXPECT_EQ(ram.at("joints"), 16 * 80);
  const Json& flash = baked.at("flash_bytes");
  EXPECT_EQ(flash.at("total"), std::filesystem::file_size(path("figure.zsc")));
}

/// A blob of a scene file has one clip: the sequence of the file's clips, and the motion of the other models.
TEST_F(Bake, SceneFilesBendOneModel) {
  for (const std::string name : {"walker", "talker"}) {
    const std::string scene = BAKE_MODELS "/" + name + ".toml";
    report({"bake", scene, "-o", name + ".zsc", "--no-edges"});
    const std::vector<std::string> frames = crcs(scene, {"--no-edges"}, 7);
    EXPECT_EQ(crcs(name + ".zsc", {}, 7), frames) << name;
    EXPECT_EQ(std::set<std::string>(frames.begin(), frames.end()).size(), 7U) << name;
    EXPECT_EQ(crcs(scene, {"--no-edges", "--strip-rows", "7", "--threads", "3"}, 7), frames) << name;
  }
  const auto message = [this](const std::string& instance, int status) {
    const std::string figure = "file = '" ZSTRIP_SCENE_FILES "/figure/figure.gltf'\n";
    file("bent.toml", "[[model]]\nname = 'a'\n" + figure + "[[model]]\nname = 'b'\n" + figure +
                          "[[instance]]\nmodel = 'a'\n" + instance);
    const Outcome outcome = zstrip({"render", "bent.toml", "-o", "bent.png", "--quiet"});
    EXPECT_EQ(outcome.status, status) << outcome.err;
    return outcome.err;
  };
  EXPECT_EQ(message("", 0), "") << "'b' is not in the picture";
  EXPECT_NE(message("[[instance]]\nmodel = 'b'\n", 0)
                .find("model 'b': it does not bend, because a scene bends only one model, 'a'"),
            std::string::npos);
  EXPECT_NE(message("layer = 'static'\n", 4).find("static layer cannot have an animation"), std::string::npos);
  EXPECT_NE(message("outline = { width = 2 }\n", 4).find("an outline does not bend"), std::string::npos);
  EXPECT_NE(message("scale = [1, 2, 1]\n", 4).find("can only be scaled evenly"), std::string::npos);
}

/// The outlines of a model that bends, by itself and placed by a scene file of another scale: a few pixels differ.
TEST_F(Bake, SceneFilesBendAsTheModelAlone) {
  struct View {
    const char *model, *eye, *target;
  };
  for (const auto& [model, eye, target] : {View{BAKE_MODELS "/morph_face.gltf", "4,3,9", "0,0.8,0"},
                                           View{BAKE_MODELS "/morph_bending.gltf", "4,3,9", "0,0.8,0"},
                                           View{ZSTRIP_SCENE_FILES "/figure/figure.gltf", "2,2,4", "0,0.8,0"}}) {
    file("scene.toml", std::string("background = '#ffffff'\ncamera = { eye = [") + eye + "], look_at = [" + target +
                           "], field_of_view = 40 }\n[[model]]\nname = 'a'\nfile = '" + model +
                           "'\n[[model]]\nname = 'b'\nbuilt_in = 'cube'\n[[instance]]\nmodel = 'a'\n"
                           "[[instance]]\nmodel = 'b'\ntranslation = [0, 0, 90]\n");  // behind the camera
    const auto frames = [this, model = model](const std::string& scene, std::vector<std::string> options) {
      std::vector<std::string> arguments{"render",   scene,       "-o",      scene == model ? "alone" : "placed",
                                         "--frames", "6",         "--size",  "160x120",
                                         "--format", "rgb565",    "--image", "raw",
                                         "--quiet",  "--no-edges"};
      arguments.insert(arguments.end(), options.begin(), options.end());
      const Outcome outcome = zstrip(arguments);
      EXPECT_EQ(outcome.status, 0) << outcome.err;
    };
    frames(model, {"--eye", eye, "--look-at", target, "--fov", "40", "--background", "ffffff"});
    frames("scene.toml", {});
    for (int i = 0; i < 6; ++i) {
      const std::string name = "/frame_000" + std::to_string(i) + ".raw";
      const std::string alone = read(path("alone" + name)), placed = read(path("placed" + name));
      ASSERT_EQ(alone.size(), 160U * 120 * 2);
      ASSERT_EQ(placed.size(), alone.size());
      int drawn = 0, different = 0;
      for (std::size_t at = 0; at < alone.size(); at += 2) {
        const bool first = alone.substr(at, 2) != "\xFF\xFF", second = placed.substr(at, 2) != "\xFF\xFF";
        drawn += first;
        different += first != second;
      }
      EXPECT_GT(drawn, 300) << model;
      EXPECT_LE(different, drawn / 50) << model << " frame " << i;
    }
  }
}

/// A model that is the whole scene moves as finely as alone: joints were 16 times coarser in every scene.
TEST_F(Bake, TheMotionOfAModelThatIsTheWholeSceneIsAsFineAsAlone) {
  const std::string figure = ZSTRIP_SCENE_FILES "/figure/figure.gltf";
  file("alone.toml", "[[model]]\nname = 'a'\nfile = '" + figure + "'\n[[instance]]\nmodel = 'a'\n");
  const auto keyframes = [this](const std::string& scene) {
    return report({"bake", scene, "-o", "scene.hpp"}).at("flash_bytes").at("keyframes").get<double>();
  };
  EXPECT_NEAR(keyframes("alone.toml") / keyframes(figure), 1, 0.05);
}

TEST_F(Bake, HeadersHaveTheEventsOfTheirMotion) {
  report({"bake", BAKE_MODELS "/talker.toml", "-o", "talker.hpp"});
  const std::string header = read(path("talker.hpp"));
  EXPECT_NE(header.find("inline constexpr zstrip::ClipEvent kEvents[2] = {\n    {0, 65535, 0}, {0, 5, 1200}};"),
            std::string::npos);
  EXPECT_NE(header.find("#include \"zstrip/clips.hpp\""), std::string::npos);
}

/// The command says what keeps a skin still, and refuses what would be wrong.
TEST_F(Bake, SkinsStandStillWithEdgesAndHaveNoOrderOfTriangles) {
  const std::string figure = ZSTRIP_SCENE_FILES "/figure/figure.gltf";
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--edges"}, {"--visibility", "painter-bsp"}, {"--visible-sets", "figure.zvs"}}) {
    std::vector<std::string> arguments{"bake", figure, "-o", "still.zsc", "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome blob = run(ZSTRIP_COMMAND, arguments, path(""));
    EXPECT_EQ(blob.status, 0) << blob.err;
    EXPECT_NE(blob.err.find("with " + options[0] + " a blob has no skins"), std::string::npos) << blob.err;
    const std::vector<std::string> shown = crcs("still.zsc", {}, 2);
    EXPECT_EQ(shown[0], shown[1]);
  }
  report({"bake", figure, "-o", "figure.zsc"});
  const Outcome edged = run(ZSTRIP_COMMAND, {"render", "figure.zsc", "-o", "figure.png", "--edges"}, path(""));
  EXPECT_EQ(edged.status, 2);
  EXPECT_NE(edged.err.find("moved while they are drawn; use --no-edges"), std::string::npos) << edged.err;
  const Outcome header = run(ZSTRIP_COMMAND, {"bake", figure, "-o", "figure.hpp", "--quiet"}, path(""));
  EXPECT_EQ(header.status, 0);
  EXPECT_EQ(header.err, "");
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--visibility", "painter-bsp"}, {"--visible-sets", "figure.zvs"}}) {
    std::vector<std::string> arguments{"bake", figure, "-o", "refused.hpp", "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome refused = run(ZSTRIP_COMMAND, arguments, path(""));
    EXPECT_EQ(refused.status, 2) << refused.err;
    EXPECT_NE(refused.err.find("move"), std::string::npos) << refused.err;
  }
}

TEST_F(Bake, MorphTargetsMoveInHeadersAndBlobs) {
  const std::string cube = BAKE_MODELS "/morph_cube.gltf";
  const Json baked = report({"bake", cube, "-o", "cube.hpp"}), blob = report({"bake", cube, "-o", "cube.zsc"});
  for (const char* part : {"moved_vertices", "weights"}) {
    EXPECT_EQ(blob["plan"]["ram_bytes"][part], baked["plan"]["ram_bytes"][part]) << part;
  }
  for (const char* scene : {cube.c_str(), "cube.zsc"}) {
    const Outcome planned = zstrip({"plan", scene, "--json"});
    ASSERT_EQ(planned.status, 0) << planned.err;
    EXPECT_EQ(Json::parse(planned.out)["moved_bytes"], 24 * 10 + 20 + 4) << scene;
    EXPECT_EQ(Json::parse(planned.out)["flash_bytes"], (scene == cube ? baked : blob)["flash_bytes"]["total"]) << scene;
  }
  for (const char* part : {"positions", "normals", "morphs", "keyframes"}) {
    EXPECT_EQ(blob["flash_bytes"][part], baked["flash_bytes"][part]) << part;
  }
  // 24 vertices of 6 and 4 bytes, a meshlet of 20; two weights of 2. The first target has 24 offsets of positions, the
  // second one as many of normals, too, of the faces that do not lean: 12 bytes for 8 vertices of the sides.
  EXPECT_EQ(baked["plan"]["ram_bytes"]["moved_vertices"], 24 * 10 + 20);
  EXPECT_EQ(baked["plan"]["ram_bytes"]["weights"], 4);
  EXPECT_GT(baked["flash_bytes"]["morphs"], 2 * 24 * 6);
  EXPECT_LT(baked["flash_bytes"]["morphs"], 2 * 24 * 6 + 24 * 3 + 60);
  EXPECT_NE(read(path("cube.hpp")).find("pose_morphs(milliseconds)"), std::string::npos);
  const Outcome refused =
      run(ZSTRIP_COMMAND, {"bake", cube, "-o", "refused.hpp", "--quiet", "--visibility", "painter-bsp"}, path(""));
  EXPECT_EQ(refused.status, 2) << refused.err;
  const Outcome still =
      run(ZSTRIP_COMMAND, {"bake", cube, "-o", "still.zsc", "--quiet", "--visibility", "painter-bsp"}, path(""));
  EXPECT_EQ(still.status, 0) << still.err;
  EXPECT_NE(still.err.find("with --visibility a blob has no skins and no morph targets"), std::string::npos);
}

TEST_F(Bake, BlobsWithMorphTargetsShowTheFramesOfTheirModels) {
  for (const char* name : {"morph_cube", "morph_bending", "morph_face"}) {
    const std::string model = std::string(BAKE_MODELS "/") + name + ".gltf";
    const Outcome baked = run(ZSTRIP_COMMAND, {"bake", model, "-o", "scene.zsc", "--quiet"}, path(""));
    ASSERT_EQ(baked.status, 0) << baked.err;
    EXPECT_EQ(baked.err, "");
    const std::vector<std::string> frames = crcs("scene.zsc", {}, 6);
    EXPECT_EQ(frames, crcs(model, {}, 6)) << name;
    EXPECT_GT(std::set<std::string>(frames.begin(), frames.end()).size(), 3U) << "it moves";
  }
  const std::string face = BAKE_MODELS "/morph_face.gltf";
  for (const char* clip : {"puff", "nod"}) {
    report({"bake", face, "-o", "scene.zsc", "--animation", clip});
    EXPECT_EQ(crcs("scene.zsc", {}, 5), crcs(face, {"--animation", clip}, 5)) << clip;
  }
}

// Its header named an effect that its scene does not have, and did not compile.
TEST_F(Bake, ABuiltInSceneWhoseSkinMovesWhileItIsDrawnStandsStill) {
  for (const char* file : {"character.hpp", "character.zsc"}) {
    const Outcome outcome = run(ZSTRIP_COMMAND, {"bake", "character", "-o", file, "--json", "-", "--quiet"}, path(""));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("stand still, as they were modelled"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out.find("skins"), std::string::npos) << outcome.out;
  }
  const std::string header = read(path("character.hpp"));
  EXPECT_NE(header.find("kEffects"), std::string::npos);
  EXPECT_EQ(header.find("effect::skins"), std::string::npos);
}

}  // namespace
}  // namespace zstrip::sim::test
