// The scenes through the renderer: every one draws something, and cutting a mesh into meshlets changes no pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "../oracle/draw.hpp"
#include "zstrip_scenes/scenes.hpp"

namespace zstrip::scenes_test {
namespace {

constexpr View kView{.width = 120, .height = 90};
constexpr std::uint16_t kStripRows = 16;  // the last strip has 10

/// The whole picture; empty, with a failure recorded, if the renderer refuses.
std::vector<std::uint16_t> draw(const scenes::BuiltIn& built_in, const scenes::Staged& staged) {
  const Effects effects = effects_of(staged.scene, staged.camera);
  const PlanResult planned = plan(built_in.counts, kView, effects, {.strip_rows = kStripRows});
  EXPECT_TRUE(planned.status) << built_in.name << ": " << message(planned.status.error);
  AnyRenderer renderer(effects);
  const picture::Picture drawn = picture::draw(renderer, staged.scene, staged.camera, kView, planned.plan);
  EXPECT_TRUE(drawn.status) << built_in.name << ": " << message(drawn.status.error);
  return rgb565_of(drawn);
}

std::vector<std::uint16_t> turntable(const char* name, std::uint32_t frame) {
  const scenes::BuiltIn& built_in = *scenes::find(name);
  scenes::Staged staged;
  stage(built_in, staged, frame, 12, kView);
  return draw(built_in, staged);
}

std::vector<std::uint16_t> workload(const char* name, std::uint32_t frame) {
  const scenes::BuiltIn& built_in = *scenes::find(name);
  scenes::Staged staged;
  stage_workload(built_in, staged, frame);
  return draw(built_in, staged);
}

TEST(Render, EverySceneDrawsSomethingThatMoves) {
  for (const scenes::BuiltIn& built_in : scenes::built_in()) {
    const std::vector<std::uint16_t> at_rest = turntable(built_in.name, 0), turned = turntable(built_in.name, 1);
    const auto drawn = std::count_if(at_rest.begin(), at_rest.end(), [](std::uint16_t pixel) { return pixel != 0; });
    EXPECT_GT(drawn, kView.width * kView.height / 20) << built_in.name;
    EXPECT_NE(at_rest, turned) << built_in.name;
    EXPECT_EQ(at_rest, turntable(built_in.name, 12)) << built_in.name << " does not come around";
  }
}

// From inside there is wall everywhere: no pixel keeps the black background.
TEST(Render, TheRoomFillsThePicture) {
  for (std::uint32_t frame = 0; frame < 12; ++frame) {
    const std::vector<std::uint16_t> picture = turntable("room", frame);
    EXPECT_EQ(std::count(picture.begin(), picture.end(), 0), 0) << "frame " << frame;
  }
}

TEST(Render, MeshletsChangeNoPixel) {
  for (const std::string name : {"teapot", "knot", "random10k"}) {
    const std::string cut = name + "_meshlets";
    for (const std::uint32_t frame : {0U, 3U, 7U}) {
      EXPECT_EQ(turntable(name.c_str(), frame), turntable(cut.c_str(), frame)) << name << " frame " << frame;
      EXPECT_EQ(workload(name.c_str(), frame), workload(cut.c_str(), frame)) << name << " frame " << frame;
    }
  }
}

}  // namespace
}  // namespace zstrip::scenes_test
