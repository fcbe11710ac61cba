// Plans: what fits, what does not, and that the numbers say why.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "zstrip/plan.hpp"

namespace {

using namespace zstrip;

constexpr SceneCounts kCounts{.instances = 2, .triangles = 900, .vertices = 500, .largest_meshlet = 64};
constexpr View kView{.width = 240, .height = 240, .format = PixelFormat::rgb565};

TEST(Plan, UnlimitedIsOneStrip) {
  const PlanResult result = plan(kCounts, kView, effect::lighting | effect::gouraud);
  ASSERT_TRUE(result.status);
  EXPECT_EQ(result.plan.strips, 1);
  EXPECT_EQ(result.plan.strip_rows, 240);
  EXPECT_EQ(result.plan.depth_bytes, 240U * 240 * 2);
  EXPECT_EQ(result.plan.vertex_bytes, 64U * 12);
  EXPECT_EQ(result.plan.colour_bytes, 0U);
}

TEST(Plan, IsConstexpr) {
  static_assert(plan(kCounts, kView, effect::gouraud, {.bytes = 8192}).status);
  static_assert(plan(kCounts, kView, effect::gouraud, {.bytes = 8192}).plan.bytes() <= 8192);
}

TEST(Plan, AbsentEffectsCostNoMemory) {
  EXPECT_EQ(plan(kCounts, kView, {}).plan.vertex_bytes, 64U * 8);
  EXPECT_EQ(plan(kCounts, kView, effect::textures).plan.vertex_bytes, 64U * 8);
  EXPECT_EQ(plan(kCounts, kView, effect::vertex_colours).plan.vertex_bytes, 64U * 12);
}

TEST(Plan, EveryBudgetIsKeptOrRefusedWithTheBytesItNeeds) {
  const PlanResult smallest = plan(kCounts, kView, effect::lighting, {.bytes = 1});
  ASSERT_EQ(smallest.status.error, Error::arena_too_small);
  ASSERT_GT(smallest.status.needed, 1U);
  EXPECT_EQ(smallest.status.available, 1U);
  std::uint16_t previous_rows = 0;
  for (std::uint32_t bytes = 1; bytes < 130000; bytes += 7) {
    const PlanResult result = plan(kCounts, kView, effect::lighting, {.bytes = bytes});
    ASSERT_EQ(static_cast<bool>(result.status), bytes >= smallest.status.needed) << bytes;
    if (!result.status) continue;
    ASSERT_LE(result.plan.bytes(), bytes);
    ASSERT_EQ(result.plan.strips, (240 + result.plan.strip_rows - 1) / result.plan.strip_rows);
    ASSERT_GE(result.plan.strip_rows, previous_rows) << "more memory, no smaller strips";
    ASSERT_EQ(result.plan.strip_columns, 240);
    previous_rows = result.plan.strip_rows;
  }
  EXPECT_EQ(previous_rows, 240);
}

TEST(Plan, MoreMemoryNeverCostsMoreTime) {
  constexpr SceneCounts kMany{.instances = 2,
                              .triangles = 5000,
                              .vertices = 3000,
                              .largest_meshlet = 64,
                              .meshlets = 60,
                              .longest_meshlet = 100};
  for (const bool split : {false, true}) {
    std::uint64_t previous = UINT64_MAX;
    bool binned = false, split_used = false;
    for (std::uint32_t bytes = 2000; bytes < 200000; bytes += 97) {
      constexpr Effects kEffects = effect::lighting | effect::bins;
      const PlanResult result =
          plan(kMany, kView, kEffects, {.bytes = bytes, .split_columns = split, .strip_buffers = 2});
      if (!result.status) {
        ASSERT_EQ(previous, UINT64_MAX) << "less memory was enough: " << bytes;
        continue;
      }
      ASSERT_LE(result.plan.bytes() + 2 * result.plan.strip_pixel_bytes(kView), bytes);
      const std::uint64_t cost = estimated_cost(kMany, kEffects, kView, result.plan);
      ASSERT_LE(cost, previous) << bytes;
      previous = cost;
      binned |= result.plan.mode == Mode::binned;
      split_used |= result.plan.strip_columns < 240;
    }
    EXPECT_TRUE(binned);
    EXPECT_EQ(split_used, split);
  }
}

TEST(Plan, StripsTileThePicture) {
  for (const std::uint16_t columns : std::array<std::uint16_t, 4>{8, 16, 104, 240}) {
    for (const std::uint16_t rows : std::array<std::uint16_t, 3>{1, 7, 240}) {
      const Plan p = plan(kCounts, kView, {}, {.strip_rows = rows, .strip_columns = columns}).plan;
      std::array<int, 240 * 240> covered{};
      for (std::uint16_t strip = 0; strip < p.strips; ++strip) {
        const Rect area = p.strip_area(strip, kView);
        ASSERT_LE(area.width(), columns);
        ASSERT_LE(area.height(), rows);
        for (int y = area.top; y < area.bottom; ++y) {
          for (int x = area.left; x < area.right; ++x) ++covered[static_cast<std::size_t>(y * 240 + x)];
        }
      }
      EXPECT_EQ(std::count(covered.begin(), covered.end(), 1), 240 * 240);
    }
  }
}

TEST(Plan, ColumnsThatSplitBytesAreRefused) {
  EXPECT_EQ(plan(kCounts, kView, {}, {.strip_columns = 12}).status.error, Error::strip_columns);
  EXPECT_EQ(plan(kCounts, kView, {}, {.strip_columns = 248}).status.error, Error::strip_columns);
  EXPECT_TRUE(plan(kCounts, View{30, 10}, {}, {.strip_columns = 30}).status);
}

TEST(Plan, BinningNeedsItsEffectAndIndicesThatFit) {
  EXPECT_EQ(plan(kCounts, kView, {}, {.modes = Modes::binned}).status.error, Error::effect_missing);
  EXPECT_EQ(plan(kCounts, kView, effect::bins, {.strip_rows = 8, .modes = Modes::binned}).plan.mode, Mode::binned);
  SceneCounts many = kCounts;
  many.meshlets = 0x8000;
  EXPECT_EQ(plan(many, kView, effect::bins, {.strip_rows = 8, .modes = Modes::binned}).status.error,
            Error::unplannable);
  EXPECT_EQ(plan(many, kView, effect::bins, {.strip_rows = 8}).plan.mode, Mode::streamed);
  EXPECT_EQ(plan(kCounts, View{4096, 4096}, {}, {.strip_rows = 1, .strip_columns = 8}).status.error,
            Error::unplannable);
}

/// Regression: bins of a single strip took memory and a pass over all triangles for nothing, and could overflow.
TEST(Plan, ASingleStripIsNeverBinned) {
  for (const std::uint16_t rows : std::array<std::uint16_t, 2>{0, 240}) {
    const Plan asked = plan(kCounts, kView, effect::bins, {.strip_rows = rows, .modes = Modes::binned}).plan;
    const Plan streamed = plan(kCounts, kView, effect::bins, {.strip_rows = rows, .modes = Modes::streamed}).plan;
    EXPECT_EQ(asked.strips, 1);
    EXPECT_EQ(asked.mode, Mode::streamed);
    EXPECT_EQ(asked.bytes(), streamed.bytes());
    EXPECT_EQ(asked.bin_bytes, 0U);
  }
}

TEST(Plan, GivenRowsAreKeptOrRefused) {
  const PlanResult fits = plan(kCounts, kView, {}, {.bytes = 8192, .strip_rows = 8});
  ASSERT_TRUE(fits.status);
  EXPECT_EQ(fits.plan.strip_rows, 8);
  const PlanResult refused = plan(kCounts, kView, {}, {.bytes = 4096, .strip_rows = 16});
  ASSERT_EQ(refused.status.error, Error::arena_too_small);
  EXPECT_EQ(refused.status.purpose, Purpose::depth);
  EXPECT_EQ(refused.status.needed, refused.plan.bytes());
  EXPECT_EQ(plan(kCounts, kView, {}, {.strip_rows = 241}).status.error, Error::strip_rows);
}

TEST(Plan, ImpossibleSizesAreRefused) {
  for (const View view : {View{0, 10}, View{10, 0}, View{4097, 10}, View{10, 4097}, View{65535, 65535}}) {
    EXPECT_EQ(plan(kCounts, view, {}).status.error, Error::view_size);
  }
  EXPECT_TRUE(plan(kCounts, View{4096, 4096}, {}).status);
  EXPECT_TRUE(plan(kCounts, View{1, 1}, {}).status);
}

/// A format that does not exist was planned with two bytes a pixel, and drawn with three.
TEST(Plan, FormatsThatDoNotExistAreRefused) {
  for (const int format : {static_cast<int>(kLastPixelFormat) + 1, 255}) {
    EXPECT_EQ(plan(kCounts, View{8, 8, static_cast<PixelFormat>(format)}, {}).status.error, Error::view_size);
  }
}

TEST(Plan, AStaticLayerTakesItsShareOfTheBudget) {
  constexpr View kTall{.width = 240, .height = 236, .format = PixelFormat::rgb565};
  constexpr LayerBytes kLayer = layer_bytes(kTall, 20'000, 30'000);
  const PlanResult smallest = plan(kCounts, kTall, {}, {.bytes = 1, .layer = kLayer});
  ASSERT_EQ(smallest.status.error, Error::arena_too_small);
  EXPECT_EQ(smallest.status.purpose, Purpose::layer);
  for (std::uint32_t bytes = smallest.status.needed; bytes < 250'000; bytes += 997) {
    const PlanResult with = plan(kCounts, kTall, {}, {.bytes = bytes, .layer = kLayer});
    ASSERT_TRUE(with.status);
    ASSERT_LE(with.plan.bytes() + 20'000 + 30'000 + 4 * 30, bytes);
    ASSERT_TRUE(with.plan.strip_rows % 8 == 0 || with.plan.strip_rows == 236) << with.plan.strip_rows;
  }
  EXPECT_FALSE(plan(kCounts, kTall, {}, {.bytes = smallest.status.needed - 1, .layer = kLayer}).status);
  EXPECT_EQ(plan(kCounts, kTall, {}, {.layer = kLayer}).plan.strip_rows, 236);
}

TEST(Plan, AStaticLayerThatCouldNotBeKeptIsRefused) {
  const Budget budget{.layer = layer_bytes_worst(kView)};
  const auto error = [&](const View& view, Effects effects, Budget b) {
    return plan(kCounts, view, effects, b).status.error;
  };
  EXPECT_EQ(error(View{240, 240, PixelFormat::gray4}, {}, budget), Error::store_range);
  for (const Effects effects : {effect::depth_24, effect::depth_ranges}) {
    EXPECT_EQ(error(kView, effects, budget), Error::depth_effects);
  }
  EXPECT_EQ(error(kView, effect::depth_float, budget), Error::none);
  Budget between = budget;
  between.strip_rows = 12;
  EXPECT_EQ(error(kView, {}, between), Error::strip_rows);
  between.strip_rows = 16;
  EXPECT_EQ(error(kView, {}, between), Error::none);
  Budget endless;
  endless.layer = {0xFFFFFFFF, 0xFFFFFFFF, 0xFFFFFFFF};
  EXPECT_EQ(error(kView, {}, endless), Error::arena_too_small);
}

TEST(Plan, PanelFormatsNeedAWorkingStrip) {
  const PlanResult result = plan(kCounts, View{128, 64, PixelFormat::gray4}, {}, {.strip_rows = 8});
  ASSERT_TRUE(result.status);
  EXPECT_EQ(result.plan.colour_bytes, 128U * 8 * 2);
  EXPECT_EQ(result.plan.strip_pixel_bytes(View{128, 64, PixelFormat::gray4}), 64U * 8);
  EXPECT_EQ(result.plan.strip_pixel_bytes(View{127, 64, PixelFormat::mono}), 16U * 8);
}

}  // namespace
