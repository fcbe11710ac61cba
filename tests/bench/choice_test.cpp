// Plans that are chosen for a budget, against others that it allows, as an emulated Cortex-M3 counts them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "bench/board_bench.hpp"
#include "bench/workloads.hpp"
#include "zstrip/plan.hpp"

namespace zstrip::sim {
namespace {

constexpr View kView{.width = 320, .height = 240, .format = PixelFormat::rgb565};
constexpr std::uint16_t kColumns[] = {320, 160, 80};
constexpr std::uint16_t kRows[] = {240, 120, 60, 30, 16, 8};
constexpr int kBudgets = 6;
constexpr double kMaxRatio = 1.15;
constexpr double kMaxRatioOfTiles = 1.5;  // counts do not say which of them a mesh without meshlets touches

class Choice : public testing::TestWithParam<Workload> {
 protected:
  PlanResult planned(const Budget& budget) const {
    return plan(built_in_.counts, kView, effects_of(built_in_.scene, built_in_.camera) | effect::bins, budget);
  }
  static std::uint64_t all_bytes(const Plan& plan) { return plan.bytes() + plan.strip_pixel_bytes(kView); }

  /// Of the first frame. Zero: not counted.
  std::uint64_t counted(const Plan& plan) {
    const auto [entry, is_new] = counted_.try_emplace({plan.mode, plan.strip_rows, plan.strip_columns}, 0);
    if (!is_new) return entry->second;
    const auto rows = bench_on_board(
        {{.workload = std::string(GetParam().name),
          .target = "m3",
          .view = kView,
          .budget = {.strip_rows = plan.strip_rows, .strip_columns = plan.strip_columns, .modes = modes_of(plan)},
          .frames = 1}},
        ZSTRIP_FIRMWARE_BINARIES);
    EXPECT_TRUE(rows) << rows.failure().message;
    if (rows) entry->second = rows->at(0).instructions_per_frame.value_or(0);
    return entry->second;
  }

 private:
  static Modes modes_of(const Plan& plan) { return plan.mode == Mode::binned ? Modes::binned : Modes::streamed; }

  const scenes::BuiltIn& built_in_ = *GetParam().built_in();
  std::map<std::tuple<Mode, std::uint16_t, std::uint16_t>, std::uint64_t> counted_;
};

/// All rows and columns that are tried, in both modes: the planner's own rows are not among them.
TEST_P(Choice, IsNearTheBestOfItsBudget) {
  const double least = planned({.bytes = 1, .split_columns = true, .strip_buffers = 1}).status.needed;
  const double most = static_cast<double>(all_bytes(planned({.strip_buffers = 1}).plan));
  int compared = 0;
  for (int point = 0; point <= kBudgets; ++point) {
    const auto bytes =
        static_cast<std::uint32_t>(std::ceil(least * std::pow(most / least, static_cast<double>(point) / kBudgets)));
    for (const bool split : {false, true}) {
      const auto [status, chosen] = planned({.bytes = bytes, .split_columns = split, .strip_buffers = 1});
      if (!status) continue;
      std::uint64_t best = UINT64_MAX;
      for (const Modes modes : {Modes::streamed, Modes::binned}) {
        for (const std::uint16_t columns : kColumns) {
          if (columns != kView.width && !split) continue;
          for (const std::uint16_t rows : kRows) {
            const auto [fits, other] = planned(
                {.bytes = bytes, .strip_rows = rows, .strip_columns = columns, .strip_buffers = 1, .modes = modes});
            if (fits) best = std::min(best, counted(other));
          }
        }
      }
      if (best == UINT64_MAX) continue;  // only the planner's own rows fit
      ++compared;
      EXPECT_GT(counted(chosen), 0U);
      EXPECT_GT(best, 0U);
      EXPECT_LE(static_cast<double>(counted(chosen)) / static_cast<double>(best), split ? kMaxRatioOfTiles : kMaxRatio)
          << bytes << " bytes: " << (chosen.mode == Mode::binned ? "binned, " : "streamed, ") << chosen.strip_columns
          << 'x' << chosen.strip_rows;
    }
  }
  EXPECT_GT(compared, kBudgets);
}

/// What moves has no program with bins.
std::vector<Workload> estimated_workloads() {
  std::vector<Workload> all;
  std::ranges::copy_if(workloads(), std::back_inserter(all),
                       [](const Workload& each) { return each.built_in()->pose == nullptr; });
  return all;
}

INSTANTIATE_TEST_SUITE_P(Plan, Choice, testing::ValuesIn(estimated_workloads()),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace zstrip::sim
