// The command as its users see it: help, list, files, reports.
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "command_fixture.hpp"

namespace zstrip::sim::test {
namespace {

/// How many pixels are not of the colour of the upper left one.
std::size_t painted(const RgbImage& image) {
  std::size_t count = 0;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      if (!std::equal(image.pixel(x, y), image.pixel(x, y) + 3, image.pixel(0, 0))) ++count;
    }
  }
  return count;
}

TEST_F(Command, HelpWithExamplesOnEveryCommand) {
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{{}, {"render"}, {"scenes"}}) {
    std::vector<std::string> arguments = command;
    arguments.push_back("--help");
    const Outcome help = zstrip(arguments);
    EXPECT_EQ(help.status, 0);
    EXPECT_NE(help.out.find("Example"), std::string::npos) << help.out;
    EXPECT_EQ(help.err, "");
  }
}

TEST_F(Command, MeasuringWithoutItsProgramSaysWhatToBuild) {
  std::filesystem::copy_file(ZSTRIP_COMMAND, path("zstrip"));
  for (const char* name : {"bench", "accuracy", "tune"}) {
    const Outcome outcome = run(path("zstrip"), {name, "--help"}, path(""));
    EXPECT_EQ(outcome.status, 3) << name;
    EXPECT_NE(outcome.err.find("build the target zstrip-measure"), std::string::npos) << outcome.err;
  }
}

TEST_F(Command, ARarePipelineIsThatOfZstripAnyAndWithoutItTheCommandSaysWhatToBuild) {
  std::filesystem::copy_file(ZSTRIP_COMMAND, path("zstrip"));
  for (const std::vector<std::string>& rare : std::vector<std::vector<std::string>>{{"--depth-format", "z24"},
                                                                                    {"--perspective", "affine"},
                                                                                    {"--visibility", "painter"},
                                                                                    {"--show", "overdraw"}}) {
    std::vector<std::string> words{"render", "knot_textured", "-o", "rare.png"};
    words.insert(words.end(), rare.begin(), rare.end());
    const Outcome outcome = run(path("zstrip"), words, path(""));
    EXPECT_EQ(outcome.status, 3) << rare[1];
    EXPECT_NE(outcome.err.find("build the target zstrip-any"), std::string::npos) << outcome.err;
    EXPECT_EQ(zstrip(words).status, 0) << rare[1];
  }
  EXPECT_EQ(run(path("zstrip"), {"render", "knot_textured", "-o", "common.png"}, path("")).status, 0);
}

TEST_F(Command, WarningsAreSaidOnceWhereARarePipelineDraws) {
  std::ofstream(path("unknown.obj")) << "usemtl none\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const Outcome common = zstrip({"render", "unknown.obj", "-o", "a.png"});
  const Outcome rare = zstrip({"render", "unknown.obj", "-o", "b.png", "--depth-format", "z24"});
  EXPECT_NE(common.err.find("warning: "), std::string::npos) << common.err;
  EXPECT_EQ(rare.err, common.err);
}

TEST_F(Command, PicksWhatAPixelShows) {
  std::ofstream(path("two.obj")) << "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3\nf 1 3 4\n";
  const auto picked = [this](const std::string& place) {
    const Outcome outcome =
        zstrip({"render", "two.obj", "-o", "p.png", "--size", "100x100", "--quiet", "--json", "-", "--pick", place});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out).at("frames")[0].at("picked");
  };
  EXPECT_EQ(picked("0,0"), nlohmann::json({{"x", 0}, {"y", 0}, {"shown", "background"}}));
  const nlohmann::json lower = picked("70,70"), upper = picked("30,30");
  EXPECT_EQ(lower.at("shown"), "instance");
  EXPECT_EQ(lower.at("index"), upper.at("index"));
  EXPECT_EQ(lower.at("triangle"), 0);
  EXPECT_EQ(upper.at("triangle"), 1);
  const Outcome words = zstrip({"render", "room", "-o", "p.png", "--size", "160x120", "--pick", "80,60"});
  EXPECT_NE(words.out.find("  picked     80,60: instance "), std::string::npos) << words.out;
  EXPECT_NE(words.out.find(", texture 0."), std::string::npos) << words.out;
}

