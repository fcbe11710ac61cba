// `zstrip render --visibility` and `--show`, as a user runs them.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace {

struct Outcome {
  int status;
  std::string text;
};

class VisibilityCommand : public ::testing::Test {
 protected:
  VisibilityCommand() : folder_(std::filesystem::temp_directory_path() / ("zstrip_visibility_" + unique())) {
    std::filesystem::create_directories(folder_);
  }
  ~VisibilityCommand() override { std::filesystem::remove_all(folder_); }

  std::string picture(const std::string& name) const { return (folder_ / name).string(); }
  Outcome render(const std::string& words) const { return run("render " + words); }
  static Outcome run(const std::string& words) {
    const std::string command = std::string("'") + ZSTRIP_COMMAND + "' " + words + " 2>&1";
    std::FILE* const pipe = popen(command.c_str(), "r");
    std::string text;
    for (char buffer[512]; std::fgets(buffer, sizeof buffer, pipe) != nullptr;) text += buffer;
    const int status = pclose(pipe);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text};
  }
  static std::string bytes(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream content;
    content << stream.rdbuf();
    return content.str();
  }

  /// The rooms with a camera whose near plane is nearer.
  std::string nearer_rooms() const {
    std::string text = bytes(ROOMS);
    const std::size_t at = text.find("\nnear = ");
    EXPECT_NE(at, std::string::npos);
    text.replace(at, text.find('\n', at + 1) - at, "\nnear = 0.01");
    const std::size_t model = text.find("models/");
    text.insert(model, std::filesystem::path(ROOMS).parent_path().string() + "/");
    const std::string file = picture("nearer.toml");
    std::ofstream(file) << text;
    return file;
  }

 private:
  static std::string unique() {
    return std::to_string(getpid()) + ::testing::UnitTest::GetInstance()->current_test_info()->name();
  }
  std::filesystem::path folder_;
};

TEST_F(VisibilityCommand, ThePainterIsWrongAndTheZBufferIsNot) {
  for (const char* model : {"thesis.obj", "cycle.obj", "crossing.obj"}) {
    const std::string words = std::string("'") + MODELS + "/" + model + "' --size 96x96 --ortho --show error -o '";
    const Outcome painter = render(words + picture("painter.png") + "' --visibility painter --sort-key nearest");
    EXPECT_EQ(painter.status, 0) << painter.text;
    EXPECT_EQ(painter.text.find("wrong      0 pixels"), std::string::npos) << painter.text;
    for (const char* method : {"zbuffer", "front-to-back", "hierarchical-z", "painter-newell", "painter-bsp"}) {
      const Outcome right = render(words + picture("right.png") + "' --visibility " + method);
      EXPECT_EQ(right.status, 0) << right.text;
      EXPECT_NE(right.text.find("wrong      0 pixels"), std::string::npos) << method << ": " << right.text;
    }
    EXPECT_NE(bytes(picture("painter.png")), bytes(picture("right.png")));
  }
}

TEST_F(VisibilityCommand, HierarchicalZWritesTheSameFile) {
  ASSERT_EQ(render("teapot --size 96x80 --image raw -o '" + picture("a.raw") + "'").status, 0);
  const Outcome other =
      render("teapot --size 96x80 --image raw --visibility hierarchical-z -o '" + picture("b.raw") + "'");
  EXPECT_NE(other.text.find("bounds of depth"), std::string::npos) << other.text;
  EXPECT_EQ(bytes(picture("a.raw")), bytes(picture("b.raw")));
  EXPECT_FALSE(bytes(picture("a.raw")).empty());
}

TEST_F(VisibilityCommand, ShowsWhatItIsAskedFor) {
  std::string last;
  for (const char* show : {"depth", "overdraw", "tiles", "error", "accuracy"}) {
    const std::string file = picture(std::string(show) + ".png");
    const Outcome shown =
        render(std::string("random50 --size 96x80 --visibility hierarchical-z --show ") + show + " -o '" + file + "'");
    EXPECT_EQ(shown.status, 0) << shown.text;
    EXPECT_NE(bytes(file), last);
    last = bytes(file);
    EXPECT_FALSE(last.empty());
  }
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
    const std::string file = picture("shown.raw");
    const Outcome shown = render(std::string("random50 --size 96x80 --image raw --visibility hierarchical-z ") + show +
                                 "--json - -o '" + file + "'");
    EXPECT_EQ(shown.status, 0) << shown.text;
    EXPECT_NE(shown.text.find("\"crc32\": \"" + crc32_words(bytes(file)) + "\""), std::string::npos)
        << show << shown.text;
  }
}

