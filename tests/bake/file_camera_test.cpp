// Cameras of glTF files: each is the one that --eye, --look-at and --fov would place.
#include <cstring>
#include <nlohmann/json.hpp>

#include "support.hpp"

namespace zstrip::sim::test {
namespace {

using Json = nlohmann::json;

/// A tetrahedron with one camera on +z, one on +x turned towards it, and a parallel one.
class FileCamera : public FolderTest {
 protected:
  FileCamera() {
    const float corners[4][3] = {{0, 1, 0}, {-1, -0.5F, 0.5F}, {1, -0.5F, 0.7F}, {0.2F, -0.5F, -1}};
    const std::uint16_t indices[12] = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2};
    std::string bytes(sizeof corners + sizeof indices, '\0');
    std::memcpy(bytes.data(), corners, sizeof corners);
    std::memcpy(bytes.data() + sizeof corners, indices, sizeof indices);
    file("shape.bin", bytes);
    model_ = file("shape.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2, 3]}],
      "nodes": [{"mesh": 0},
                {"name": "front", "camera": 0, "translation": [0, 0.25, 5]},
                {"name": "side", "camera": 1, "translation": [6, 0, 0], "rotation": [0, 0.70710678, 0, 0.70710678]},
                {"name": "flat", "camera": 2, "translation": [0, 0.25, 5]}],
      "cameras": [{"type": "perspective", "perspective": {"yfov": 0.78539816, "znear": 0.1, "aspectRatio": 2}},
                  {"type": "perspective", "perspective": {"yfov": 0.78539816, "znear": 0.1}},
                  {"type": "orthographic", "orthographic": {"xmag": 3, "ymag": 1.5, "znear": 0.1, "zfar": 20}}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                     "min": [-1, -0.5, -1], "max": [1, 1, 0.7]},
                    {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
      "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
      "buffers": [{"uri": "shape.bin", "byteLength": 72}]})");
  }
  Outcome zstrip(const std::vector<std::string>& arguments) { return run(ZSTRIP_COMMAND, arguments, path("")); }
  std::string crc(std::vector<std::string> options) {
    options.insert(options.begin(), {"render", model_, "-o", "picture.png", "--quiet", "--json", "-"});
    const Outcome outcome = zstrip(options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    if (outcome.status != 0) return "";
    const Json report = Json::parse(outcome.out);
    EXPECT_GT(report.at("frames").at(0).at("statistics").at("fragments"), 1000);
    return report.at("frames").at(0).at("crc32");
  }
  std::string model_;
};

TEST_F(FileCamera, SeesWhatThePlacedOneSees) {
  EXPECT_EQ(crc({"--camera", "front"}), crc({"--eye", "0,0.25,5", "--look-at", "0,0.25,0", "--fov", "45"}));
  EXPECT_EQ(crc({"--camera", "side"}), crc({"--eye", "6,0,0", "--look-at", "0,0,0", "--fov", "45"}));
  EXPECT_NE(crc({"--camera", "front"}), crc({"--camera", "side"}));
}

TEST_F(FileCamera, ParallelOneShowsItsHeight) {
  // A body 1.5 units high in a picture of 3 units: half of 240 rows, by the bounds of its box, which are rounded
  // outwards.
  const Outcome outcome = zstrip({"render", model_, "--camera", "flat", "--quiet", "--json", "-"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json report = Json::parse(outcome.out);
  const Json& bounds = report.at("frames").at(0).at("bounds");
  const int rows = bounds.at("bottom").get<int>() - bounds.at("top").get<int>();
  EXPECT_GE(rows, 120);
  EXPECT_LE(rows, 124);
}

TEST_F(FileCamera, IsBaked) {
  const Outcome baked = zstrip({"bake", model_, "-o", "scene.zsc", "--camera", "side", "--quiet"});
  ASSERT_EQ(baked.status, 0) << baked.err;
  const Outcome outcome = zstrip({"render", "scene.zsc", "--quiet", "--json", "-"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(report.at("frames").at(0).at("crc32"), crc({"--camera", "side"}));
}

TEST_F(FileCamera, Refusals) {
  const Outcome unknown = zstrip({"render", model_, "--camera", "back"});
  EXPECT_EQ(unknown.status, 4);
  EXPECT_NE(unknown.err.find("it has 'front', 'side', 'flat'"), std::string::npos) << unknown.err;
  const Outcome none = zstrip({"render", file("triangle.obj", kTriangleObj), "--camera", "front"});
  EXPECT_EQ(none.status, 4);
  EXPECT_NE(none.err.find("it has none"), std::string::npos) << none.err;
  EXPECT_EQ(zstrip({"render", "teapot", "--camera", "front"}).status, 2);
  EXPECT_EQ(zstrip({"render", model_, "--camera", "front", "--fov", "40"}).status, 2);
  EXPECT_EQ(zstrip({"render", model_, "--camera", "front", "--eye", "0,0,9"}).status, 2);
}

}  // namespace
}  // namespace zstrip::sim::test
