// zstrip tune: the answer keeps the limits, and is the answer; what cannot be met is said.
#include "accuracy/tune.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "accuracy/board_cost.hpp"
#include "support.hpp"

namespace zstrip::sim {
namespace {

using TuneCommand = test::FolderTest;

TEST_F(TuneCommand, KeepsTheLimitsAndWritesTheSettings) {
  const test::Outcome outcome = test::run(
      ZSTRIP_COMMAND,
      {"tune", "teapot_meshlets", "--size", "96x72", "--max-error-pixels", "3%", "--max-ram", "16K", "-o", "out"},
      path(""));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string toml = test::read(path("out/quality.toml"));
  EXPECT_TRUE(toml.starts_with("[quality]\n")) << toml;
  for (const KnobInfo& knob : knobs()) EXPECT_NE(toml.find(std::string(knob.name) + " = \""), std::string::npos);
  EXPECT_NE(test::read(path("out/quality.hpp")).find("inline constexpr zstrip::Budget kBudget{.strip_rows = "),
            std::string::npos);
  EXPECT_NE(test::read(path("out/quality.json")).find("\"wrong_pixels\""), std::string::npos);
}

TEST_F(TuneCommand, SaysWhichLimitCannotBeMetAndByHowMuch) {
  const test::Outcome outcome =
      test::run(ZSTRIP_COMMAND, {"tune", "teapot", "--size", "96x72", "--max-ram", "1K"}, path(""));
  EXPECT_EQ(outcome.status, 5);
  EXPECT_NE(outcome.err.find("--max-ram: 1,024 bytes asked for, "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(" too much"), std::string::npos) << outcome.err;
  const test::Outcome backwards = test::run(ZSTRIP_COMMAND, {"tune", "teapot", "--min-fps", "-3"}, path(""));
  EXPECT_EQ(backwards.status, 2) << backwards.out;
  EXPECT_NE(backwards.err.find("--min-fps -3 must be more than 0"), std::string::npos) << backwards.err;
  const test::Outcome misspelt = test::run(ZSTRIP_COMMAND, {"tune", "teapot", "--max-flash", "lots"}, path(""));
  EXPECT_EQ(misspelt.status, 2);
  EXPECT_NE(misspelt.err.find("--max-flash 'lots' must be a number of bytes"), std::string::npos) << misspelt.err;
}

TEST_F(TuneCommand, EdgesBesideADepthThatTheyDoNotGoWithAreRefused) {
  const test::Outcome outcome =
      test::run(ZSTRIP_COMMAND, {"accuracy", "cube", "--only", "samples=edges,depth=z24", "--size", "32x24", "-o", "a"},
                path(""));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("'depth=z24,samples=edges' cannot be drawn"), std::string::npos) << outcome.err;
}

TEST(Tune, SamplesAreForThoseWhoLimitHowItLooks) {
  const auto scene =
      AccuracyScene::open({.scene = "wires", .view = {64, 48}, .frames = 1, .target = "m3", .firmware = ""});
  ASSERT_TRUE(scene);
  const auto has_samples = [&](const Limits& limits) {
    const Result<std::vector<std::string>> programs = programs_to_tune(**scene, limits, "gray4");
    EXPECT_TRUE(programs);
    // Programs have all shades, because settings change how triangles are drawn.
    const Effects effects = without_shades((*scene)->effects()) | effect::supersampled | effect::dithered_format;
    return std::ranges::find(*programs, board_program_name("m3", effects)) != programs->end();
  };
  EXPECT_FALSE(has_samples({.wrong_pixels = 2.0}));
  EXPECT_TRUE(has_samples({.perceived = 1.0}));
}

TEST(Tune, TakesMoreSamplesWhereOneDoesNotLookWell) {
  const auto scene = AccuracyScene::open({.scene = "spheres", .view = {64, 48}, .frames = 1, .firmware = ""});
  ASSERT_TRUE(scene);
  const auto perceived = [&](const Settings& settings) { return (*(*scene)->errors(settings))[Figure::perceived]; };
  const Limits limits{.perceived = perceived(*parse_settings("samples=4")) * 1.001};
  ASSERT_GT(perceived(*parse_settings("dither=on")), *limits.perceived);
  const Result<Tuned> tuned = tune(**scene, limits, "rgb565", 2, [](std::size_t, std::size_t) {});
  ASSERT_TRUE(tuned) << tuned.failure().message;
  ASSERT_TRUE(tuned->best);
  EXPECT_LE(perceived(tuned->best->settings), *limits.perceived);
  EXPECT_NE(tuned->best->settings[Knob::samples], 0);
}

TEST(Tune, LooksAtAllCombinationsAndKeepsTheLimits) {
  const auto scene = AccuracyScene::open({.scene = "knot_meshlets", .view = {96, 72}, .frames = 1, .firmware = ""});
  ASSERT_TRUE(scene);
  const Limits limits{.wrong_pixels = 2.0, .ram = 20000};
  const Result<Tuned> tuned = tune(**scene, limits, "rgb565", 2, [](std::size_t, std::size_t) {});
  ASSERT_TRUE(tuned) << tuned.failure().message;
  ASSERT_TRUE(tuned->best);
  EXPECT_LE(tuned->best->errors[Figure::wrong_pixels], 2.0);
  EXPECT_LE(tuned->best->cost.ram_bytes, 20000U);
  EXPECT_GT(tuned->candidates, 100U);
}

}  // namespace
}  // namespace zstrip::sim