TEST_F(VisibilityCommand, TransparencyGoesWithWhatCanAndIsRefusedByNameElsewhere) {
  const std::string words = "blend --size 96x80 --image raw -o '";
  ASSERT_EQ(render(words + picture("plain.raw") + "'").status, 0);
  for (const char* method : {"front-to-back", "hierarchical-z", "half-range"}) {
    const Outcome drawn = render(words + picture("other.raw") + "' --visibility " + method);
    EXPECT_EQ(drawn.status, 0) << drawn.text;
    EXPECT_EQ(bytes(picture("plain.raw")), bytes(picture("other.raw"))) << method;
  }
  const Outcome refused = render(words + picture("none.raw") + "' --visibility painter-bsp");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.text.find("--visibility painter-bsp cannot draw what this scene has: blending"), std::string::npos)
      << refused.text;
}

/// Of the report of `zstrip render --show accuracy`.
double accuracy_of(const std::string& text, const std::string& key) {
  const std::size_t at = text.find("\"" + key + "\": ", text.find("\"accuracy\""));
  return at == std::string::npos ? -1 : std::stod(text.substr(at + key.size() + 4));
}

TEST_F(VisibilityCommand, TheHeatMapKnowsWhatMakesThePictureMoreLikeTheTruth) {
  const auto report = [this](const std::string& words) {
    const Outcome shown = render(words + " --show accuracy --json - --quiet -o '" + picture("heat.png") + "'");
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
  const std::string cycle = std::string("'") + MODELS + "/cycle.obj' --size 96x96 --ortho --visibility ";
  const std::string painter = report(cycle + "painter"), right = report(cycle + "zbuffer");
  EXPECT_GT(accuracy_of(painter, "mean"), 1.5 * accuracy_of(right, "mean"));
  EXPECT_GT(accuracy_of(painter, "worst"), 2 * accuracy_of(right, "worst"));
  const Outcome refused =
      render(std::string("'") + ZSTRIP_SCENE_FILES + "/point.toml' --show accuracy -o '" + picture("none.png") + "'");
  EXPECT_EQ(refused.status, 4) << refused.text;
  EXPECT_NE(refused.text.find("no truth can be drawn of what this scene has: punctual_lights (point.toml line"),
            std::string::npos)
      << refused.text;
}

TEST_F(VisibilityCommand, ASceneFileNamesTheMethodAndTheOptionCountsMore) {
  const auto scene = [this](const std::string& method) {
    std::ofstream(picture("cycle.toml")) << "[picture]\nsize = [96, 96]\nvisibility = \"" << method
                                         << "\"\n[camera]\nr = 9\nprojection = \"orthographic\"\n[[model]]\nname "
                                            "= \"bars\"\nfile = \""
                                         << MODELS << "/cycle.obj\"\n[[instance]]\nmodel = \"bars\"\n";
    return std::string("'") + picture("cycle.toml") + "' --frames 1 -o '";
  };
  const Outcome painter = render(scene("painter") + picture("painter.png") + "' --sort-key nearest");
  EXPECT_EQ(painter.status, 0) << painter.text;
  EXPECT_NE(painter.text.find("painter: 0 comparisons"), std::string::npos) << painter.text;
  const Outcome plain = render(scene("painter") + picture("plain.png") + "' --visibility zbuffer");
  EXPECT_EQ(plain.status, 0) << plain.text;
  EXPECT_NE(bytes(picture("painter.png")), bytes(picture("plain.png")));
  const Outcome refused = render(scene("best") + picture("none.png") + "'");
  EXPECT_EQ(refused.status, 4) << refused.text;
  EXPECT_NE(refused.text.find("'visibility' names no method 'best'; there are zbuffer, painter"), std::string::npos)
      << refused.text;
}

TEST_F(VisibilityCommand, BakesVisibleSetsAndRendersWithThem) {
  const std::string rooms = std::string("'") + ROOMS + "'", sets = picture("rooms.zpv");
  const Outcome baked =
      run("bake " + rooms + " -o '" + picture("rooms.zsc") + "' --visible-sets '" + sets + "' --cells 6x1x4");
  ASSERT_EQ(baked.status, 0) << baked.text;
  EXPECT_NE(baked.text.find("24 with "), std::string::npos) << baked.text;
  const std::string words = rooms + " --size 96x80 --frames 1 --image raw -o '";
  ASSERT_EQ(render(words + picture("all.raw") + "'").status, 0);
  const Outcome fewer = render(words + picture("fewer.raw") + "' --json - --visible-sets '" + sets + "'");
  ASSERT_EQ(fewer.status, 0) << fewer.text;
  EXPECT_NE(fewer.text.find("\"outside_cells\": "), std::string::npos) << fewer.text;
  EXPECT_EQ(fewer.text.find("\"outside_cells\": 0,"), std::string::npos) << fewer.text;
  EXPECT_EQ(bytes(picture("all.raw")), bytes(picture("fewer.raw")));
  EXPECT_FALSE(bytes(picture("all.raw")).empty());
  // Another scene, a damaged file, none, no eye, a nearer near plane, no grid.
  const auto refused = [&](const std::string& command, int status, const char* part) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, status) << command << outcome.text;
    EXPECT_NE(outcome.text.find(part), std::string::npos) << outcome.text;
  };
  const std::string none = " -o '" + picture("none.png") + "' --visible-sets '";
  refused("render cube" + none + sets + "'", 4, "another scene");
  std::ofstream(picture("bad.zpv"), std::ios::binary) << bytes(sets).substr(0, 100);
  refused("render " + rooms + none + picture("bad.zpv") + "'", 4, "damaged");
  refused("render " + rooms + none + picture("missing") + "'", 4, "--visible-sets");
  refused("render " + rooms + " --ortho" + none + sets + "'", 2, "perspective");
  refused("render '" + nearer_rooms() + "'" + none + sets + "'", 2, "near plane");
  refused("render " + rooms + " --depth-format z24" + none + sets + "'", 2, "z16 only");
  refused("bake " + rooms + " -o '" + picture("none.zsc") + "' --cells 6x4", 2, "--cells");
  refused("bake " + rooms + " -o '" + picture("none.zsc") + "' --cells 6x1x4", 2, "--visible-sets, which is not given");
  std::filesystem::copy_file(sets, picture("sets.zsc"));
  refused("render '" + picture("sets.zsc") + "' -o '" + picture("none.png") + "'", 4, "visible sets and no scene");
}

