// Animations of glTF 2.0 files made to measure: where the instances are at each frame.
#include <cmath>
#include <numbers>

#include "gltf_file.hpp"
#include "import/quantise.hpp"
#include "render/stage.hpp"
#include "support.hpp"

namespace zstrip::sim::test {
namespace {

/// A square of side 2 in a node at rest, and another in a child of the node "arm", which the animation "swing" moves:
/// two keys, at 0 and 2 seconds, of `path`, `values` floats each.
std::string swinging(const std::string& path, const std::string& interpolation, const std::vector<float>& values,
                     const std::vector<float>& key_times = {0, 2}) {
  const std::string corners = floats({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0});
  const std::string triangles("\0\0\1\0\2\0\0\0\2\0\3\0", 12);
  const std::string times = floats(key_times);
  const std::string keys = floats(values);
  const std::string buffer = corners + triangles + times + keys;
  const auto view = [](std::size_t at, std::size_t size) {
    return "{\"buffer\":0,\"byteOffset\":" + std::to_string(at) + ",\"byteLength\":" + std::to_string(size) + "}";
  };
  const std::string type = path == "rotation" ? "VEC4" : "VEC3";
  const std::string count = std::to_string(values.size() / (path == "rotation" ? 4 : 3));
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"name":"floor","mesh":0},)"
         R"({"name":"arm","children":[2]},{"name":"hand","mesh":0,"translation":[3,0,0]}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
         R"("animations":[{"name":"swing","channels":[{"sampler":0,"target":{"node":1,"path":")" +
         path + R"("}}],"samplers":[{"input":2,"output":3,"interpolation":")" + interpolation + R"("}]}],)" +
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[-1,-1,0],"max":[1,1,0]},)"
         R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"},)"
         R"({"bufferView":2,"componentType":5126,"count":2,"type":"SCALAR","min":[0],"max":[2]},)"
         R"({"bufferView":3,"componentType":5126,"count":)" +
         count + R"(,"type":")" + type + R"("}],"bufferViews":[)" + view(0, 48) + "," + view(48, 12) + "," +
         view(60, 8) + "," + view(68, keys.size()) + R"(],"buffers":[{"byteLength":)" + std::to_string(buffer.size()) +
         R"(,"uri":"data:application/octet-stream;base64,)" + base64(buffer) + "\"}]}";
}

class GltfAnimation : public FolderTest {
 protected:
  std::unique_ptr<Stage> opened(const std::string& content, const std::optional<std::string>& animation = {}) const {
    Result<std::unique_ptr<Stage>> stage =
        open_stage(file("model.gltf", content), {.animation = animation}, {}, {320, 240}, 8);
    EXPECT_TRUE(stage) << stage.failure().message;
    return stage ? std::move(*stage) : nullptr;
  }
  /// Where the middle of the hand, at (3, 0, 0) at rest, is in the file's units at a frame of 8 in 2 seconds.
  static std::array<double, 3> hand(Stage& stage, std::uint32_t frame) {
    const Result<Staging> staging = stage.place(frame, 8);
    EXPECT_TRUE(staging);
    const Units& units = stage.model()->units;
    std::array<double, 3> rest{3, 0, 0}, moved{};
    for (std::size_t axis = 0; axis < 3; ++axis) rest[axis] = (rest[axis] - units.origin[axis]) * units.scale;
    EXPECT_EQ(staging->scene.instances.size(), 2U);
    const Fixed(&m)[3][4] = staging->scene.instances.back().transform.m;
    for (std::size_t row = 0; row < 3; ++row) {
      moved[row] = from_fixed(m[row][3]);
      for (std::size_t k = 0; k < 3; ++k) moved[row] += from_fixed(m[row][k]) * rest[k];
      moved[row] = moved[row] / units.scale + units.origin[row];
    }
    EXPECT_EQ(staging->scene.instances.front().transform.m[0][3], 0) << "the floor does not move";
    return moved;
  }
};

