// The command as its users see it: help, list, files, reports.
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "image/decode.hpp"
#include "support.hpp"

namespace zstrip::sim::test {
namespace {

class Command : public FolderTest {
 protected:
  Outcome zstrip(const std::vector<std::string>& arguments) const { return run(ZSTRIP_COMMAND, arguments, path("")); }
  RgbImage picture(const std::string& name) const {
    const std::string bytes = read(path(name));
    const auto image = decode_image({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    EXPECT_TRUE(image);
    return *image;
  }
};

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

/// Of its 128x64 pixels in strips of any height and on any threads, also where the option says what the file does.
TEST_F(Command, DitheredSceneHasItsChecksum) {
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
  const std::string golden = "070a1f43";
  EXPECT_EQ(drawn({}), golden);
  EXPECT_EQ(drawn({"--strip-rows", "1"}), golden);
  EXPECT_EQ(drawn({"--strip-rows", "7", "--strip-columns", "24"}), golden);
  EXPECT_EQ(drawn({"--dither", "--threads", "3", "--strip-rows", "5"}), golden);
  EXPECT_NE(drawn({"--no-dither"}), golden);
}

/// As many as the option or the scene file says; in strips of any height and on any threads.
TEST_F(Command, SamplesAreAveraged) {
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

TEST_F(Command, SamplesThatCannotBeAreRefused) {
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

/// Of three boxes with 65536, 256 and 16 colours: in strips of any height, on any threads, and baked.
TEST_F(Command, SceneWithPalettesHasItsChecksum) {
  const std::string scene = ZSTRIP_SCENE_FILES "/palette.toml";
  const auto drawn = [&](const std::string& file, const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"render", file, "-o", "p.png", "--size", "192x64", "--quiet", "--json", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    if (outcome.status != 0) return std::string();
    return nlohmann::json::parse(outcome.out).at("frames").at(0).at("crc32").get<std::string>();
  };
  const std::string golden = "7a55f4ee";
  EXPECT_EQ(drawn(scene, {}), golden);
  EXPECT_EQ(drawn(scene, {"--strip-rows", "1"}), golden);
  EXPECT_EQ(drawn(scene, {"--strip-rows", "7", "--strip-columns", "24"}), golden);
  EXPECT_EQ(drawn(scene, {"--threads", "3", "--strip-rows", "5"}), golden);
  EXPECT_EQ(zstrip({"bake", scene, "-o", "p.zsc", "--size", "192x64", "--quiet"}).status, 0);
  EXPECT_EQ(drawn("p.zsc", {}), golden);
}

/// Of a floor whose right half has mipmaps: in strips of any height, on any threads, and baked.
TEST_F(Command, SceneWithMipmapsHasItsChecksum) {
  const std::string scene = ZSTRIP_SCENE_FILES "/mipmaps.toml";
  const auto drawn = [&](const std::string& file, const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"render", file, "-o", "p.png", "--size", "160x120", "--quiet", "--json", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    if (outcome.status != 0) return std::string();
    return nlohmann::json::parse(outcome.out).at("frames").at(0).at("crc32").get<std::string>();
  };
  const std::string golden = "858e065e";
  EXPECT_EQ(drawn(scene, {}), golden);
  EXPECT_EQ(drawn(scene, {"--strip-rows", "1"}), golden);
  EXPECT_EQ(drawn(scene, {"--strip-rows", "7", "--strip-columns", "24"}), golden);
  EXPECT_EQ(drawn(scene, {"--threads", "3", "--strip-rows", "5"}), golden);
  EXPECT_EQ(zstrip({"bake", scene, "-o", "p.zsc", "--size", "160x120", "--quiet"}).status, 0);
  EXPECT_EQ(drawn("p.zsc", {}), golden);
  EXPECT_EQ(zstrip({"bake", scene, "-o", "p.zsc", "--size", "160x120", "--mipmaps", "off", "--quiet"}).status, 0);
  EXPECT_NE(drawn("p.zsc", {}), golden);
}

TEST_F(Command, MipmapsOfAMaterialWithoutTextureAreRefused) {
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
    words.insert(words.begin(), {"plan", "room", "--size", "128x64", "--depth-format", "auto", "--json"});
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
  const Outcome nothing = zstrip({"plan", "knot_meshlets", "--ram", "900", "--split-columns"});
  EXPECT_EQ(nothing.status, 5);
  EXPECT_NE(nothing.err.find("the smallest needs 1,112 bytes"), std::string::npos) << nothing.err;
  EXPECT_EQ(zstrip({"plan", "knot_meshlets", "--strip-columns", "12"}).status, 2);
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
    const Outcome outcome = zstrip({"render", (models / model).string(), "-o", "box.png", "--quiet"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    return picture("box.png").rgb;
  };
  const auto outside = render("glTF2/BoxTextured-glTF/BoxTextured.gltf");
  EXPECT_EQ(outside, render("glTF2/BoxTextured-glTF-Binary/BoxTextured.glb"));
  EXPECT_EQ(outside, render("glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf"));
  std::set<std::array<std::uint8_t, 3>> colours;
  for (std::size_t i = 0; i < outside.size(); i += 3) colours.insert({outside[i], outside[i + 1], outside[i + 2]});
  EXPECT_GT(colours.size(), 20U) << "a picture of a texture has many colours";
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