// Of 16 bytes the number of meshlets would be the next.
TEST_F(VisibilityCommand, SetsThatEndBeforeTheirMeshletsAreDamaged) {
  const std::string rooms = std::string("'") + ROOMS + "'", sets = picture("rooms.zpv");
  ASSERT_EQ(
      run("bake " + rooms + " -o '" + picture("rooms.zsc") + "' --visible-sets '" + sets + "' --cells 2x1x2").status,
      0);
  const std::string whole = bytes(sets);
  for (const std::size_t length : std::initializer_list<std::size_t>{0, 3, 15, 16, 17, 20, 55, 60}) {
    std::ofstream(picture("part.zpv"), std::ios::binary) << whole.substr(0, length);
    const Outcome refused =
        render(rooms + " -o '" + picture("none.png") + "' --visible-sets '" + picture("part.zpv") + "'");
    EXPECT_EQ(refused.status, 4) << refused.text;
    EXPECT_NE(refused.text.find("damaged ones: byte " + std::to_string(length)), std::string::npos)
        << length << refused.text;
  }
}

TEST_F(VisibilityCommand, SetsWithBytesBehindThemAreRefused) {
  const std::string rooms = std::string("'") + ROOMS + "'", sets = picture("rooms.zpv");
  ASSERT_EQ(
      run("bake " + rooms + " -o '" + picture("rooms.zsc") + "' --visible-sets '" + sets + "' --cells 2x1x2").status,
      0);
  const std::string whole = bytes(sets);
  for (const std::size_t more : std::initializer_list<std::size_t>{1, 4, 1000}) {
    std::ofstream(picture("long.zpv"), std::ios::binary) << whole << std::string(more, '\0');
    const Outcome refused =
        render(rooms + " -o '" + picture("none.png") + "' --visible-sets '" + picture("long.zpv") + "'");
    EXPECT_EQ(refused.status, 4) << refused.text;
    EXPECT_NE(refused.text.find("does not end with its visible sets, at byte " + std::to_string(whole.size())),
              std::string::npos)
        << more << refused.text;
  }
}

