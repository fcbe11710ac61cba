// Every frame of a blob is that of the scene that it was baked from, with as many frames and of the same size: what
// turns, what stands still, and the camera.
#include <nlohmann/json.hpp>

#include "blob_sample.hpp"
#include "support.hpp"

namespace zstrip::sim::test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

class BakedFrames : public FolderTest {
 protected:
  Outcome zstrip(const Words& arguments) const { return run(ZSTRIP_COMMAND, arguments, path("")); }
  std::string bake(const std::string& scene, const std::string& output, const Words& options) const {
    Words arguments{"bake", scene, "-o", output, "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 0) << scene << ": " << outcome.err;
    return outcome.err;
  }
  Words frames(const std::string& scene, int count, const Words& options) const {
    Words arguments{"render", scene, "-o", "frames", "--quiet", "--json", "-", "--frames", std::to_string(count)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 0) << scene << ": " << outcome.err;
    Words found;
    if (outcome.status != 0) return found;
    const Json report = Json::parse(outcome.out);
    for (const Json& frame : report.at("frames")) {
      EXPECT_GT(frame.at("statistics").at("fragments"), 20) << scene;
      found.push_back(frame.at("crc32"));
    }
    return found;
  }
  /// Those of `scene` for each of some numbers of frames. Bakes the blob again, to the same bytes.
  void expect_same(const std::string& scene, const Words& options = {}) const {
    for (const char* size : {"64x48", "50x70"}) {
      Words all{"--size", size};
      all.insert(all.end(), options.begin(), options.end());
      bake(scene, "scene.zsc", all);
      for (const int count : {1, 3}) EXPECT_EQ(frames("scene.zsc", count, {}), frames(scene, count, all)) << scene;
      bake("scene.zsc", "again.zsc", {});
      EXPECT_EQ(read(path("again.zsc")), read(path("scene.zsc"))) << scene;
    }
  }
  std::string scene_of(const std::string& content) const { return file("scene.toml", content); }
};

const std::string kMaterials =
    "[[material]]\nname = 'a'\ncolour = '#c03020'\n[[material]]\nname = 'b'\nlit = false\n"
    "[[model]]\nname = 'cube'\nbuilt_in = 'cube'\n";
const std::string kMoving =
    "[[instance]]\nmodel = 'cube'\nmaterial = 'a'\ntranslation = [1, 0.3, 0.5]\nscale = [0.6, 0.3, 0.6]\n";
const std::string kStatic =
    "[[instance]]\nmodel = 'cube'\nmaterial = 'b'\ntranslation = [-1, 0.2, 0.5]\nscale = 0.4\nlayer = 'static'\n";
const std::string kEllipsoid = "[[ellipsoid]]\nmaterial = 'a'\nradius = [0.5, 0.3, 0.4]\ntranslation = [0.4, 1, -1]\n";
const std::string kWire =
    "[[lines]]\nmaterial = 'b'\nwidth = 2\nvertices = [[-2, -0.5, 1], [2, -0.5, 1.5], [1, 1.5, -1]]\n"
    "[[points]]\nmaterial = 'b'\nwidth = 4\nvertices = [[1.5, 0.5, 1], [-1.5, 0.4, 0.2]]\n";
const std::string kCamera = "[camera]\neye = [2, 2, 5]\n";

TEST_F(BakedFrames, LinesAndPointsStandStillBesideWhatTurns) {
  expect_same(scene_of(kMaterials + kMoving + kWire));
  expect_same(scene_of(kCamera + kMaterials + kMoving + kWire));
}

TEST_F(BakedFrames, TheStaticLayerStandsStill) {
  expect_same(scene_of(kMaterials + kMoving + kStatic));
  expect_same(scene_of(kCamera + kMaterials + kStatic + kMoving));
  const std::string still = scene_of(kMaterials + kStatic + kWire);
  expect_same(still);
  const Words all = frames("scene.zsc", 3, {});
  EXPECT_EQ(all, Words(3, all.at(0)));
}

TEST_F(BakedFrames, EllipsoidsStandStill) {
  expect_same(scene_of(kMaterials + kMoving + kEllipsoid));
  expect_same(scene_of(kCamera + kMaterials + kMoving + kStatic + kEllipsoid + kWire));
}

TEST_F(BakedFrames, OutlinesBillboardsAndShadowsOfWhatTurns) {
  expect_same(scene_of(kMaterials + kMoving + "outline = { width = 2 }\n" + kStatic + "outline = { width = 3 }\n"));
  expect_same(scene_of(kMaterials + "[[instance]]\nmodel = 'cube'\nmaterial = 'a'\nbillboard = 'upright'\n" + kStatic));
  expect_same(scene_of(kMaterials + kMoving + kStatic + kEllipsoid +
                       "[[light]]\ntype = 'directional'\ndirection = [0.5, -0.8, -0.6]\n[light.shadow]\n"));
}

TEST_F(BakedFrames, EdgesOfWhatTurnsAndWhatStands) {
  expect_same(scene_of("[picture]\nedges = true\n" + kMaterials + kMoving + kStatic + kEllipsoid + kWire));
  expect_same(BAKE_MODELS "/house.obj", {"--edges"});
  expect_same(BAKE_MODELS "/house.obj", {"--edges", "--ortho"});
}

TEST_F(BakedFrames, OneFrameAndATurnHaveTheirCamerasWithoutTurntable) {
  expect_same(BAKE_MODELS "/house.obj");
  expect_same(BAKE_MODELS "/house.obj", {"--ortho"});
  expect_same(BAKE_MODELS "/house.obj", {"--fov", "70"});
  expect_same(BAKE_MODELS "/house.obj", {"--orbit", "6,30,50"});
  bake(BAKE_MODELS "/house.obj", "turning.zsc", {"--turntable"});
  EXPECT_EQ(frames("turning.zsc", 1, {}).at(0), frames(BAKE_MODELS "/house.obj", 2, {}).at(0))
      << "asked for, for one frame";
}

TEST_F(BakedFrames, BuiltInScenesTurnOrTheirCameraGoesAround) {
  for (const char* scene : {"cube", "room", "terrain", "spheres", "wires"}) expect_same(scene);
  expect_same("room", {"--ortho"});
  expect_same("room", {"--fov", "70"});
  expect_same("room", {"--orbit", "1.5,30,70"});
  bake("room", "room.zsc", {});
  const Words placed = frames("room.zsc", 3, {"--eye", "0.1,0.2,1"});
  EXPECT_EQ(placed, Words(3, placed.at(0))) << "nothing goes around another camera";
}

/// The plane is seen at a slant, so that textures and depth differ with the settings.
TEST_F(BakedFrames, SettingsOfThePictureAreKept) {
  const std::string perspective = ZSTRIP_SCENE_FILES "/perspective.toml";
  EXPECT_EQ(bake(perspective, "scene.zsc", {}), "") << "nothing is left out";
  const Words affine = frames(perspective, 1, {});
  EXPECT_EQ(frames("scene.zsc", 1, {}), affine);
  EXPECT_NE(frames("scene.zsc", 1, {"--perspective", "16"}), affine) << "an option wins";
  EXPECT_EQ(frames("scene.zsc", 1, {"--perspective", "1"}), frames(perspective, 1, {"--perspective", "1"}));
  for (const auto& [format, number] : {std::pair{"float", 4}, {"z24", 6}}) {
    const std::string picture = std::string("[picture]\ndepth_format = '") + format + "'\n";
    expect_same(scene_of(picture + kMaterials + kMoving + kStatic));
    const std::string bytes = read(path("scene.zsc"));
    EXPECT_EQ(bytes[section({bytes.begin(), bytes.end()}, "PICT") + 7], number);
  }
}

TEST_F(BakedFrames, WhatABlobDoesNotKeepIsSaid) {
  const std::string scene = scene_of("[picture]\nvisibility = 'painter'\n" + kMaterials + kMoving);
  EXPECT_NE(bake(scene, "scene.zsc", {}).find("does not keep 'visibility'"), std::string::npos);
  EXPECT_EQ(bake(scene, "scene.hpp", {}), "");
  EXPECT_EQ(frames("scene.zsc", 3, {"--visibility", "painter"}), frames(scene, 3, {}));
  const std::string keyed =
      scene_of("[picture]\nvisibility = 'painter'\nsort_key = 'farthest'\n" + kMaterials + kMoving);
  EXPECT_NE(bake(keyed, "scene.zsc", {}).find("--visibility painter --sort-key farthest"), std::string::npos);
  EXPECT_NE(bake(keyed, "scene.hpp", {}).find("a header does not keep 'sort_key'"), std::string::npos);
  const std::string halves = scene_of("[picture]\nvisibility = 'midpoint'\niterations = 0\n" + kMaterials + kMoving);
  EXPECT_NE(bake(halves, "scene.zsc", {}).find("--visibility midpoint --iterations 0"), std::string::npos);
  EXPECT_EQ(frames("scene.zsc", 2, {"--visibility", "midpoint", "--iterations", "0"}), frames(halves, 2, {}));
  file("cube.obj", cube_obj());  // the built-in one has textures, which cannot be split
  std::string materials = kMaterials;
  materials.replace(materials.find("built_in = 'cube'"), 17, "file = 'cube.obj'");
  const std::string layers = scene_of(materials + kMoving + kStatic);
  EXPECT_NE(bake(layers, "scene.zsc", {"--visibility", "painter-bsp"}).find("stands still"), std::string::npos);
  const Words all = frames("scene.zsc", 3, {"--visibility", "painter-bsp"});
  EXPECT_EQ(all, Words(3, all.at(0)));
  EXPECT_EQ(zstrip({"bake", layers, "-o", "scene.hpp", "--visibility", "painter-bsp", "--turntable"}).status, 2);
  EXPECT_NE(bake("random50", "order.zsc", {"--visibility", "painter-newell"}).find("stands still"), std::string::npos);
  const Words ordered = frames("order.zsc", 3, {"--visibility", "painter-newell"});
  EXPECT_EQ(ordered, Words(3, ordered.at(0)));
}

/// Their RAM was that of a painter, and the program that shows them has a z-buffer.
TEST_F(BakedFrames, ABlobOfASceneFileWithAMethodIsPlannedWithAZBuffer) {
  const std::string scene = scene_of("[picture]\nvisibility = 'painter'\n" + kMaterials + kMoving);
  for (const auto& [output, depth_bytes, words] :
       {std::tuple{"scene.hpp", 0, ""},
        {"scene.zsc", 240 * 240 * 2, "memory is planned with a z-buffer"},
        {"scene.uf2", 240 * 80 * 2, "the program for the Pico draws with a z-buffer"}}) {
    const Outcome outcome =
        zstrip({"bake", scene, "-o", output, "--size", "240x240", "--ram", "max", "--quiet", "--json", "-"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out).at("plan").at("ram_bytes").at("depth"), depth_bytes) << output;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  }
}

/// Each unbaked frame had a tree of its own, lit anew; the baked one has the first one's light in its colours.
TEST_F(BakedFrames, TreesAreTheSceneOfTheFirstFrame) {
  for (const char* scene : {BAKE_MODELS "/house.obj", "teapot", "random50"}) {
    SCOPED_TRACE(scene);
    EXPECT_EQ(bake(scene, "tree.zsc", {"--visibility", "painter-bsp"}), "");
    const Words turning = frames(scene, 5, {"--visibility", "painter-bsp"});
    EXPECT_NE(turning.at(0), turning.at(1));
    EXPECT_EQ(frames("tree.zsc", 5, {"--visibility", "painter-bsp"}), turning);
  }
}

TEST_F(BakedFrames, BlobsWithoutATurnTurn) {
  bake(scene_of(kMaterials + kWire), "scene.zsc", {"--size", "64x48"});
  const std::string whole = read(path("scene.zsc"));
  std::vector<Piece> pieces = pieces_of({whole.begin(), whole.end()});
  EXPECT_EQ(std::erase_if(pieces, [](const Piece& piece) { return piece.tag == "TURN"; }), 1U);
  const Bytes bytes = blob_of(pieces);
  const Words turning = frames(file("turns.zsc", {bytes.begin(), bytes.end()}), 4, {});
  EXPECT_NE(turning.at(0), turning.at(1));
  EXPECT_NE(turning.at(0), turning.at(2));
  const Words still = frames("scene.zsc", 4, {});
  EXPECT_EQ(still, Words(4, still.at(0))) << "as in the scene file";
}

TEST_F(BakedFrames, WhatIsTooFarAwayToTurnIsSaid) {
  bake("room", "room.zsc", {"--size", "64x48"});
  const std::string whole = read(path("room.zsc"));
  Bytes bytes(whole.begin(), whole.end());
  put_word(bytes, section(bytes, "CAMR") + 36, 0x7FFFFFFF);  // the eye's x
  mend(bytes);
  const std::string far = file("far.zsc", {bytes.begin(), bytes.end()});
  const Outcome outcome = zstrip({"render", far, "-o", "frames", "--frames", "2"});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.err.find("too far away"), std::string::npos) << outcome.err;
  EXPECT_EQ(zstrip({"render", far, "-o", "p.png", "--frames", "1"}).status, 0);
}

}  // namespace
}  // namespace zstrip::sim::test
