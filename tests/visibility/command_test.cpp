// `zstrip render --visibility` and `--show`, as a user runs them.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

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
  for (const char* show : {"depth", "overdraw", "tiles", "error"}) {
    const std::string file = picture(std::string(show) + ".png");
    const Outcome shown =
        render(std::string("random50 --size 96x80 --visibility hierarchical-z --show ") + show + " -o '" + file + "'");
    EXPECT_EQ(shown.status, 0) << shown.text;
    EXPECT_NE(bytes(file), last);
    last = bytes(file);
    EXPECT_FALSE(last.empty());
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

TEST_F(VisibilityCommand, ASceneFileNamesTheMethodAndTheOptionCountsMore) {
  const auto scene = [this](const std::string& method) {
    std::ofstream(picture("cycle.toml")) << "[picture]\nsize = [96, 96]\nvisibility = \"" << method
                                         << "\"\n[camera]\nr = 9\nprojection = \"orthographic\"\n[[model]]\nname "
                                            "= \"bars\"\nfile = \""
                                         << MODELS << "/cycle.obj\"\n[[instance]]\nmodel = \"bars\"\n";
    return std::string("'") + picture("cycle.toml") + "' --frames 1 --sort-key nearest -o '";
  };
  const Outcome painter = render(scene("painter") + picture("painter.png") + "'");
  EXPECT_EQ(painter.status, 0) << painter.text;
  EXPECT_NE(painter.text.find("painter: 0 comparisons"), std::string::npos) << painter.text;
  const Outcome plain = render(scene("painter") + picture("plain.png") + "' --visibility zbuffer");
  EXPECT_EQ(plain.status, 0) << plain.text;
  EXPECT_NE(bytes(picture("painter.png")), bytes(picture("plain.png")));
  const Outcome refused = render(scene("best") + picture("none.png") + "'");
  EXPECT_EQ(refused.status, 4) << refused.text;
  EXPECT_NE(refused.text.find("'visibility' is not one of: zbuffer, painter"), std::string::npos) << refused.text;
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
  refused("render " + rooms + " --eye -5,1.7,2.2 --look-at 0,1,0" + none + sets + "'", 2, "near plane");
  refused("render " + rooms + " --depth-format z24" + none + sets + "'", 2, "z16 only");
  refused("bake " + rooms + " -o '" + picture("none.zsc") + "' --cells 6x4", 2, "--cells");
}

TEST_F(VisibilityCommand, WhatCannotBeIsAUsageError) {
  for (const char* words :
       {"teapot --visibility best", "teapot --visibility painter --show depth", "teapot --show tiles",
        "teapot --show what", "teapot --iterations 7", "teapot --visibility painter --depth-format float",
        "teapot --cull none,small", "cube --visibility painter-bsp", "teapot --show depth --format mono"}) {
    const Outcome refused = render(std::string(words) + " -o '" + picture("none.png") + "'");
    EXPECT_EQ(refused.status, 2) << words << ": " << refused.text;
    EXPECT_FALSE(std::filesystem::exists(picture("none.png"))) << words;
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