// The planes are the scene's, wherever the camera stands.
TEST_F(VisibilityCommand, AnotherEyeKeepsTheFilesNearPlane) {
  const std::string rooms = std::string("'") + ROOMS + "'", sets = picture("rooms.zpv");
  ASSERT_EQ(
      run("bake " + rooms + " -o '" + picture("rooms.zsc") + "' --visible-sets '" + sets + "' --cells 6x1x4").status,
      0);
  const std::string eye = rooms + " --size 96x80 --frames 1 --image raw --eye -5,1.7,2.2 --look-at 0,1,0 -o '";
  ASSERT_EQ(render(eye + picture("all.raw") + "'").status, 0);
  const Outcome fewer = render(eye + picture("fewer.raw") + "' --visible-sets '" + sets + "'");
  EXPECT_EQ(fewer.status, 0) << fewer.text;
  EXPECT_EQ(bytes(picture("all.raw")), bytes(picture("fewer.raw")));
}

TEST_F(VisibilityCommand, ATreeIsBakedAndDrawnInPlace) {
  for (const char* scene : {"knot_meshlets", "random50", "cycle"}) {
    const std::string name = std::string(scene) == "cycle" ? std::string("'") + MODELS + "/cycle.obj'" : scene;
    const std::string baked = picture("baked.zsc"), words = " --size 160x120 --image raw --visibility painter-bsp";
    const Outcome made = run("bake " + name + " -o '" + baked + "' --size 160x120 --visibility painter-bsp");
    ASSERT_EQ(made.status, 0) << made.text;
    EXPECT_NE(made.text.find("tree of painter-bsp: "), std::string::npos) << made.text;
    EXPECT_NE(made.text.find("visibility painter-bsp: "), std::string::npos) << made.text;
    EXPECT_NE(made.text.find("of z-buffer saved"), std::string::npos) << made.text;
    const Outcome drawn = render("'" + baked + "'" + words + " -o '" + picture("baked.raw") + "'");
    ASSERT_EQ(drawn.status, 0) << drawn.text;
    ASSERT_EQ(render(name + words + " -o '" + picture("made.raw") + "'").status, 0);
    EXPECT_EQ(bytes(picture("baked.raw")), bytes(picture("made.raw"))) << scene;
    EXPECT_EQ(bytes(picture("baked.raw")).size(), 160U * 120 * 2);
    // In strips, and with the judge.
    ASSERT_EQ(render("'" + baked + "'" + words + " --strip-rows 9 -o '" + picture("strips.raw") + "'").status, 0);
    EXPECT_EQ(bytes(picture("baked.raw")), bytes(picture("strips.raw"))) << scene;
    const Outcome judged = render("'" + baked + "' --size 160x120 --visibility painter-bsp --show error -o '" +
                                  picture("error.png") + "'");
    EXPECT_EQ(judged.status, 0) << judged.text;
    // Without the option it is a scene like others.
    EXPECT_EQ(render("'" + baked + "' --size 160x120 -o '" + picture("plain.png") + "'").status, 0);
  }
}

/// They were all called sorting, and most were bounds.
TEST_F(VisibilityCommand, BytesOfTwoKindsHaveBothNames) {
  const std::string words = "random50 --size 96x80 --strip-rows 80 --visibility front-to-back-hierarchical-z -o '";
  for (const Outcome& told : {render(words + picture("a.png") + "'"), run("bake " + words + picture("a.zsc") + "'")}) {
    EXPECT_EQ(told.status, 0) << told.text;
    EXPECT_NE(told.text.find(", sorting and bounds of depth 1,608)"), std::string::npos) << told.text;
  }
}