TEST_F(GltfAnimation, WeightsOfAMeshMoveBesideItsNodes) {
  std::string content = swinging("translation", "LINEAR", {0, 0, 0, 0, 4, 0});
  const std::string_view indices = "\"indices\":1", channels = "\"channels\":[";
  content.insert(content.find(indices) + indices.size(), R"(,"targets":[{"POSITION":0}])");
  const auto still = opened(content);
  ASSERT_TRUE(still);
  EXPECT_TRUE(still->warnings().empty()) << "no animation changes its weights";
  EXPECT_FALSE(still->bends());
  content.insert(content.find(channels) + channels.size(), R"({"sampler":0,"target":{"node":2,"path":"weights"}},)");
  const Result<std::unique_ptr<Stage>> stage = open_stage(file("vectors.gltf", content), {}, {}, {160, 120}, 8);
  ASSERT_FALSE(stage) << "a sampler of vectors has no weights";
  EXPECT_NE(stage.failure().message.find("too few values"), std::string::npos) << stage.failure().message;
}

TEST_F(GltfAnimation, KeysThatAreLeftOutAreSaid) {
  const float nan = std::nanf("");
  for (const std::vector<float>& times : {std::vector<float>{2, 0}, {2, 2}, {nan, 2}}) {
    const auto stage = opened(swinging("translation", "LINEAR", {0, 0, 0, 0, 4, 0}, times));
    ASSERT_TRUE(stage);
    ASSERT_EQ(stage->warnings().size(), 1U);
    EXPECT_EQ(stage->warnings()[0], "animation 'swing': 1 key left out, no number or not later than the one before");
  }
  EXPECT_TRUE(opened(swinging("translation", "LINEAR", {0, 0, 0, 0, 4, 0}))->warnings().empty());
}

TEST_F(GltfAnimation, PosesBesideMotionsWereLost) {
  std::string content = swinging("translation", "LINEAR", {0, 5, 0, 0, 7, 0});
  const std::string_view animations = "\"animations\":[", views = "],\"bufferViews\"";
  content.insert(content.find(views), R"(,{"bufferView":2,"componentType":5126,"count":1,"type":"SCALAR"},)"
                                      R"({"bufferView":3,"componentType":5126,"count":1,"type":"VEC3"})");
  content.insert(content.find(animations) + animations.size(),
                 R"({"name":"stand","channels":[{"sampler":0,"target":{"node":1,"path":"translation"}}],)"
                 R"("samplers":[{"input":4,"output":5}]},)");
  const auto shown = opened(content), chosen = opened(content, "stand");
  ASSERT_TRUE(shown && chosen);
  EXPECT_NEAR(hand(*shown, 4)[1], 6, 1e-2) << "the first animation that moves";
  EXPECT_NEAR(hand(*chosen, 4)[1], 5, 1e-2);
}

TEST_F(GltfAnimation, EventsThatNeverComeWereSilent) {
  std::string content = swinging("translation", "LINEAR", {0, 0, 0, 0, 4, 0});
  const std::string_view name = "\"name\":\"swing\"";
  content.insert(content.find(name) + name.size(),
                 R"(,"extras":{"events":[0,1, 0.5,2, 0.5,3, 2,4, -1,5, 1,70000, 1]})");
  const auto stage = opened(content);
  ASSERT_TRUE(stage);
  ASSERT_EQ(stage->events().size(), 2U);
  EXPECT_EQ(stage->events()[1].number, 2);
  ASSERT_EQ(stage->warnings().size(), 1U);
  EXPECT_EQ(stage->warnings()[0].substr(0, 39), "animation 'swing': 5 events left out: t");
}

TEST_F(GltfAnimation, OfNodesAndInterpolationsThatDoNotExistIsDamaged) {
  const auto reason = [this](const std::string& content) {
    const auto stage = open_stage(file("model.gltf", content), {}, {}, {320, 240}, 8);
    return stage ? "" : stage.failure().message;
  };
  const std::string bends = swinging("translation", "BEND", {0, 0, 0, 0, 4, 0});
  EXPECT_NE(reason(bends).find("an interpolation that does not exist"), std::string::npos);
  std::string nowhere = swinging("translation", "LINEAR", {0, 0, 0, 0, 4, 0});
  nowhere.replace(nowhere.find("\"node\":1"), 8, "\"node\":9");
  EXPECT_NE(reason(nowhere).find("a node that does not exist"), std::string::npos);
}

