// zstrip bench of a scene of the user: the board draws the host's pixels, and zstrip fit predicts its frames a second.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/board_bench.hpp"
#include "bench/child_process.hpp"
#include "bench/scene_case.hpp"
#include "image/rgb_png.hpp"
#include "own_folder.hpp"
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

/// A wavy ground with texture coordinates, and a material of these lines.
std::string ground(const std::filesystem::path& folder, const std::string& name, const std::string& material) {
  constexpr int kSide = 16;
  std::string text = "mtllib " + name + ".mtl\nusemtl a\n";
  for (int j = 0; j <= kSide; ++j) {
    for (int i = 0; i <= kSide; ++i) {
      const double u = i / double{kSide}, v = j / double{kSide};
      text +=
          fmt::format("v {} {} {}\nvt {} {}\n", 4 * u - 2, 0.3 * std::sin(7 * u) * std::cos(5 * v), 4 * v - 2, u, v);
    }
  }
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const int a = j * (kSide + 1) + i + 1, b = a + 1, c = a + kSide + 1, d = c + 1;
      text += fmt::format("f {0}/{0} {2}/{2} {1}/{1}\nf {1}/{1} {2}/{2} {3}/{3}\n", a, b, c, d);
    }
  }
  std::ofstream(folder / (name + ".mtl")) << "newmtl a\n" << material << "\n";
  std::ofstream(folder / (name + ".obj")) << text;
  return (folder / (name + ".obj")).string();
}

void picture(const std::filesystem::path& file, std::uint32_t side,
             const std::function<std::array<std::uint8_t, 3>(std::uint32_t, std::uint32_t)>& colour) {
  RgbImage image{side, side, {}};
  for (std::uint32_t y = 0; y < side; ++y) {
    for (std::uint32_t x = 0; x < side; ++x) {
      const auto rgb = colour(x, y);
      image.rgb.insert(image.rgb.end(), rgb.begin(), rgb.end());
    }
  }
  const Result<std::vector<std::uint8_t>> png = encode_rgb_png(image);
  ASSERT_TRUE(png);
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(png->data()), std::ssize(*png));
}

/// Two models in each run; with ZSTRIP_LONG models of all kinds, whose programs host-sim/run builds.
TEST_F(SceneOfUser, FramesASecondOfFitAreThoseThatBenchCounts) {
  const bool all = std::getenv("ZSTRIP_LONG") != nullptr;
  const test::OwnFolder own;
  const std::filesystem::path& folder = own.path();
  std::vector<std::string> models = kLit;
  if (all) {
    for (const char* name : {"fox/fox", "fox/island", "train/train", "train/land", "watch/dial", "watch/strap",
                             "home/things", "home/robot", "lighthouse/land", "lighthouse/sea", "astronaut/suit",
                             "chess/queen", "chess/knight", "robot/head"}) {
      models.push_back(std::string(ZSTRIP_SCENE_FILES "/gallery/") + name + ".glb");
    }
    models.insert(models.end(), {ZSTRIP_SCENE_FILES "/models/ball.obj", ZSTRIP_SCENE_FILES "/models/ring.obj"});
    for (const char* name :
         {"bake/models/morph_face.gltf", "bake/models/house.obj", "host-sim/models/specgloss_gold.gltf",
          "host-sim/models/palette3.gltf", "host-sim/models/trail.obj", "host-sim/models/instancing.gltf"}) {
      models.push_back(std::string(ZSTRIP_TESTS "/") + name);
    }
    picture(folder / "colours.png", 256, [](std::uint32_t x, std::uint32_t y) {
      return std::array{static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), std::uint8_t{60}};
    });
    picture(folder / "mask.png", 64, [](std::uint32_t x, std::uint32_t y) {
      const auto value = static_cast<std::uint8_t>((x / 8 + y / 8) % 2 * 255);
      return std::array{value, value, value};
    });
    models.push_back(ground(folder, "texture", "Kd 1 1 1\nmap_Kd colours.png"));
    models.push_back(ground(folder, "mask", "Kd 1 1 1\nmap_Kd colours.png\nmap_d mask.png"));
    models.push_back(ground(folder, "glass", "Kd 1 0 0\nd 0.5"));
  }
  // docs/models.md has the figures.
  const std::map<std::string, double> farther{{"sea.glb", 0.24}, {"palette3.gltf", 0.17}, {"trail.obj", 0.13}};
  const auto file = [&folder](const char* name) { return (folder / name).string(); };
  for (const std::string& model : models) {
    ASSERT_EQ(command({"fit", model, "--board", "pico", "--quiet", "--json", file("fit.json")}).exit_status, 0)
        << model;
    std::ifstream fit_file(file("fit.json"));
    const json choice = json::parse(fit_file).at("choices").at(0);
    std::vector<std::string> bench{all ? ZSTRIP_ROOT "/host-sim/run" : ZSTRIP_COMMAND, "bench", model};
    for (const char* word : {"--board", "pico", "--size", "240x240", "--format", "rgb565_swapped", "--frames", "1"}) {
      bench.emplace_back(word);
    }
    for (const std::string word : choice.at("bake")) {
      if (word.starts_with("--texture") || word.starts_with("--triangles")) bench.push_back(word);
    }
    if (!all) bench.insert(bench.end(), {"--firmware", ZSTRIP_FIRMWARE_BINARIES});
    bench.insert(bench.end(), {"--json", file("bench.json")});
    const Result<ChildOutput> counted = run_program(bench, std::chrono::seconds{300});
    ASSERT_TRUE(counted && counted->exit_status == 0) << model << (counted ? counted->text : std::string());
    std::ifstream bench_file(file("bench.json"));
    const json rates = json::parse(bench_file).at(0).at("frames_per_second");
    const double rate = (rates.at(0).get<double>() + rates.at(1).get<double>()) / 2;
    const std::string name = std::filesystem::path(model).filename().string();
    const double predicted = choice.at("frames_per_second").at(0).get<double>() / rate;
    RecordProperty(name, fmt::format("{:.3f}", predicted));
    const auto known = farther.find(name);
    EXPECT_NEAR(predicted, 1, known == farther.end() ? 0.1 : known->second) << name;
  }
  std::filesystem::remove_all(folder);
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