TEST_F(VisibilityCommand, PlanAndBakeKnowTheMethodsBytes) {
  const auto says = [this](const std::string& command, const char* part) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 0) << command << outcome.text;
    EXPECT_NE(outcome.text.find(part), std::string::npos) << outcome.text;
  };
  says("plan random50 --size 96x80 --strip-rows 80 --visibility painter",
       "painter: 800 bytes for sorting, 15,360 bytes of z-buffer saved");
  says("plan random50 --size 96x80 --strip-rows 80 --visibility painter --json", "\"visibility\": 800");
  says("plan random50 --size 96x80 --strip-rows 80 --visibility hierarchical-z",
       "hierarchical-z: 808 bytes for bounds of depth");
  says("plan random50 --size 96x80 --visibility midpoint", "midpoint: no memory of its own");
  says("plan random50 --size 96x80 --visibility painter-bsp", "painter-bsp: ");
  says("bake random50 --size 96x80 --strip-rows 80 -o '" + picture("a.zsc") + "' --visibility front-to-back",
       "front-to-back: 800 bytes for sorting");
  says("bake random50 --size 96x80 --strip-rows 80 -o '" + picture("a.hpp") + "' --visibility front-to-back --json -",
       "\"visibility\": 800");
  EXPECT_NE(bytes(picture("a.hpp")).find("zstrip::method::front_to_back"), std::string::npos);
  for (const char* words :
       {"plan room --visibility painter-bsp", "plan blend --visibility painter-newell", "plan room --visibility best",
        "plan room --visibility hierarchical-z --static-layer", "plan room --visibility painter --depth-format z24",
        "bake rooms.toml -o none.zsc --visibility best"}) {
    const Outcome refused = run(words);
    EXPECT_EQ(refused.status, 2) << words << refused.text;
    EXPECT_NE(refused.text.find("--visibility"), std::string::npos) << refused.text;
  }
  const Outcome moving =
      run(std::string("bake '") + ROOMS + "' -o '" + picture("none.zsc") + "' --visibility painter-bsp");
  EXPECT_EQ(moving.status, 2) << moving.text;
  EXPECT_NE(moving.text.find("stand still"), std::string::npos) << moving.text;
}

TEST_F(VisibilityCommand, BillboardsHaveNoOrderOfTheirOwn) {
  const std::string scene = picture("billboards.toml");
  std::ofstream(scene) << "[[model]]\nname = 'a'\nbuilt_in = 'knot'\n[[instance]]\nmodel = 'a'\nlayer = 'static'\n"
                          "billboard = 'viewer'\n";
  for (const char* method : {"painter-bsp", "painter-newell"}) {
    const Outcome refused = run("render '" + scene + "' -o '" + picture("none.png") + "' --visibility " + method);
    EXPECT_EQ(refused.status, 2) << refused.text;
    EXPECT_NE(refused.text.find("billboards cannot be split: they turn with the camera"), std::string::npos)
        << refused.text;
  }
  // The judge of wrong pixels turns them by itself.
  const Outcome drawn = run("render '" + scene + "' --size 64x48 --show error -o '" + picture("error.png") + "'");
  EXPECT_EQ(drawn.status, 0) << drawn.text;
  EXPECT_NE(drawn.text.find("wrong      0 pixels"), std::string::npos) << drawn.text;
}

/// The order was of one camera, but the header said how to move the scene.
TEST_F(VisibilityCommand, NewellsOrderIsBakedForOneCameraOnly) {
  const std::string header = picture("order.hpp");
  const Outcome turned = run("bake knot_meshlets --turntable --visibility painter-newell -o '" + header + "'");
  EXPECT_EQ(turned.status, 2) << turned.text;
  EXPECT_NE(turned.text.find("leave out --turntable"), std::string::npos) << turned.text;
  EXPECT_FALSE(std::filesystem::exists(header));
  const auto says = [&](const std::string& method, const char* part) {
    const Outcome baked = run("bake random50 -o '" + header + "' --visibility " + method);
    EXPECT_EQ(baked.status, 0) << baked.text;
    return bytes(header).find(part) != std::string::npos;
  };
  EXPECT_TRUE(says("painter-newell", "for this camera only"));
  EXPECT_FALSE(says("painter-newell", "To move the scene"));
  EXPECT_FALSE(says("painter-bsp", "for this camera only"));
  EXPECT_TRUE(says("painter-bsp", "To move the scene"));
}

