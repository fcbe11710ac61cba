// The bounds of tiles and pyramid against the cells themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "zstrip/visibility/depth_bounds.hpp"

namespace zstrip::detail {
namespace {

TEST(Visibility, BoundsNeverClaimMoreThanTheCellsShow) {
  std::mt19937 random(7);
  const auto below = [&](int limit) { return std::uniform_int_distribution<int>(0, limit - 1)(random); };
  int hidden = 0, seen = 0;
  for (const auto& [width, height] : {std::pair{1, 1}, {8, 8}, {9, 17}, {64, 40}, {129, 3}, {200, 70}}) {
    std::vector<std::uint16_t> cells(static_cast<std::size_t>(width * height), 0);
    std::vector<std::uint64_t> memory(
        depth_bounds_bytes(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)) / 8 + 1);
    const Rect area{-30, -20, width - 30, height - 20};
    DepthBounds bounds;
    bounds.begin(reinterpret_cast<std::byte*>(memory.data()), area, cells.data());
    VisibilityStatistics counts;
    for (int step = 0; step < 3000; ++step) {
      const int left = below(width), top = below(height);
      const Rect box{left, top, left + 1 + below(width - left), top + 1 + below(height - top)};
      const Rect raster{box.left - 30, box.top - 20, box.right - 30, box.bottom - 20};
      const auto code = static_cast<std::uint32_t>(1 + below(2000) + step * 4);
      const auto for_cells = [&](const auto& visit) {
        for (int y = box.top; y < box.bottom; ++y) {
          for (int x = box.left; x < box.right; ++x) visit(cells[static_cast<std::size_t>(y * width + x)]);
        }
      };
      std::uint32_t farthest = UINT32_MAX, nearest = 0;
      for_cells([&](std::uint16_t cell) {
        farthest = std::min<std::uint32_t>(farthest, cell);
        nearest = std::max<std::uint32_t>(nearest, cell);
      });
      if (bounds.hides(raster, code, &counts)) {
        ++hidden;
        ASSERT_GE(farthest, code);
      }
      if (bounds.lies_behind(raster, code, &counts)) {
        ++seen;
        ASSERT_LT(nearest, code);
      }
      bounds.cover(raster, code);
      for_cells([&](std::uint16_t& cell) { cell = static_cast<std::uint16_t>(std::max<std::uint32_t>(cell, code)); });
    }
    EXPECT_GT(counts.comparisons, 0U);
  }
  EXPECT_GT(hidden, 300);
  EXPECT_GT(seen, 300);
}

TEST(Visibility, RunsLeaveOutWhatATileHides) {
  constexpr int kWidth = 40;
  std::vector<std::uint16_t> cells(kWidth * 8, 0);
  std::vector<std::uint64_t> memory(depth_bounds_bytes(kWidth, 8) / 8 + 1);
  DepthBounds bounds;
  bounds.begin(reinterpret_cast<std::byte*>(memory.data()), {0, 0, kWidth, 8}, cells.data());
  for (int y = 0; y < 8; ++y) std::fill_n(cells.begin() + y * kWidth + 8, 16, std::uint16_t{1000});
  bounds.cover({8, 0, 24, 8}, 1000);
  bounds.cover({8, 0, 24, 8}, 1000);  // half of a box counts as covered
  std::vector<std::pair<std::int32_t, std::int32_t>> runs;
  bounds.for_each_shown(3, 2, 36, 500U << 16, 0, nullptr,
                        [&](std::int32_t first, std::int32_t length) { runs.emplace_back(first, length); });
  EXPECT_EQ(runs, (std::vector<std::pair<std::int32_t, std::int32_t>>{{0, 6}, {22, 14}}));
}

}  // namespace
}  // namespace zstrip::detail