TEST_F(GltfAnimation, TranslationIsLinear) {
  const auto stage = opened(swinging("translation", "LINEAR", {0, 0, 0, 0, 4, 0}));
  ASSERT_TRUE(stage);
  EXPECT_EQ(stage->animation().duration, 2000U);
  for (std::uint32_t frame = 0; frame < 8; ++frame) {
    EXPECT_NEAR(hand(*stage, frame)[0], 3, 1e-3);
    EXPECT_NEAR(hand(*stage, frame)[1], 0.5 * frame, 1e-3);
  }
}

/// A quarter turn about z carries the hand around the arm, at constant speed.
TEST_F(GltfAnimation, RotationCarriesChildren) {
  const float half = std::sqrt(0.5F);
  const auto stage = opened(swinging("rotation", "LINEAR", {0, 0, 0, 1, 0, 0, half, half}));
  ASSERT_TRUE(stage);
  for (std::uint32_t frame = 0; frame < 8; ++frame) {
    const double angle = std::numbers::pi / 2 * frame / 8;
    EXPECT_NEAR(hand(*stage, frame)[0], 3 * std::cos(angle), 5e-3) << frame;
    EXPECT_NEAR(hand(*stage, frame)[1], 3 * std::sin(angle), 5e-3) << frame;
  }
}

/// A matrix alone would be split into another mirror and a half turn, which the keys then replace.
TEST_F(GltfAnimation, KeysOfAMirroredNodeKeepItsMirror) {
  std::string content = swinging("rotation", "LINEAR", {0, 0, 0, 1, 0, 0, std::sqrt(0.5F), std::sqrt(0.5F)});
  const std::string_view arm = R"("name":"arm",)";
  content.insert(content.find(arm) + arm.size(), R"("scale":[-1,1,1],)");
  const auto stage = opened(content);
  ASSERT_TRUE(stage);
  for (std::uint32_t frame = 0; frame < 8; ++frame) {
    const double angle = std::numbers::pi / 2 * frame / 8;
    EXPECT_NEAR(hand(*stage, frame)[0], 3 * std::cos(angle), 5e-3) << frame;
    EXPECT_NEAR(hand(*stage, frame)[1], 3 * std::sin(angle), 5e-3) << frame;
  }
}

TEST_F(GltfAnimation, ScaleGrows) {
  const auto stage = opened(swinging("scale", "LINEAR", {1, 1, 1, 2, 2, 2}));
  ASSERT_TRUE(stage);
  EXPECT_NEAR(hand(*stage, 4)[0], 4.5, 5e-3);
}

TEST_F(GltfAnimation, StepsStaySteps) {
  const auto stage = opened(swinging("translation", "STEP", {0, 0, 0, 0, 4, 0}));
  ASSERT_TRUE(stage);
  EXPECT_NEAR(hand(*stage, 7)[1], 0, 1e-3);
}

/// In, value, out of each key. Half of the way: the mean of both values, and an eighth of what the slopes differ by in
/// two seconds. The slopes were dropped.
TEST_F(GltfAnimation, SplinesFollowTheirSlopes) {
  const auto stage =
      opened(swinging("translation", "CUBICSPLINE", {0, 0, 0, 0, 0, 0, 0, 8, 0, 0, 4, 0, 0, 4, 0, 0, 0, 0}));
  ASSERT_TRUE(stage);
  EXPECT_TRUE(stage->warnings().empty());
  EXPECT_NEAR(hand(*stage, 4)[1], 2 + 2 * (8 - 4) / 8.0, 1e-2);
}

TEST_F(GltfAnimation, ByName) {
  const std::string content = swinging("translation", "LINEAR", {0, 0, 0, 0, 4, 0});
  EXPECT_TRUE(opened(content, "swing"));
  const auto missing = open_stage(path("model.gltf"), {.animation = "walk"}, {}, {320, 240}, 8);
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.failure().message.find("it has 'swing'"), std::string::npos) << missing.failure().message;
}

}  // namespace
}  // namespace zstrip::sim::test