TEST_F(Command, APickThatCannotBeIsAUsageErrorAndWritesNothing) {
  for (const auto& [options, words] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--pick", "7"}, "is not a pixel X,Y"},
           {{"--pick", "7,"}, "is not a pixel X,Y"},
           {{"--pick", "7,8,9"}, "is not a pixel X,Y"},
           {{"--pick", "-1,8"}, "is not a pixel X,Y"},
           {{"--pick", "70000,8"}, "is not a pixel X,Y"},
           {{"--pick", "80,8", "--size", "80x60"}, "outside of the picture"},
           {{"--pick", "8,8", "--depth-format", "z24"}, "--pick needs --depth-format z16"},
           {{"--pick", "8,8", "--visibility", "painter"}, "leave out --visibility"}}) {
    std::vector<std::string> arguments{"render", "knot", "-o", "none.png"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 2) << options[1];
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  }
  EXPECT_FALSE(std::filesystem::exists(path("none.png")));
}

TEST_F(Command, Version) {
  const Outcome version = zstrip({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out.rfind("zstrip ", 0), 0U);
}

TEST_F(Command, ScenesListsWhatRenders) {
  const Outcome scenes = zstrip({"scenes"});
  EXPECT_EQ(scenes.status, 0);
  std::istringstream lines(scenes.out);
  std::string line;
  std::getline(lines, line);
  int count = 0;
  while (std::getline(lines, line)) {
    const std::string name = line.substr(0, line.find(' '));
    EXPECT_EQ(zstrip({"render", name, "-o", name + ".png"}).status, 0) << name;
    EXPECT_GT(painted(picture(name + ".png")), 1000U) << name;
    ++count;
  }
  EXPECT_GE(count, 5);
}

TEST_F(Command, OneFileWithoutOptions) {
  const Outcome outcome = zstrip({"render", "teapot"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  for (const char* word : {"triangles", "drawn", "fragments", "bounds", "strips", "RAM", "depth", "time"}) {
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
  }
  EXPECT_EQ(files(), std::vector<std::string>{"teapot.png"});
  EXPECT_EQ(picture("teapot.png").width, 320U);
  EXPECT_EQ(picture("teapot.png").height, 240U);
}

TEST_F(Command, FramesOfATurnDiffer) {
  EXPECT_EQ(zstrip({"render", "teapot", "-o", "turn", "--frames", "3", "--quiet"}).status, 0);
  EXPECT_EQ(files(), (std::vector<std::string>{"turn/frame_0000.png", "turn/frame_0001.png", "turn/frame_0002.png"}));
  EXPECT_NE(read(path("turn/frame_0000.png")), read(path("turn/frame_0001.png")));
}

TEST_F(Command, QuietIsQuiet) {
  const Outcome outcome = zstrip({"render", "teapot", "--quiet"});
  EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST_F(Command, JsonHasTheDocumentedKeys) {
  const Outcome outcome = zstrip({"render", "teapot", "-o", "t", "--frames", "2", "--json", "-", "--strip-rows", "16"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("scene"), "teapot");
  EXPECT_EQ(json.at("width"), 320);
  EXPECT_EQ(json.at("height"), 240);
  EXPECT_EQ(json.at("format"), "rgb565");
  EXPECT_TRUE(json.at("warnings").empty());
  ASSERT_EQ(json.at("frames").size(), 2U);
  const auto& frame = json.at("frames").at(1);
  EXPECT_EQ(frame.at("frame"), 1);
  EXPECT_EQ(frame.at("file"), "t/frame_0001.png");
  EXPECT_EQ(frame.at("crc32").get<std::string>().size(), 8U);
  EXPECT_EQ(frame.at("strip_rows"), 16);
  EXPECT_EQ(frame.at("strips"), 15);
  EXPECT_GT(frame.at("time_ns"), 0);
  std::uint64_t sum = 0;
  for (const char* purpose : {"instances", "extents", "vertices", "depth", "colour", "bins", "effects"}) {
    sum += frame.at("ram_bytes").at(purpose).get<std::uint64_t>();
  }
  EXPECT_EQ(frame.at("ram_bytes").at("arena"), sum);
  EXPECT_EQ(frame.at("ram_bytes").at("strip_pixels"), 16 * 640);
  EXPECT_GT(frame.at("statistics").at("drawn"), 0);
  EXPECT_LE(frame.at("statistics").at("drawn"), frame.at("statistics").at("triangles"));
  EXPECT_GT(frame.at("bounds").at("right"), frame.at("bounds").at("left"));
}

TEST_F(Command, StripsOfAnyShapeGiveTheSamePicture) {
  std::set<std::string> sums;
  for (const std::vector<std::string>& strips : std::vector<std::vector<std::string>>{
           {}, {"--strip-rows", "7"}, {"--strip-columns", "40", "--strip-rows", "50"}, {"--ram", "20K"}}) {
    std::vector<std::string> words{"render", "knot_textured", "-o", "k.raw", "--quiet", "--json", "-"};
    words.insert(words.end(), strips.begin(), strips.end());
    const Outcome outcome = zstrip(words);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    sums.insert(nlohmann::json::parse(outcome.out).at("frames").at(0).at("crc32").get<std::string>());
  }
  EXPECT_EQ(sums.size(), 1U);
}

TEST_F(Command, RawIsWhatTheCrcIsOf) {
  const Outcome outcome = zstrip({"render", "teapot", "-o", "t.raw", "--json", "-", "--quiet"});
  ASSERT_EQ(outcome.status, 0);
  const std::string raw = read(path("t.raw"));
  ASSERT_EQ(raw.size(), 320U * 240U * 2U);
  std::uint32_t crc = 0xFFFFFFFF;  // bit by bit: an implementation of its own
  for (const char c : raw) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320 : 0);
  }
  const std::string told = nlohmann::json::parse(outcome.out).at("frames").at(0).at("crc32");
  EXPECT_EQ(std::stoul(told, nullptr, 16), ~crc & 0xFFFFFFFF);
}

TEST_F(Command, EveryFormatAndType) {
  for (const char* format : {"rgb565", "rgb565_swapped", "gray4", "mono"}) {
    for (const char* type : {"png", "ppm", "raw"}) {
      const std::string folder = std::string(format) + "-" + type;
      EXPECT_EQ(zstrip({"render", "teapot", "--format", format, "--image", type, "-o", folder, "--frames", "1"}).status,
                0);
    }
  }
  EXPECT_EQ(picture("rgb565-png/frame_0000.png").rgb, picture("rgb565_swapped-png/frame_0000.png").rgb);
  EXPECT_GT(painted(picture("gray4-png/frame_0000.png")), 1000U);
  EXPECT_GT(painted(picture("mono-png/frame_0000.png")), 1000U);
  EXPECT_EQ(files().size(), 12U);
}

TEST_F(Command, SmallestAndLargestPicture) {
  EXPECT_EQ(zstrip({"render", "teapot", "--size", "1x1", "-o", "small.png"}).status, 0);
  EXPECT_EQ(picture("small.png").rgb.size(), 3U);
  EXPECT_EQ(zstrip({"render", "teapot", "--size", "4096x4096", "-o", "large.png", "--ram", "1M"}).status, 0);
  const RgbImage large = picture("large.png");
  EXPECT_EQ(large.width, 4096U);
  EXPECT_GT(painted(large), 1000000U);
}

TEST_F(Command, OneTriangleModelFillsThePicture) {
  file("t.obj", kTriangleObj);
  EXPECT_EQ(zstrip({"render", "t.obj"}).status, 0);
  EXPECT_GT(painted(picture("t.png")), 320U * 240U / 6U);
}

TEST_F(Command, CamerasSeeTheModelFromTheirSide) {
  file("t.obj", kTriangleObj);
  const auto seen = [&](const std::vector<std::string>& camera) {
    std::vector<std::string> arguments{"render", "t.obj", "-o", "t.png"};
    arguments.insert(arguments.end(), camera.begin(), camera.end());
    EXPECT_EQ(zstrip(arguments).status, 0);
    return painted(picture("t.png"));
  };
  EXPECT_GT(seen({"--eye", "0.5,0.5,4"}), 1000U);
  EXPECT_GT(seen({"--eye", "0.5,0.5,-4", "--fov", "20"}), 1000U);
  EXPECT_EQ(seen({"--eye", "0.5,0.5,4", "--look-at", "0.5,0.5,8"}), 0U);
  EXPECT_GT(seen({"--orbit", "4,0,90", "--ortho"}), 1000U);
}

/// --up Z was unknown; did they mean x?
TEST_F(Command, WordsOfOptionsMayBeInUpperCase) {
  file("model.obj", "v 0 0 0\nv 1 0 0\nv 0 1 2\nf 1 2 3\n");
  const auto drawn = [this](const std::vector<std::string>& options) {
    std::vector<std::string> words{"render", "model.obj", "-o", "a.raw", "--quiet"};
    words.insert(words.end(), options.begin(), options.end());
    const Outcome outcome = zstrip(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read(path("a.raw"));
  };
  EXPECT_EQ(drawn({"--up", "-Z", "--format", "RGB444", "--size", "64X48", "--ram", "20KB", "--strip-rows", "AUTO"}),
            drawn({"--up", "-z", "--format", "rgb444", "--size", "64x48", "--ram", "20K", "--strip-rows", "auto"}));
  EXPECT_EQ(drawn({"--visibility", "Painter", "--sort-key", "Farthest", "--cull", "None"}),
            drawn({"--visibility", "painter", "--sort-key", "farthest", "--cull", "none"}));
  EXPECT_EQ(drawn({"--panel", "ST7789", "--bus", "SPI@40mhz"}), drawn({"--panel", "st7789", "--bus", "spi@40MHz"}));
  EXPECT_EQ(drawn({"--show", "Depth", "--depth-format", "Z24"}), drawn({"--show", "depth", "--depth-format", "z24"}));
  EXPECT_EQ(zstrip({"bake", "model.obj", "-o", "a.HPP", "--textures", "AUTO", "--mode", "Any"}).status, 0);
  const auto planned = [this](const std::string& mode) { return zstrip({"plan", "teapot", "--mode", mode}).out; };
  EXPECT_EQ(planned("STREAMED"), planned("streamed"));
  EXPECT_NE(planned("STREAMED"), planned("binned"));
}

TEST_F(Command, OnlyTheDirectionOfUpCounts) {
  std::string expected;
  for (const char* up : {"[1, 2, 0]", "[1e5, 2e5, 0]", "[1e-6, 2e-6, 0]"}) {
    file("scene.toml", std::string("[[model]]\nname = 'a'\nbuilt_in = 'cube'\n[[instance]]\nmodel = 'a'\n[camera]\n"
                                   "eye = [0, 1, 5]\nup = ") +
                           up + "\n");
    const Outcome outcome = run(ZSTRIP_COMMAND, {"render", "scene.toml", "-o", "a.png"}, path(""));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const std::string picture = read(path("a.png"));
    if (expected.empty()) expected = picture;
    EXPECT_EQ(picture, expected) << up;
  }
}

TEST_F(Command, WarningsAreLinesOnStderrAndInTheReport) {
  file("m.mtl", "newmtl a\nKd 1 1 1\nmap_Kd missing.png\n");
  file("t.obj", "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
  const Outcome outcome = zstrip({"render", "t.obj", "--quiet", "--json", "-"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err.rfind("zstrip: warning: texture", 0), 0U) << outcome.err;
  EXPECT_NE(outcome.err.find("missing.png"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("warnings").size(), 1U);
}

TEST_F(Command, TexturesOutsideAndInsideTheModel) {
  const std::filesystem::path models = ASSIMP_MODELS;
  if (models.empty()) GTEST_SKIP() << "package assimp-testmodels is not installed";
  const auto render = [&](const std::string& model) {
    const Outcome outcome =
        zstrip({"render", (models / model).string(), "-o", "box.png", "--quiet", "--orbit", "2.7,0,70"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    return picture("box.png");
  };
  const auto outside = render("glTF2/BoxTextured-glTF/BoxTextured.gltf");
  const auto inside = render("glTF2/BoxTextured-glTF-Binary/BoxTextured.glb");
  EXPECT_EQ(inside.rgb, render("glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf").rgb);
  // The first file mirrors its texture, where its coordinates are the second repeat; the others repeat it. So one
  // picture is the other in a mirror, but for the edges.
  ASSERT_EQ(outside.width, inside.width);
  std::size_t different = 0, different_alike = 0;
  std::set<std::array<std::uint8_t, 3>> colours;
  for (std::uint32_t y = 0; y < inside.height; ++y) {
    for (std::uint32_t x = 0; x < inside.width; ++x) {
      const auto colour = [y](const RgbImage& image, std::uint32_t at) {
        const std::uint8_t* const pixel = image.pixel(at, y);
        return std::array<std::uint8_t, 3>{pixel[0], pixel[1], pixel[2]};
      };
      different += colour(outside, inside.width - 1 - x) != colour(inside, x);
      different_alike += colour(outside, x) != colour(inside, x);
      colours.insert(colour(inside, x));
    }
  }
  EXPECT_LT(different, 60U);
  EXPECT_GT(different_alike, 10000U) << "the picture is not its own mirror image";
  EXPECT_GT(colours.size(), 20U) << "a picture of a texture has many colours";
}

/// `render house.obj` wrote house.png, its texture's name. So did -o, --json and the frames of a folder.
TEST_F(Command, FilesThatTheSceneReadsAreNotReplaced) {
  ASSERT_EQ(zstrip({"render", "cube", "-o", "house.png", "--size", "8x8", "--quiet"}).status, 0);
  std::filesystem::create_directory(path("turn"));
  std::filesystem::copy_file(path("house.png"), path("turn/frame_0001.png"));
  std::filesystem::create_symlink("house.png", path("link.png"));
  file("house.obj", "mtllib house.mtl\nvt 0 0\nusemtl wall\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/1 3/1\n");
  file("house.mtl", "newmtl wall\nmap_Kd house.png\n");
  file("turned.obj", "mtllib turned.mtl\nvt 0 0\nusemtl wall\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/1 3/1\n");
  file("turned.mtl", "newmtl wall\nmap_Kd turn/frame_0001.png\n");
  file("scene.toml", "[[model]]\nname = 'house'\nfile = 'house.obj'\n[[instance]]\nmodel = 'house'\n");
  const std::vector<std::string> before = files();
  std::vector<std::string> contents;
  for (const std::string& name : before) contents.push_back(read(path(name)));
  using Words = std::vector<std::string>;
  for (const Words& words : {Words{"render", "house.obj"}, Words{"render", "scene.toml", "-o", "link.png"},
                             Words{"render", "scene.toml", "-o", "house.obj", "--image", "png"},
                             Words{"render", "scene.toml", "-o", "/dev/null", "--image", "png", "--json", "house.mtl"},
                             Words{"render", "turned.obj", "-o", "turn", "--frames", "3"},
                             Words{"bake", "scene.toml", "-o", "scene.hpp", "--visible-sets", "scene.toml"},
                             Words{"bake", "scene.toml", "-o", "scene.hpp", "--json", "house.png"}}) {
    const Outcome outcome = zstrip(words);
    EXPECT_EQ(outcome.status, 2) << words[1];
    EXPECT_NE(outcome.err.find("is read by this command and is not replaced"), std::string::npos) << outcome.err;
  }
  ASSERT_EQ(files(), before);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(read(path(before[i])), contents[i]) << before[i];
}

/// Were refused as damaged or empty.
TEST_F(Command, ModelsInUtf16AndRawWithGroups) {
  const std::filesystem::path models = ASSIMP_MODELS;
  if (models.empty()) GTEST_SKIP() << "package assimp-testmodels is not installed";
  const auto render = [&](const std::string& model) {
    const Outcome outcome = zstrip({"render", (models / model).string(), "-o", "p.png", "--quiet"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_GT(painted(picture("p.png")), 1000U) << model;
    return picture("p.png").rgb;
  };
  const auto cubes = render("ASE/ThreeCubesGreen.ASE");
  EXPECT_EQ(render("ASE/ThreeCubesGreen_UTF16LE.ASE"), cubes);
  EXPECT_EQ(render("ASE/ThreeCubesGreen_UTF16BE.ASE"), cubes);
  for (const char* model : {"AC/SphereWithLight_UTF16LE.ac", "Collada/cube_UTF16LE.dae", "OBJ/box_UTF16BE.obj",
                            "RAW/WithColor.raw", "RAW/WithTexture.raw", "RAW/Wuson.raw"}) {
    render(model);
  }
}

/// Strips, bins, visibility by spheres of meshlets that move, threads: every way to draw a skin shows the one picture.
TEST_F(Command, ASkinIsTheSamePictureHoweverItIsDrawn) {
  const std::string figure = ZSTRIP_SCENE_FILES "/figure/figure.gltf";
  const auto rendered = [&](const std::string& folder, const std::vector<std::string>& more) {
    // From here no two surfaces have one depth in a pixel: the first one drawn would be seen.
    std::vector<std::string> arguments{"render",   figure, "-o",      folder,    "--size", "120x160",
                                       "--frames", "3",    "--quiet", "--orbit", "5,30,70"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    std::vector<decltype(picture("").rgb)> frames;
    for (const char* name : {"/frame_0000.png", "/frame_0001.png", "/frame_0002.png"}) {
      frames.push_back(picture(folder + name).rgb);
    }
    return frames;
  };
  const auto whole = rendered("whole", {});
  EXPECT_NE(whole[0], whole[1]);
  EXPECT_EQ(rendered("strips", {"--strip-rows", "8"}), whole);
  EXPECT_EQ(rendered("small", {"--ram", "12K"}), whole);
  EXPECT_EQ(rendered("one", {"--threads", "1", "--strip-rows", "40"}), whole);
  EXPECT_EQ(rendered("near", {"--visibility", "front-to-back-hierarchical-z", "--cull", "back-faces,small,spheres"}),
            whole);
  EXPECT_NE(rendered("wave", {"--animation", "wave"}), whole);
}

TEST_F(Command, ExamplesOfHelpWork) {
  int run = 0;
  for (const std::vector<std::string>& help : std::vector<std::vector<std::string>>{{"--help"}, {"render", "--help"}}) {
    std::istringstream lines(zstrip(help).out);
    std::string line;
    while (std::getline(lines, line)) {
      std::istringstream words(line);
      std::string word;
      words >> word;
      if (word != "zstrip" || line.rfind("  ", 0) != 0) continue;
      std::vector<std::string> arguments;
      while (words >> word) arguments.push_back(word);
      const bool needs_file =
          arguments.size() > 1 && std::filesystem::path(arguments[1]).extension() != std::filesystem::path();
      if (needs_file) continue;
      const Outcome outcome = zstrip(arguments);
      EXPECT_EQ(outcome.status, 0) << line << '\n' << outcome.err;
      ++run;
    }
  }
  EXPECT_GE(run, 5);
}

TEST_F(Command, TwoDashesEndTheOptions) {
  file("-odd.obj", kTriangleObj);
  EXPECT_EQ(zstrip({"render", "-o", "odd.png", "--quiet", "--", "-odd.obj"}).status, 0);
  EXPECT_EQ(zstrip({"render", "cube", "-o", "cube.png", "--quiet", "--"}).status, 0);
  EXPECT_EQ(files(), (std::vector<std::string>{"-odd.obj", "cube.png", "odd.png"}));
}

TEST_F(Command, NothingDrawnIsAWarning) {
  const Outcome outcome =
      zstrip({"render", "teapot", "--eye", "0,0,4", "--look-at", "0,0,8", "--quiet", "--json", "-"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err.rfind("zstrip: warning: no pixel was drawn", 0), 0U) << outcome.err;
  EXPECT_EQ(outcome.err.find("--up"), std::string::npos) << "built-in scenes have no --up";
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("warnings").size(), 1U);
  file("t.obj", kTriangleObj);
  EXPECT_NE(zstrip({"render", "t.obj", "--eye", "0,0,4", "--look-at", "0,0,8", "--quiet"}).err.find("--up"),
            std::string::npos);
}

TEST_F(Command, FieldOfViewAndProjectionOfABuiltInScene) {
  const auto seen = [&](const std::vector<std::string>& camera) {
    std::vector<std::string> arguments{"render", "teapot", "-o", "t.png", "--quiet"};
    arguments.insert(arguments.end(), camera.begin(), camera.end());
    EXPECT_EQ(zstrip(arguments).status, 0);
    return painted(picture("t.png"));
  };
  const std::size_t narrow = seen({"--fov", "40"});
  const std::size_t wide = seen({"--fov", "80"});
  EXPECT_GT(narrow, 2 * wide);
  EXPECT_GT(wide, 1000U);
  // Parallel, it shows about what the field of view does.
  EXPECT_NEAR(static_cast<double>(seen({"--fov", "80", "--ortho"})), static_cast<double>(wide),
              0.3 * static_cast<double>(wide));
}

TEST_F(Command, PictureOnStandardOutputIsNothingElse) {
  const Outcome outcome = zstrip({"render", "teapot", "-o", "/dev/stdout", "--image", "raw"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.size(), 320U * 240U * 2U);
  EXPECT_NE(outcome.err.find("triangles"), std::string::npos) << "the summary is on standard error";
}

}  // namespace
}  // namespace zstrip::sim::test
