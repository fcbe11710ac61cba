// `zstrip bake` as its users see it: files, reports, refusals; and blobs as scenes of `zstrip render` and `zstrip
// plan`.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>

#include "blob_sample.hpp"
#include "support.hpp"
#include "zstrip/blob.hpp"

namespace zstrip::sim::test {
namespace {

using Json = nlohmann::json;

class Bake : public FolderTest {
 protected:
  Outcome zstrip(const std::vector<std::string>& arguments) { return run(ZSTRIP_COMMAND, arguments, path("")); }
  Json report(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--quiet", "--json", "-"});
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.status == 0 ? Json::parse(outcome.out) : Json{};
  }
  std::vector<std::string> crcs(const std::string& scene, std::vector<std::string> options, int frames) {
    std::vector<std::string> arguments{"render", scene, "-o", "frames", "--frames", std::to_string(frames)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    std::vector<std::string> result;
    const Json rendered = report(arguments);
    for (const Json& frame : rendered.at("frames")) {
      EXPECT_GT(frame.at("statistics").at("fragments"), 100) << scene;
      result.push_back(frame.at("crc32"));
    }
    return result;
  }
  /// The scene file as a blob has its pictures, and is baked again to the same bytes. Returns the materials that the
  /// report names for `effect`.
  Json same_as_a_blob(const std::string& name, const std::string& effect, const std::vector<std::string>& options,
                      int frames) {
    const std::string scene = ZSTRIP_SCENE_FILES "/" + name + ".toml";
    const auto bake = [&](const std::string& from, const std::string& to) {
      std::vector<std::string> arguments{"bake", from, "-o", to};
      arguments.insert(arguments.end(), options.begin(), options.end());
      return report(arguments);
    };
    const Json baked = bake(scene, "scene.zsc");
    EXPECT_EQ(crcs("scene.zsc", {}, frames), crcs(scene, {}, frames));
    bake("scene.zsc", "again.zsc");
    EXPECT_EQ(read(path("again.zsc")), read(path("scene.zsc")));
    const auto found = std::ranges::find_if(baked.at("effects"), [&](const Json& e) { return e.at("name") == effect; });
    if (found == baked.at("effects").end()) {
      ADD_FAILURE() << effect << " is not reported";
      return Json::array();
    }
    return found->at("materials");
  }
  /// The model and the blob that it is baked into draw the same.
  void expect_same_pictures(const std::string& model, const std::vector<std::string>& camera = {}) {
    for (const int frames : {1, 3}) {
      std::vector<std::string> bake{"bake", model, "-o", "scene.zsc", "--size", "160x120"};
      bake.insert(bake.end(), camera.begin(), camera.end());
      if (frames > 1) bake.push_back("--turntable");
      report(bake);
      std::vector<std::string> options = camera;
      options.insert(options.end(), {"--size", "160x120"});
      const std::vector<std::string> expected = crcs(model, options, frames);
      ASSERT_EQ(expected.size(), static_cast<std::size_t>(frames)) << model;
      EXPECT_EQ(crcs("scene.zsc", {"--size", "160x120"}, frames), expected) << model;
    }
  }
};

const std::string kHouse = std::string(BAKE_MODELS) + "/house.obj";
const std::string kColours = std::string(BAKE_MODELS) + "/colours.ply";

TEST_F(Bake, BlobsDrawWhatModelsDraw) {
  expect_same_pictures(kHouse);
  expect_same_pictures(kColours, {"--ortho"});
  expect_same_pictures(kHouse, {"--up", "z", "--orbit", "6,30,50", "--fov", "50"});
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

/// What cannot move a skin says so, or refuses what would be wrong.
TEST_F(Bake, SkinsStandStillInBlobsAndHaveNoOrderOfTriangles) {
  const std::string figure = ZSTRIP_SCENE_FILES "/figure/figure.gltf";
  const Outcome blob = run(ZSTRIP_COMMAND, {"bake", figure, "-o", "figure.zsc", "--quiet"}, path(""));
  EXPECT_EQ(blob.status, 0);
  EXPECT_NE(blob.err.find("a blob has no skins"), std::string::npos) << blob.err;
  EXPECT_EQ(crcs("figure.zsc", {}, 1), crcs(figure, {}, 1));
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

/// A narrower picture shows as much from side to side, a wider one as much from top to bottom.
TEST_F(Bake, BlobInPicturesOfOtherShapes) {
  report({"bake", kHouse, "-o", "house.zsc", "--size", "200x100"});
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
  report({"bake", kHouse, "-o", "house.zsc"});
  const std::vector<std::string> own = crcs("house.zsc", {}, 1);
  EXPECT_NE(crcs("house.zsc", {"--orbit", "4,90,60"}, 1), own);
  EXPECT_NE(crcs("house.zsc", {"--fov", "60"}, 1), own);
  EXPECT_NE(crcs("house.zsc", {"--ortho"}, 1), own);
  report({"bake", kHouse, "-o", "flat.zsc", "--ortho"});
  EXPECT_EQ(crcs("flat.zsc", {"--ortho"}, 1), crcs("flat.zsc", {}, 1));
  EXPECT_EQ(zstrip({"render", "flat.zsc", "--fov", "40"}).status, 2);
  EXPECT_EQ(zstrip({"render", "house.zsc", "--up", "z"}).status, 2);
}

TEST_F(Bake, BlobsCanBePlannedAndBakedAgain) {
  report({"bake", kHouse, "-o", "house.zsc", "--size", "128x64"});
  const Outcome of_blob = zstrip({"plan", "house.zsc", "--size", "128x64", "--ram", "14K"});
  const Outcome of_model = zstrip({"plan", kHouse, "--size", "128x64", "--ram", "14K"});
  ASSERT_EQ(of_blob.status, 0) << of_blob.err;
  const auto after_title = [](const std::string& text) { return text.substr(text.find('\n')); };
  EXPECT_EQ(after_title(of_blob.out), after_title(of_model.out));

  report({"bake", "house.zsc", "-o", "again.zsc", "--size", "128x64"});
  EXPECT_EQ(read(path("again.zsc")), read(path("house.zsc")));
  report({"bake", "house.zsc", "-o", "blob.hpp", "--size", "128x64"});
  report({"bake", kHouse, "-o", "model.hpp", "--size", "128x64"});
  EXPECT_EQ(after_title(read(path("blob.hpp"))), after_title(read(path("model.hpp"))));
}

TEST_F(Bake, BytesByKindAreThoseOfTheFile) {
  const Json baked = report({"bake", kHouse, "-o", "house.zsc"});
  const Json& flash = baked.at("flash_bytes");
  std::uint64_t sum = 0;
  for (const auto& [kind, bytes] : flash.items()) {
    if (kind != "total") sum += bytes.get<std::uint64_t>();
  }
  EXPECT_EQ(flash.at("total"), sum);
  EXPECT_EQ(flash.at("total"), std::filesystem::file_size(path("house.zsc")));
  EXPECT_EQ(flash.at("triangles"), 6 * baked.at("counts").at("triangles").get<int>());
  EXPECT_EQ(flash.at("positions"), 6 * baked.at("counts").at("vertices").get<int>());
  EXPECT_EQ(flash.at("textures"), 0);
  // With 32-bit addresses a Mesh has 76 bytes, one for each of the three materials.
  EXPECT_EQ(baked.at("plan").at("ram_bytes").at("lent_tables"), 3 * 76);
}

/// The reported error, found once more from the file's text and the blob.
TEST_F(Bake, AccuracyIsWhatTheBlobShows) {
  const std::string obj = sphere_obj(24, 13);
  const Json accuracy = report({"bake", file("sphere.obj", obj), "-o", "sphere.zsc"}).at("accuracy");

  struct Point {
    double x, y, z;
  };
  std::vector<Point> vertices;
  std::istringstream lines(obj);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind;
    Point p{};
    if (words >> kind >> p.x >> p.y >> p.z && kind == "v") vertices.push_back(p);
  }
  const auto extremes = [&](double Point::*axis) {
    const auto [low, high] = std::minmax_element(vertices.begin(), vertices.end(),
                                                 [axis](const Point& a, const Point& b) { return a.*axis < b.*axis; });
    return std::pair{(*low).*axis, (*high).*axis};
  };
  double size = 0;
  Point centre{};
  for (double Point::*axis : {&Point::x, &Point::y, &Point::z}) {
    const auto [low, high] = extremes(axis);
    size = std::max(size, high - low);
    centre.*axis = (low + high) / 2;
  }
  EXPECT_NEAR(accuracy.at("size").get<double>(), size, 1e-5);

  const std::string bytes = read(path("sphere.zsc"));
  std::vector<std::uint64_t> blob(bytes.size() / 8 + 1), memory(scene_blob_memory(4, 4) / 8 + 1);
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(blob.data()));
  SceneBlob opened;
  ASSERT_TRUE(open_scene_blob(std::as_bytes(std::span(blob)).first(bytes.size()),
                              std::as_writable_bytes(std::span(memory)), opened));
  double worst = 0;
  for (const Mesh& mesh : opened.scene.meshes) {
    for (const Position& p : mesh.positions) {
      const auto real = [size](double middle, std::int16_t steps, Fixed half) {
        return middle + steps / 32768.0 * half / 65536.0 * size / 2;
      };
      const Point at{real(centre.x, p.x, mesh.half_extent.x), real(centre.y, p.y, mesh.half_extent.y),
                     real(centre.z, p.z, mesh.half_extent.z)};
      double nearest = size;
      for (const Point& v : vertices) nearest = std::min(nearest, std::hypot(at.x - v.x, at.y - v.y, at.z - v.z));
      worst = std::max(worst, nearest);
    }
  }
  EXPECT_GT(worst, 0);
  EXPECT_LT(worst, size / 32768);
  EXPECT_NEAR(accuracy.at("position").get<double>(), worst, worst * 0.02);
  // Half a step of 1/127 in each of three axes, seen from the origin.
  EXPECT_GT(accuracy.at("normal_degrees"), 0.1);
  EXPECT_LT(accuracy.at("normal_degrees"), 0.4);
}

TEST_F(Bake, EffectsAndWhy) {
  const auto effects = [this](const std::string& scene, const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"bake", scene, "-o", "scene.hpp"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    std::string text;
    const Json baked = report(arguments);
    for (const Json& found : baked.at("effects")) {
      text += found.at("name").get<std::string>() + found.at("materials").dump() + '\n';
    }
    return text;
  };
  EXPECT_EQ(effects(kHouse, {}), "lighting[\"walls\",\"roof\",\"wood\"]\ngouraud[\"walls\",\"roof\",\"wood\"]\n");
  EXPECT_EQ(effects("triangle", {"--mode", "binned"}), "gouraud[\"number 0\"]\nvertex_colours[\"number 0\"]\nbins[]\n");
  EXPECT_NE(effects(kColours, {"--ortho"}).find("vertex_colours"), std::string::npos);
  EXPECT_NE(effects(kColours, {"--ortho"}).find("orthographic[]"), std::string::npos);
  EXPECT_NE(effects("room", {}).find("textures[\"number 0\",\"number 1\"]"), std::string::npos);
}

/// What a header's kEffects say of clipping, and why.
class BakeClipping : public Bake {
 protected:
  /// The report on clipping. It agrees with the header.
  Json clipping(const std::string& scene, const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"bake", scene, "-o", "scene.hpp"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Json baked = report(arguments);
    const bool in_header = read(path("scene.hpp")).find(" | zstrip::effect::unclipped") != std::string::npos;
    const bool in_effects = baked.at("effects").dump().find("\"unclipped\"") != std::string::npos;
    EXPECT_EQ(in_header, baked.at("clipping").at("left_out")) << scene;
    EXPECT_EQ(in_effects, baked.at("clipping").at("left_out")) << scene;
    return baked.at("clipping");
  }
  std::string why(const std::string& scene, const std::vector<std::string>& options) {
    const Json found = clipping(scene, options);
    EXPECT_FALSE(found.at("left_out")) << scene;
    return found.at("why");
  }
  int poses(const std::string& scene, const std::vector<std::string>& options) {
    const Json found = clipping(scene, options);
    EXPECT_TRUE(found.at("left_out")) << scene << ": " << found.at("why");
    return found.at("poses");
  }
};

TEST_F(BakeClipping, IsLeftOutWhereTheWholeMotionIsInFrontOfTheCamera) {
  EXPECT_EQ(poses(kHouse, {"--turntable"}), 65536) << "an angle has 16 bits";
  EXPECT_EQ(poses(kHouse, {"--turntable", "--samples", "4", "--mode", "binned"}), 65536);
  EXPECT_EQ(poses(ZSTRIP_SCENE_FILES "/table.toml", {}), 6000) << "the milliseconds of its animation";
  EXPECT_NE(read(path("scene.hpp")).find("in any of the 6,000 milliseconds of the animation.\n"), std::string::npos);
  // Many instances, two for each sheet, are checked in fewer poses, boards' among them.
  std::string crowd;
  for (int i = 0; i < 50; ++i) crowd += "usemtl m" + std::to_string(i) + '\n' + kTriangleObj;
  EXPECT_EQ(poses(file("crowd.obj", crowd), {"--turntable"}), 32768);
}

TEST_F(BakeClipping, StaysWhereSomethingComesTooNear) {
  EXPECT_EQ(why(kHouse, {"--turntable", "--orbit", "2,30,60"}),
            "instance 0 crosses the near plane in frame 11 of 64 of a turn");
  EXPECT_EQ(why("room", {"--turntable"}), "instance 0 crosses the near plane in frame 0 of 64 of a turn");
  EXPECT_EQ(why(ZSTRIP_SCENE_FILES "/perspective.toml", {"--turntable"}),
            "instance 0 leaves the thousand pixels around the picture's centre in frame 6 of 64 of a turn");
  const Outcome words = zstrip({"bake", kHouse, "-o", "scene.hpp", "--turntable", "--orbit", "2,30,60"});
  EXPECT_NE(words.out.find("  clipping   stays: instance 0 crosses the near plane in frame 11 of 64 of a turn\n"),
            std::string::npos)
      << words.out;
}

TEST_F(BakeClipping, StaysWhereItIsAskedForOrNothingIsKnown) {
  EXPECT_EQ(why(kHouse, {"--turntable", "--clipping", "on"}), "--clipping on");
  EXPECT_EQ(why(kHouse, {}), "without --turntable it is not known how the scene moves");
  EXPECT_EQ(why(ZSTRIP_SCENE_FILES "/outlines.toml", {"--turntable"}),
            "outlines need it: hulls reach beyond the boxes of their instances");
  EXPECT_EQ(report({"bake", kHouse, "-o", "scene.zsc", "--turntable"}).at("clipping"), nullptr)
      << "of a blob the program decides";
  EXPECT_EQ(zstrip({"bake", kHouse, "-o", "scene.hpp", "--clipping", "off"}).status, 2);
}

/// The room's walls have 3 colours in 256 texels, its box more than 16 in 4096.
TEST_F(Bake, PalettesThatLoseNothingChangeNoPixel) {
  const Json plain = report({"bake", "room", "-o", "plain.zsc"});
  EXPECT_EQ(plain.at("flash_bytes").at("textures"), 2 * (256 + 4096));
  EXPECT_EQ(plain.at("palettes"), Json::array());
  EXPECT_EQ(crcs("plain.zsc", {}, 1), crcs("room", {}, 1));

  const Json baked = report({"bake", "room", "-o", "small.zsc", "--textures", "auto"});
  const int bytes = 2 * (16 + 256 / 4 + 256 + 4096 / 2);
  EXPECT_EQ(baked.at("flash_bytes").at("textures"), bytes);
  EXPECT_EQ(plain.at("palettes_would_save"), 2 * (256 + 4096) - bytes);
  EXPECT_EQ(baked.at("palettes_would_save"), 0);
  ASSERT_EQ(baked.at("palettes").size(), 2U);
  const Json& of_walls = baked.at("palettes").at(0);
  EXPECT_EQ(of_walls.at("bits"), 4);
  EXPECT_EQ(of_walls.at("bytes_before"), 512);
  EXPECT_EQ(of_walls.at("bytes"), 160);
  EXPECT_EQ(of_walls.at("largest_error"), (std::vector{0, 0, 0}));
  EXPECT_EQ(baked.at("effects").back().at("name"), "texture_palettes");
  EXPECT_EQ(crcs("small.zsc", {}, 1), crcs("room", {}, 1));
  EXPECT_EQ(crcs("small.zsc", {}, 5), crcs("plain.zsc", {}, 5));

  report({"bake", "small.zsc", "-o", "again.zsc"});
  EXPECT_EQ(read(path("again.zsc")), read(path("small.zsc")));
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

TEST_F(Bake, SetsOfLinesAreCountedAmongTheTablesToLend) {
  const Json baked = report({"bake", ZSTRIP_SCENE_FILES "/lines.toml", "-o", "scene.zsc"});
  const std::string bytes = read(path("scene.zsc"));
  std::vector<std::uint64_t> blob(bytes.size() / 8 + 1), memory(10000);
  std::memcpy(blob.data(), bytes.data(), bytes.size());
  SceneBlob opened;
  ASSERT_TRUE(open_scene_blob(std::as_bytes(std::span(blob)).first(bytes.size()),
                              std::as_writable_bytes(std::span(memory)), opened));
  const Scene& scene = opened.scene;
  ASSERT_GT(scene.lines.size(), 3U);
  EXPECT_EQ(baked.at("plan").at("ram_bytes").at("lent_tables"),
            76 * scene.meshes.size() + 12 * scene.textures.size() + 64 * scene.lines.size());
}

TEST_F(Bake, ShadowsInABlobAsInTheSceneFile) { same_as_a_blob("shadows", "shadows", {}, 3); }

TEST_F(Bake, ProductsOfSolidsInABlobAsInTheSceneFile) {
  same_as_a_blob("csg", "csg", {}, 3);
  report({"bake", ZSTRIP_SCENE_FILES "/csg.toml", "-o", "scene.hpp"});
  EXPECT_NE(read(path("scene.hpp")).find(".csg = kCsg"), std::string::npos);
}

TEST_F(Bake, MipmapsWhereTheSceneAsksForThemOrEverywhereOrNowhere) {
  const std::string scene = ZSTRIP_SCENE_FILES "/mipmaps.toml";
  const auto levels = [](int texels) {  // of a square, all but the first
    int sum = 0;
    for (; texels > 1; texels /= 4) sum += texels / 4;
    return sum;
  };
  const Json asked = report({"bake", scene, "-o", "asked.zsc"});
  ASSERT_EQ(asked.at("mipmaps").size(), 1U) << "the material on the right";
  EXPECT_EQ(asked.at("mipmaps").at(0).at("smaller_levels"), 6);
  EXPECT_EQ(asked.at("mipmaps").at(0).at("bytes"), 2 * levels(4096));
  const auto effect =
      std::ranges::find_if(asked.at("effects"), [](const Json& e) { return e.at("name") == "mipmaps"; });
  ASSERT_NE(effect, asked.at("effects").end());
  EXPECT_EQ(effect->at("materials"), Json::array({"tiles with mipmaps"}));
  EXPECT_EQ(crcs("asked.zsc", {"--size", "320x240"}, 1), crcs(scene, {"--size", "320x240"}, 1));
  report({"bake", "asked.zsc", "-o", "again.zsc", "--size", "320x240"});
  report({"bake", scene, "-o", "asked.zsc", "--size", "320x240"});
  EXPECT_EQ(read(path("again.zsc")), read(path("asked.zsc")));

  const Json off = report({"bake", scene, "-o", "off.zsc", "--mipmaps", "off"});
  EXPECT_EQ(off.at("mipmaps"), Json::array());
  EXPECT_EQ(off.at("flash_bytes").at("textures"), 2 * 2 * 4096);
  EXPECT_EQ(report({"bake", scene, "-o", "on.zsc", "--mipmaps", "on"}).at("mipmaps").size(), 2U);

  // The room: levels for its walls and its box, and a finish for their materials; with palettes of all levels.
  const Json room = report({"bake", "room", "-o", "room.zsc", "--mipmaps", "on"});
  EXPECT_EQ(room.at("mipmaps").size(), 2U);
  EXPECT_EQ(room.at("flash_bytes").at("textures"), 2 * (256 + levels(256) + 4096 + levels(4096)));
  EXPECT_NE(crcs("room.zsc", {}, 1), crcs("room", {}, 1));
  const Json small = report({"bake", "room", "-o", "small.zsc", "--mipmaps", "on", "--textures", "auto"});
  ASSERT_EQ(small.at("palettes").size(), 2U);
  EXPECT_EQ(small.at("palettes").at(0).at("largest_error"), (std::vector{0, 0, 0}));
  EXPECT_EQ(crcs("small.zsc", {}, 3), crcs("room.zsc", {}, 3));

  const Outcome words = zstrip({"bake", scene, "-o", "scene.hpp"});
  EXPECT_NE(words.out.find("  mipmaps    texture 1: 2,730 bytes for 6 smaller levels\n"), std::string::npos)
      << words.out;
  EXPECT_NE(read(path("scene.hpp")).find(".smaller_levels = 6"), std::string::npos);
  EXPECT_EQ(zstrip({"bake", scene, "-o", "scene.hpp", "--mipmaps", "some"}).status, 2);
}

TEST_F(Bake, PalettesThatLoseSomethingSayHowMuch) {
  const std::string scene = ZSTRIP_SCENE_FILES "/palette.toml";
  const auto baked = [&](const char* textures) {
    return report({"bake", scene, "-o", "scene.zsc", "--textures", textures}).at("palettes");
  };
  EXPECT_EQ(baked("rgb565"), Json::array());
  EXPECT_EQ(baked("auto"), Json::array()) << "more than 256 colours";
  for (const auto& [choice, bits, bytes] :
       {std::tuple{"palette8", 8, 2 * (256 + 2048)}, {"palette4", 4, 2 * (16 + 1024)}}) {
    const Json palettes = baked(choice);
    ASSERT_EQ(palettes.size(), 1U) << "the other two have one already";
    EXPECT_EQ(palettes.at(0).at("bits"), bits);
    EXPECT_EQ(palettes.at(0).at("bytes"), bytes);
    EXPECT_EQ(palettes.at(0).at("bytes_before"), 2 * 4096);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double largest = palettes.at(0).at("largest_error").at(channel);
      const double mean = palettes.at(0).at("mean_error").at(channel);
      EXPECT_GT(mean, 0);
      EXPECT_LT(mean, largest);
      EXPECT_LT(largest, 96);
    }
  }
  const Outcome words = zstrip({"bake", scene, "-o", "scene.hpp", "--textures", "palette8"});
  EXPECT_NE(words.out.find("  palettes   texture 0: 256 colours, 4,608 instead of 8,192 bytes: at most "),
            std::string::npos)
      << words.out;
  const Outcome advice = zstrip({"bake", "room", "-o", "scene.hpp"});
  EXPECT_NE(advice.out.find("--textures auto would save 3,936 bytes"), std::string::npos) << advice.out;
}

TEST_F(Bake, SummaryInWords) {
  const Outcome outcome = zstrip({"bake", kHouse, "-o", "house.hpp", "--size", "128x64", "--ram", "14K"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const char* part : {"flash", "positions: at most", "of the model's size", "normals: at most", "degrees off",
                           "lighting: lit, with normals: material 'walls' and 2 more", "RAM", "written    house.hpp"}) {
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part << '\n' << outcome.out;
  }
}

TEST_F(Bake, SameSceneSameBytes) {
  for (const char* name : {"a.zsc", "b.zsc", "a.hpp", "b.hpp"}) report({"bake", kHouse, "-o", name});
  EXPECT_EQ(read(path("a.zsc")), read(path("b.zsc")));
  EXPECT_EQ(read(path("a.hpp")), read(path("b.hpp")));
}

TEST_F(Bake, Refusals) {
  const auto expect = [this](const std::vector<std::string>& arguments, int status, const char* words) {
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, status) << words << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  };
  expect({"bake", kHouse}, 2, "--output");
  expect({"bake", kHouse, "-o", "house.txt"}, 2, ".hpp");
  expect({"bake", kHouse, "-o", "house.hpp", "--namespace", "My-House"}, 2, "--namespace");
  expect({"bake", kHouse, "-o", "house.hpp", "--namespace", "zstrip"}, 2, "--namespace");
  expect({"bake", kHouse, "-o", "house.hpp", "--namespace", "a__b"}, 2, "--namespace");
  expect({"bake", kHouse, "-o", "house.hpp", "--namespace", "class"}, 2, "no word of C++");
  expect({"bake", "teapot", "-o", "house.hpp", "--up", "z"}, 2, "--up");
  expect({"bake", kHouse, "-o", "house.hpp", "--size", "0x0"}, 2, "--size");
  expect({"bake", "room", "-o", "room.hpp", "--textures", "palette"}, 2, "--textures");
  expect({"bake", "none.obj", "-o", "house.hpp"}, 4, "none.obj");
  expect({"bake", kHouse, "-o", "house.hpp", "--ram", "100"}, 5, "bytes");
  expect({"bake", kHouse, "-o", "nowhere/house.hpp"}, 6, "nowhere");
  file("model.zsc", "no blob");
  expect({"bake", "model.zsc", "-o", "model.zsc"}, 2, "the model itself");
  expect({"bake", kHouse, "-o", "house.hpp", "--json", "house.hpp"}, 2, "--json");
  EXPECT_EQ(files(), std::vector<std::string>{"model.zsc"}) << "nothing is left behind";
}

TEST_F(Bake, DamagedBlobsAreInputErrors) {
  report({"bake", kHouse, "-o", "house.zsc"});
  const std::string whole = read(path("house.zsc"));
  const auto expect = [this](const std::string& content, const char* words) {
    const std::string blob = file("damaged.zsc", content);
    for (const char* command : {"render", "plan"}) {
      const Outcome outcome = zstrip({command, blob});
      EXPECT_EQ(outcome.status, 4) << outcome.err;
      EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    }
  };
  expect("", "byte 0");
  expect(whole.substr(0, whole.size() / 2), "is no whole baked scene");
  expect(whole + "more", "is no whole baked scene (byte 4)");
  std::string flipped = whole;
  flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 1);
  expect(flipped, "is no whole baked scene (byte 8)");
  std::string other = whole;
  for (const int version : {3, 4, 6}) {
    other[2] = static_cast<char>(version);
    expect(other, (std::to_string(version) + ", and this zstrip reads version 5; bake it again").c_str());
    expect(other, "zstrip bake MODEL -o FILE.zsc");
  }
  std::vector<Piece> pieces = pieces_of({whole.begin(), whole.end()});
  pieces.insert(pieces.begin(), {"AbCd", {1}});
  const Bytes newer = blob_of(pieces);
  expect({newer.begin(), newer.end()}, "a section 'AbCd' that this zstrip does not know; take a newer zstrip");
  EXPECT_EQ(zstrip({"render", "none.zsc"}).status, 4);
}

}  // namespace
}  // namespace zstrip::sim::test
