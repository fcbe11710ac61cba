// Visible sets of `zstrip bake` and `zstrip render`, as a user makes and takes them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>

#include "command.hpp"

namespace zstrip::test {
namespace {

/// The rooms with a camera whose near plane is nearer.
std::string nearer_rooms() {
  std::string text = read(ROOMS);
  const std::size_t at = text.find("\nnear = ");
  EXPECT_NE(at, std::string::npos);
  text.replace(at, text.find('\n', at + 1) - at, "\nnear = 0.01");
  text.insert(text.find("models/"), std::filesystem::path(ROOMS).parent_path().string() + "/");
  return text;
}

TEST_F(VisibilityCommand, BakesVisibleSetsAndRendersWithThem) {
  const std::string rooms = std::string("'") + ROOMS + "'", sets = path("rooms.zpv");
  const CommandOutcome baked =
      run("bake " + rooms + " -o '" + path("rooms.zsc") + "' --visible-sets '" + sets + "' --cells 6x1x4");
  ASSERT_EQ(baked.status, 0) << baked.text;
  EXPECT_NE(baked.text.find("24 with "), std::string::npos) << baked.text;
  const std::string words = rooms + " --size 96x80 --frames 1 --image raw -o '";
  ASSERT_EQ(render(words + path("all.raw") + "'").status, 0);
  const CommandOutcome fewer = render(words + path("fewer.raw") + "' --json - --visible-sets '" + sets + "'");
  ASSERT_EQ(fewer.status, 0) << fewer.text;
  EXPECT_NE(fewer.text.find("\"outside_cells\": "), std::string::npos) << fewer.text;
  EXPECT_EQ(fewer.text.find("\"outside_cells\": 0,"), std::string::npos) << fewer.text;
  EXPECT_EQ(read(path("all.raw")), read(path("fewer.raw")));
  EXPECT_FALSE(read(path("all.raw")).empty());
  // Another scene, a damaged file, none, no eye, a nearer near plane, no grid.
  const auto refused = [&](const std::string& command, int status, const char* part) {
    const CommandOutcome outcome = run(command);
    EXPECT_EQ(outcome.status, status) << command << outcome.text;
    EXPECT_NE(outcome.text.find(part), std::string::npos) << outcome.text;
  };
  const std::string none = " -o '" + path("none.png") + "' --visible-sets '";
  refused("render cube" + none + sets + "'", 4, "another scene");
  std::ofstream(path("bad.zpv"), std::ios::binary) << read(sets).substr(0, 100);
  refused("render " + rooms + none + path("bad.zpv") + "'", 4, "damaged");
  refused("render " + rooms + none + path("missing") + "'", 4, "--visible-sets");
  refused("render " + rooms + " --ortho" + none + sets + "'", 2, "perspective");
  refused("render '" + file("nearer.toml", nearer_rooms()) + "'" + none + sets + "'", 2, "near plane");
  refused("render " + rooms + " --depth-format z24" + none + sets + "'", 2, "z16 only");
  refused("bake " + rooms + " -o '" + path("none.zsc") + "' --cells 6x4", 2, "--cells");
  refused("bake " + rooms + " -o '" + path("none.zsc") + "' --cells 6x1x4", 2, "--visible-sets, which is not given");
  std::filesystem::copy_file(sets, path("sets.zsc"));
  refused("render '" + path("sets.zsc") + "' -o '" + path("none.png") + "'", 4, "visible sets and no scene");
}

// Of 16 bytes the number of meshlets would be the next.
TEST_F(VisibilityCommand, SetsThatEndBeforeTheirMeshletsAreDamaged) {
  const std::string rooms = std::string("'") + ROOMS + "'", sets = path("rooms.zpv");
  ASSERT_EQ(run("bake " + rooms + " -o '" + path("rooms.zsc") + "' --visible-sets '" + sets + "' --cells 2x1x2").status,
            0);
  const std::string whole = read(sets);
  for (const std::size_t length : std::initializer_list<std::size_t>{0, 3, 15, 16, 17, 20, 55, 60}) {
    std::ofstream(path("part.zpv"), std::ios::binary) << whole.substr(0, length);
    const CommandOutcome refused =
        render(rooms + " -o '" + path("none.png") + "' --visible-sets '" + path("part.zpv") + "'");
    EXPECT_EQ(refused.status, 4) << refused.text;
    EXPECT_NE(refused.text.find("damaged ones: byte " + std::to_string(length)), std::string::npos)
        << length << refused.text;
  }
}

TEST_F(VisibilityCommand, SetsWithBytesBehindThemAreRefused) {
  const std::string rooms = std::string("'") + ROOMS + "'", sets = path("rooms.zpv");
  ASSERT_EQ(run("bake " + rooms + " -o '" + path("rooms.zsc") + "' --visible-sets '" + sets + "' --cells 2x1x2").status,
            0);
  const std::string whole = read(sets);
  for (const std::size_t more : std::initializer_list<std::size_t>{1, 4, 1000}) {
    std::ofstream(path("long.zpv"), std::ios::binary) << whole << std::string(more, '\0');
    const CommandOutcome refused =
        render(rooms + " -o '" + path("none.png") + "' --visible-sets '" + path("long.zpv") + "'");
    EXPECT_EQ(refused.status, 4) << refused.text;
    EXPECT_NE(refused.text.find("does not end with its visible sets, at byte " + std::to_string(whole.size())),
              std::string::npos)
        << more << refused.text;
  }
}

// The planes are the scene's, wherever the camera stands.
TEST_F(VisibilityCommand, AnotherEyeKeepsTheFilesNearPlane) {
  const std::string rooms = std::string("'") + ROOMS + "'", sets = path("rooms.zpv");
  ASSERT_EQ(run("bake " + rooms + " -o '" + path("rooms.zsc") + "' --visible-sets '" + sets + "' --cells 6x1x4").status,
            0);
  const std::string eye = rooms + " --size 96x80 --frames 1 --image raw --eye -5,1.7,2.2 --look-at 0,1,0 -o '";
  ASSERT_EQ(render(eye + path("all.raw") + "'").status, 0);
  const CommandOutcome fewer = render(eye + path("fewer.raw") + "' --visible-sets '" + sets + "'");
  EXPECT_EQ(fewer.status, 0) << fewer.text;
  EXPECT_EQ(read(path("all.raw")), read(path("fewer.raw")));
}

TEST_F(VisibilityCommand, AFileThatCannotBeReadToItsEndIsAnError) {
  const CommandOutcome refused =
      render(std::string("cube -o '") + path("none.png") + "' --visible-sets /proc/self/mem");
  EXPECT_EQ(refused.status, 4) << refused.text;
  EXPECT_NE(refused.text.find("cannot be read to its end"), std::string::npos) << refused.text;
}

/// The sets name meshlets of the scene, and a scene that was split has others: half of it was left out.
TEST_F(VisibilityCommand, SetsDoNotGoWithMethodsThatSplitTheScene) {
  for (const char* method : {"painter-newell", "painter-bsp"}) {
    const CommandOutcome refused = render("knot --visible-sets '" + path("none.zpv") + "' --visibility " + method);
    EXPECT_EQ(refused.status, 2) << refused.text;
    EXPECT_NE(refused.text.find(std::string("which --visibility ") + method + " splits"), std::string::npos)
        << refused.text;
  }
}

TEST_F(VisibilityCommand, SetsAreNeverWrittenOverTheSceneOrAnotherOutput) {
  const std::string model = path("model.obj"), scene = path("scene.zsc"), report = path("report.json");
  std::filesystem::copy_file(std::string(MODELS) + "/cycle.obj", model);
  const std::string before = read(model);
  const std::string words = "bake '" + model + "' -o '" + scene + "' --json '" + report + "' --visible-sets '";
  for (const std::string& sets : {model, scene, report}) {
    const CommandOutcome refused = run(words + sets + "'");
    EXPECT_EQ(refused.status, 2) << refused.text;
    EXPECT_NE(refused.text.find("--visible-sets"), std::string::npos) << refused.text;
  }
  EXPECT_EQ(read(model), before);
  EXPECT_FALSE(std::filesystem::exists(scene));
  const std::string rooms = std::string("'") + ROOMS + "'", sets = path("sets.png");
  ASSERT_EQ(run("bake " + rooms + " -o '" + scene + "' --visible-sets '" + sets + "' --cells 1x1x1").status, 0);
  const std::string baked = read(sets);
  const CommandOutcome over = render(rooms + " -o '" + sets + "' --visible-sets '" + sets + "'");
  EXPECT_EQ(over.status, 2) << over.text;
  EXPECT_EQ(read(sets), baked);
}

}  // namespace
}  // namespace zstrip::test
