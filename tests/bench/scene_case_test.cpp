// zstrip bench of a scene of the user: the board draws the host's pixels, and zstrip fit predicts its frames a second.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/board_bench.hpp"
#include "bench/child_process.hpp"
#include "bench/scene_case.hpp"
#include "render/render_frame.hpp"

namespace zstrip::sim {
namespace {

using nlohmann::json;

const std::string kModels = ZSTRIP_SCENE_FILES "/gallery/";
/// Models with the effects of the program that the build makes for this test.
const std::vector<std::string> kLit{kModels + "astronaut/planet.glb", kModels + "watch/steel.glb"};

class SceneOfUser : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(std::filesystem::path(ZSTRIP_FIRMWARE_BINARIES) / ZSTRIP_PLAYED_PROGRAM ".elf") ||
        !run_program({"qemu-system-arm", "--version"}, std::chrono::seconds{30})) {
      GTEST_SKIP() << "no programs for boards, or no QEMU";
    }
  }
};

BakeArguments bake_of(const std::string& scene) {
  BakeArguments bake;
  bake.scene = scene;
  bake.plan.view = {.size = "96x80", .format = "rgb565_swapped"};
  return bake;
}

TEST_F(SceneOfUser, IsDrawnOnTheBoardAsOnTheHostAndMoves) {
  constexpr std::uint32_t kFrames = 3;
  const BoardModel& board = *find_board("pico");
  const Result<SceneCase> made = scene_case(bake_of(kLit[0]), board, 1, kFrames);
  ASSERT_TRUE(made) << made.failure().message;
  EXPECT_EQ(board_program_of(made->bench_case), ZSTRIP_PLAYED_PROGRAM)
      << "the effects of the build's program are out of date";
  const Result<std::vector<Measurement>> counted = bench_on_board({made->bench_case}, ZSTRIP_FIRMWARE_BINARIES);
  ASSERT_TRUE(counted) << counted.failure().message;
  const View& view = made->bench_case.view;
  const Result<std::unique_ptr<Stage>> stage = open_stage(made->bench_case.scene_file, {}, {}, view, kFrames);
  ASSERT_TRUE(stage);
  FrameRenderer renderer(view, {});
  const std::vector<std::uint32_t>& sums = counted->front().frame_crc32;
  ASSERT_EQ(sums.size(), kFrames);
  EXPECT_NE(sums[0], sums[1]);
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    const Result<Staging> staging = (*stage)->place(frame, kFrames);
    ASSERT_TRUE(staging);
    const Result<FrameReport> drawn = renderer.render(*staging);
    ASSERT_TRUE(drawn);
    EXPECT_EQ(drawn->crc32, sums[frame]) << frame;
  }
}

ChildOutput command(std::vector<std::string> words) {
  words.insert(words.begin(), ZSTRIP_COMMAND);
  const Result<ChildOutput> output = run_program(words, std::chrono::seconds{110});
  EXPECT_TRUE(output) << output.failure().message;
  return output ? *output : ChildOutput{-1, ""};
}

TEST(SceneOfUserFailures, SayWhatIsMissing) {
  const std::string& model = kLit[0];
  const ChildOutput missing = command({"bench", model, "--board", "pico", "--firmware", "/nonexistent"});
  EXPECT_EQ(missing.exit_status, 3);
  EXPECT_NE(missing.text.find("host-sim/run builds it with arm-none-eabi-g++"), std::string::npos) << missing.text;
  EXPECT_EQ(command({"bench", model}).exit_status, 2);
  EXPECT_EQ(command({"bench", model, "--board", "pico", "--workload", "CT"}).exit_status, 2);
  EXPECT_EQ(command({"bench", "--board", "pico", "--texture-size", "64"}).exit_status, 2);
  EXPECT_EQ(command({"bench", "/nonexistent.glb", "--board", "pico"}).exit_status, 4);
}

}  // namespace
}  // namespace zstrip::sim
