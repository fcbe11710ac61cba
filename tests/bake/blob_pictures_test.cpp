// Blobs as scenes of `zstrip render` and `zstrip plan`: they draw what they were baked from.
#include <filesystem>
#include <regex>

#include "bake_fixture.hpp"
#include "text/number.hpp"

namespace zstrip::sim::test {
namespace {

TEST_F(Bake, BlobsDrawWhatModelsDraw) {
  expect_same_pictures(kHouseModel);
  expect_same_pictures(kColoursModel, {"--ortho"});
  expect_same_pictures(kHouseModel, {"--up", "z", "--orbit", "6,30,50", "--fov", "50"});
  expect_same_pictures(file("sphere.obj", sphere_obj(60, 40)));
}

TEST_F(Bake, BlobsDrawWhatDebiansModelsDraw) {
  const std::string glmark2 = GLMARK2_MODELS, assimp = ASSIMP_MODELS;
  if (glmark2.empty() || assimp.empty())
    GTEST_SKIP() << "packages glmark2-data and assimp-testmodels are not installed";
  for (const char* name : {"bunny.obj", "cat.3ds", "horse.3ds", "asteroid-low.3ds"}) {
    expect_same_pictures(glmark2 + '/' + name);
  }
  for (const char* name : {"BoxTextured-glTF/BoxTextured.gltf", "2CylinderEngine-glTF-Binary/2CylinderEngine.glb",
                           "BoxTexcoords-glTF/boxTexcoords.gltf"}) {
    expect_same_pictures(assimp + "/glTF2/" + name);
  }
}

TEST_F(Bake, BuiltInScenesCanBeBaked) {
  report({"bake", "room", "-o", "room.zsc"});
  EXPECT_EQ(crcs("room.zsc", {}, 1), crcs("room", {}, 1));
}

/// A narrower picture shows as much from side to side, a wider one as much from top to bottom.
TEST_F(Bake, BlobInPicturesOfOtherShapes) {
  report({"bake", kHouseModel, "-o", "house.zsc", "--size", "200x100"});
  const Json narrow = report({"render", "house.zsc", "--size", "90x100"});
  const Json& bounds = narrow.at("frames").at(0).at("bounds");
  EXPECT_GT(bounds.at("left"), 0);
  EXPECT_LT(bounds.at("right"), 90);

  constexpr std::size_t kOwnRow = 2 * 200, kWideRow = 2 * 300, kLeft = 2 * 50;
  report({"render", "house.zsc", "--size", "200x100", "-o", "own.raw"});
  report({"render", "house.zsc", "--size", "300x100", "-o", "wide.raw"});
  const std::string own = read(path("own.raw")), wide = read(path("wide.raw"));
  ASSERT_EQ(wide.size(), 100 * kWideRow);
  for (std::size_t row = 0; row < 100; ++row) {
    ASSERT_EQ(wide.substr(row * kWideRow + kLeft, kOwnRow), own.substr(row * kOwnRow, kOwnRow)) << row;
  }
}

/// It was drawn with 320x240 pixels in RGB565, one sample each.
TEST_F(Bake, BlobsPictureIsWhatItWasBakedFor) {
  const std::vector<std::string> picture{"--size", "90x60", "--format", "rgb444", "--samples", "4", "--dither"};
  std::vector<std::string> bake{"bake", "teapot", "-o", "teapot.zsc"};
  bake.insert(bake.end(), picture.begin(), picture.end());
  report(bake);
  EXPECT_EQ(crcs("teapot.zsc", {}, 1), crcs("teapot", picture, 1));
  EXPECT_EQ(crcs("teapot.zsc", {"--samples", "1", "--no-dither", "--format", "rgb565"}, 1),
            crcs("teapot", {"--size", "90x60"}, 1));
  EXPECT_EQ(zstrip({"plan", "teapot.zsc"}).out.find("320x240"), std::string::npos);
  report({"bake", "teapot.zsc", "-o", "again.zsc"});
  EXPECT_EQ(read(path("again.zsc")), read(path("teapot.zsc")));
}

TEST_F(Bake, CameraOptionsReplaceTheBlobsCamera) {
  report({"bake", kHouseModel, "-o", "house.zsc"});
  const std::vector<std::string> own = crcs("house.zsc", {}, 1);
  EXPECT_NE(crcs("house.zsc", {"--orbit", "4,90,60"}, 1), own);
  EXPECT_NE(crcs("house.zsc", {"--fov", "60"}, 1), own);
  EXPECT_NE(crcs("house.zsc", {"--ortho"}, 1), own);
  report({"bake", kHouseModel, "-o", "flat.zsc", "--ortho"});
  EXPECT_EQ(crcs("flat.zsc", {"--ortho"}, 1), crcs("flat.zsc", {}, 1));
  EXPECT_EQ(zstrip({"render", "flat.zsc", "--fov", "40"}).status, 2);
  EXPECT_EQ(zstrip({"render", "house.zsc", "--up", "z"}).status, 2);
}

TEST_F(Bake, BlobsCanBePlannedAndBakedAgain) {
  report({"bake", kHouseModel, "-o", "house.zsc", "--size", "128x64"});
  const Outcome of_blob = zstrip({"plan", "house.zsc", "--size", "128x64", "--ram", "14K"});
  const Outcome of_model = zstrip({"plan", kHouseModel, "--size", "128x64", "--ram", "14K"});
  ASSERT_EQ(of_blob.status, 0) << of_blob.err;
  const auto after_title = [](const std::string& text) { return text.substr(text.find('\n')); };
  // A blob's flash is its file, with a header and a directory; a model's is that of its arrays.
  const auto without_flash = [&](const std::string& text) {
    return std::regex_replace(after_title(text), std::regex(" *[0-9,]+  flash "), "flash ");
  };
  EXPECT_EQ(without_flash(of_blob.out), without_flash(of_model.out));
  EXPECT_NE(of_blob.out.find(grouped(std::filesystem::file_size(path("house.zsc"))) + "  flash"), std::string::npos)
      << of_blob.out;

  report({"bake", "house.zsc", "-o", "again.zsc", "--size", "128x64"});
  EXPECT_EQ(read(path("again.zsc")), read(path("house.zsc")));
  report({"bake", "house.zsc", "-o", "blob.hpp", "--size", "128x64"});
  report({"bake", kHouseModel, "-o", "model.hpp", "--size", "128x64"});
  EXPECT_EQ(after_title(read(path("blob.hpp"))), after_title(read(path("model.hpp"))));
}

TEST_F(Bake, BillboardsTurnInABlobAsInTheSceneFile) { same_as_a_blob("billboards", "billboards", {}, 5); }

TEST_F(Bake, EnvironmentMapsAreDrawnFromABlobAsFromTheSceneFile) {
  EXPECT_EQ(same_as_a_blob("environment", "environment", {"--turntable"}, 5),
            Json::array({"chrome", "lacquer", "gold"}));
}

TEST_F(Bake, ShadingInABlobAsInTheSceneFile) {
  EXPECT_EQ(same_as_a_blob("per_pixel", "pixel_shading", {}, 1),
            Json::array({"stone, each pixel", "lacquer, each pixel"}));
  report({"bake", ZSTRIP_SCENE_FILES "/per_pixel.toml", "-o", "scene.hpp"});
  EXPECT_NE(read(path("scene.hpp")).find(".smooth = zstrip::Shading::pixel"), std::string::npos);
}

TEST_F(Bake, OutlinesInABlobAsInTheSceneFile) { same_as_a_blob("outlines", "outlines", {}, 3); }

TEST_F(Bake, LinesAndPointsInABlobAsInTheSceneFile) {
  EXPECT_EQ(same_as_a_blob("lines", "lines", {}, 1), Json::array({"wire", "box", "x", "y", "z", "dots"}));
}

TEST_F(Bake, ShadowsInABlobAsInTheSceneFile) { same_as_a_blob("shadows", "shadows", {}, 3); }

TEST_F(Bake, ProductsOfSolidsInABlobAsInTheSceneFile) {
  same_as_a_blob("csg", "csg", {}, 3);
  report({"bake", ZSTRIP_SCENE_FILES "/csg.toml", "-o", "scene.hpp"});
  EXPECT_NE(read(path("scene.hpp")).find(".csg = kCsg"), std::string::npos);
}

}  // namespace
}  // namespace zstrip::sim::test