/// It named itself twice, and advised painter-bsp, which may refuse the model as well.
TEST_F(VisibilityCommand, NewellGivesUpInOneSentence) {
  const std::string model = picture("floor.obj");
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
  const Outcome refused = render("'" + model + "' --visibility painter-newell -o '" + picture("none.png") + "'");
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.text,
            "zstrip: --visibility painter-newell: to order the triangles takes more than 20,000 pieces or 50 million "
            "comparisons; choose another method\n");
}

TEST_F(VisibilityCommand, MessagesNameTheMethodAndTheOptionThatWereGiven) {
  const auto refused = [this](const std::string& words, const char* part) {
    const Outcome outcome = render(words + " -o '" + picture("none.png") + "'");
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
                            picture("counts.json") + "' -o '";
  ASSERT_EQ(render(words + picture("plain") + "'").status, 0);
  EXPECT_EQ(bytes(picture("counts.json")).find("\"drawn_first\": 1"), std::string::npos);
  ASSERT_EQ(render(words + picture("coherent") + "' --cull back-faces,small,temporal").status, 0);
  for (int frame = 0; frame < 6; ++frame) {
    const std::string name = "/frame_000" + std::to_string(frame) + ".raw";
    EXPECT_EQ(bytes(picture("plain") + name), bytes(picture("coherent") + name)) << frame;
    EXPECT_EQ(bytes(picture("plain") + name).size(), 96U * 80 * 2);
  }
  const std::string counts = bytes(picture("counts.json"));
  const std::size_t first = counts.find("\"drawn_first\": "), second = counts.find("\"drawn_first\": ", first + 1);
  EXPECT_EQ(counts.substr(first, 17), "\"drawn_first\": 0,") << "nothing is known yet";
  ASSERT_NE(second, std::string::npos);
  EXPECT_NE(counts.substr(second, 17), "\"drawn_first\": 0,");
}

TEST_F(VisibilityCommand, ASceneFileHasTheOptionsToo) {
  const auto scene = [this](const std::string& lines) {
    std::ofstream(picture("knot.toml")) << "[picture]\nsize = [96, 80]\n"
                                        << lines
                                        << "[camera]\nr = 3\n[[model]]\nname = 'knot'\nbuilt_in = 'knot_meshlets'\n"
                                           "[[instance]]\nmodel = 'knot'\n";
    return std::string("'") + picture("knot.toml") + "' --frames 1 --image raw --json - -o '" + picture("a.raw") + "'";
  };
  const Outcome split = render(scene("visibility = 'midpoint'\niterations = 0\n"));
  EXPECT_NE(split.text.find("\"splits\": 0,"), std::string::npos) << split.text;
  const Outcome deeper = render(scene("visibility = 'midpoint'\niterations = 0\n") + " --iterations 3");
  EXPECT_EQ(deeper.text.find("\"splits\": 0,"), std::string::npos) << deeper.text;
  const Outcome usual = render(scene("visibility = 'hierarchical-z'\n"));
  EXPECT_EQ(usual.text.find("\"back_faces\": 0,"), std::string::npos) << usual.text;
  const Outcome none = render(scene("visibility = 'hierarchical-z'\ncull = ['none']\n"));
  EXPECT_NE(none.text.find("\"back_faces\": 0,"), std::string::npos) << none.text;
  const Outcome wide = render(scene("visibility = 'painter'\ndepth_format = 'z24'\n"));
  EXPECT_EQ(wide.status, 2) << wide.text;
  EXPECT_NE(wide.text.find("leave out 'depth_format' in the scene file"), std::string::npos) << wide.text;
  const Outcome temporal = render(scene("cull = ['temporal']\n"));
  EXPECT_EQ(temporal.status, 4) << temporal.text;
  EXPECT_NE(temporal.text.find("knot.toml' line 3: [picture]: 'cull' with temporal needs"), std::string::npos)
      << temporal.text;
  const Outcome other = render(scene("visibility = 'hierarchical-z'\ncull = ['temporal']\n") + " --visibility zbuffer");
  EXPECT_EQ(other.status, 2) << other.text;
  EXPECT_NE(other.text.find("the scene file's 'cull' with temporal needs"), std::string::npos) << other.text;
  const Outcome sets = render(scene("visible_sets = 'none.zpv'\n"));
  EXPECT_EQ(sets.status, 4) << sets.text;
  EXPECT_NE(sets.text.find(picture("none.zpv")), std::string::npos) << sets.text;
}

TEST_F(VisibilityCommand, AFileThatCannotBeReadToItsEndIsAnError) {
  const Outcome refused = render(std::string("cube -o '") + picture("none.png") + "' --visible-sets /proc/self/mem");
  EXPECT_EQ(refused.status, 4) << refused.text;
  EXPECT_NE(refused.text.find("cannot be read to its end"), std::string::npos) << refused.text;
}

TEST_F(VisibilityCommand, WhatCannotBeIsAUsageError) {
  for (const char* words :
       {"teapot --visibility best", "teapot --visibility painter --show depth", "teapot --show tiles",
        "teapot --show what", "teapot --iterations 7", "teapot --visibility painter --depth-format float",
        "teapot --cull none,small", "cube --visibility painter-bsp", "teapot --show depth --format mono",
        "teapot --show accuracy --panel st7789"}) {
    const Outcome refused = render(std::string(words) + " -o '" + picture("none.png") + "'");
    EXPECT_EQ(refused.status, 2) << words << ": " << refused.text;
    EXPECT_FALSE(std::filesystem::exists(picture("none.png"))) << words;
  }
}

TEST_F(VisibilityCommand, ShadowsGoWithDepthThatTheyCanRead) {
  const std::string scene = ZSTRIP_SCENE_FILES "/shadows.toml";
  for (const auto& [words, named] : {std::pair{"--depth-format w16", "--depth-format"},
                                     std::pair{"--visibility half-range", "--visibility half-range"}}) {
    const Outcome refused = render("'" + scene + "' " + words + " -o '" + picture("none.png") + "'");
    EXPECT_EQ(refused.status, 2) << refused.text;
    EXPECT_NE(refused.text.find(std::string("'shadows' does not go with ") + named +
                                ": a shadow is found by what a depth code stands for"),
              std::string::npos)
        << refused.text;
  }
}

/// The sets name meshlets of the scene, and a scene that was split has others: half of it was left out.
TEST_F(VisibilityCommand, SetsDoNotGoWithMethodsThatSplitTheScene) {
  for (const char* method : {"painter-newell", "painter-bsp"}) {
    const Outcome refused = render("knot --visible-sets '" + picture("none.zpv") + "' --visibility " + method);
    EXPECT_EQ(refused.status, 2) << refused.text;
    EXPECT_NE(refused.text.find(std::string("which --visibility ") + method + " splits"), std::string::npos)
        << refused.text;
  }
}

TEST_F(VisibilityCommand, SetsAreNeverWrittenOverTheSceneOrAnotherOutput) {
  const std::string model = picture("model.obj"), scene = picture("scene.zsc"), report = picture("report.json");
  std::filesystem::copy_file(std::string(MODELS) + "/cycle.obj", model);
  const std::string before = bytes(model);
  const std::string words = "bake '" + model + "' -o '" + scene + "' --json '" + report + "' --visible-sets '";
  for (const std::string& sets : {model, scene, report}) {
    const Outcome refused = run(words + sets + "'");
    EXPECT_EQ(refused.status, 2) << refused.text;
    EXPECT_NE(refused.text.find("--visible-sets"), std::string::npos) << refused.text;
  }
  EXPECT_EQ(bytes(model), before);
  EXPECT_FALSE(std::filesystem::exists(scene));
  const Outcome over = render("cube -o '" + picture("sets.png") + "' --visible-sets '" + picture("sets.png") + "'");
  EXPECT_EQ(over.status, 2) << over.text;
}

TEST_F(VisibilityCommand, ErrorsAreNotJudgedWhereTheJudgeDoesNotKnowTheScene) {
  for (const char* scene : {"spheres", "mask", "blend"}) {
    const Outcome refused = render(std::string(scene) + " --show error -o '" + picture("none.png") + "'");
    EXPECT_EQ(refused.status, 2) << refused.text;
    EXPECT_NE(refused.text.find("--show error judges opaque triangles"), std::string::npos) << refused.text;
  }
}

}  // namespace
