// The room that plans give to bins, on a figure whose triangles face the camera in other shares from each side and in
// each pose.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "zstrip/renderer.hpp"
#include "zstrip_scenes/character.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::scenes_test {
namespace {

constexpr std::uint32_t kPoses = 20;
constexpr View kFigureView{240, 320, PixelFormat::rgb565};

/// How many frames do not fit into the bins of a plan for so many rows a strip, and are streamed.
template <class Place>
std::uint32_t overflows(std::uint16_t rows, const Place& place) {
  const scenes::BuiltIn& figure = scenes::character;
  const Effects effects = effects_of(figure.scene, figure.camera) | effect::bins;
  const auto [status, plan] =
      zstrip::plan(figure.counts, kFigureView, effects, {.strip_rows = rows, .modes = Modes::binned});
  EXPECT_TRUE(status);
  AnyRenderer renderer(effects);
  std::vector<std::uint64_t> arena(plan.bytes() / sizeof(std::uint64_t) + 1);
  scenes::Staged staged;
  for (std::uint32_t frame = 0; frame < kPoses; ++frame) {
    EXPECT_TRUE(figure.pose(frame));
    place(staged, frame);
    EXPECT_TRUE(renderer.begin_frame(staged.scene, staged.camera, kFigureView, plan,
                                     std::as_writable_bytes(std::span(arena)).first(plan.bytes())));
  }
  return renderer.frame().bin_overflows();
}

/// Regression: bins had room for a half of the triangles, and of this figure 61 % face the camera.
TEST(Bins, HoldAFigureFromEachSideAndInEachPose) {
  for (const std::uint16_t rows : std::array<std::uint16_t, 7>{8, 16, 20, 28, 40, 80, 160}) {
    EXPECT_EQ(overflows(rows, [](auto& staged, auto frame) { stage_workload(scenes::character, staged, frame); }), 0U)
        << "walking, " << rows << " rows";
    EXPECT_EQ(
        overflows(rows, [](auto& staged, auto frame) { stage(scenes::character, staged, frame, kPoses, kFigureView); }),
        0U)
        << "turning, " << rows << " rows";
  }
}

}  // namespace
}  // namespace zstrip::scenes_test
