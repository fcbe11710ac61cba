// What a plan costs in time, from counts alone: how often strips visit a meshlet or a triangle again.
#pragma once

#include "zstrip/budget.hpp"

namespace zstrip {
namespace detail {

/// Instructions on a Cortex-M3, rounded from counts of the knot in different strips.
inline constexpr std::uint64_t kCostOfVertex = 70;
inline constexpr std::uint64_t kCostOfCulling = 25;  // a triangle, facing either way
inline constexpr std::uint64_t kCostOfBinning = 90;  // a triangle in a strip's list
inline constexpr std::uint64_t kCostOfSetup = 400;   // a triangle in a strip
inline constexpr std::uint64_t kCostOfFragment = 22;
inline constexpr std::uint64_t kCostOfClearing = 3;    // a pixel
inline constexpr std::uint64_t kCostOfAveraging = 16;  // a pixel of several samples
inline constexpr std::uint64_t kCostOfMeshlet = 150;

constexpr std::uint32_t rough_square_root(std::uint64_t value) {
  std::uint64_t root = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 31; bit != 0; bit >>= 1) {
    if ((root + bit) * (root + bit) <= value) root += bit;
  }
  return static_cast<std::uint32_t>(root);
}

/// Strips that a square of `side` pixels touches on average, 24.8.
constexpr std::uint64_t strips_touched(std::uint32_t side, const View& view, const Plan& plan) {
  const auto along = [side](std::uint32_t length, std::uint32_t whole) {
    return length >= whole ? std::uint64_t{256} : 256 + (std::uint64_t{side} << 8) / length;
  };
  return along(plan.strip_rows, view.height) * along(plan.strip_columns, view.width) >> 8;
}

/// Entries that the facing half of the triangles and meshlets makes in the lists of all strips.
struct Visits {
  std::uint64_t meshlets, triangles;
};
constexpr Visits visits_of(const SceneCounts& counts, const View& view, const Plan& plan) {
  const std::uint64_t meshlets = counts.meshlets > 1 ? counts.meshlets : 1;
  const std::uint64_t triangles = counts.triangles > 1 ? counts.triangles : 1;
  const std::uint64_t pixels = std::uint64_t{view.width} * view.height;
  const std::uint64_t facing_meshlets = (meshlets + 1) / 2;
  const std::uint64_t facing_triangles = (triangles + 1) / 2;
  return {facing_meshlets * strips_touched(rough_square_root(pixels / facing_meshlets), view, plan) >> 8,
          // A triangle is half of its box.
          facing_triangles * strips_touched(rough_square_root(2 * pixels / facing_triangles), view, plan) >> 8};
}

}  // namespace detail

constexpr std::uint64_t estimated_cost(const SceneCounts& counts, const View& view, const Plan& plan) {
  using namespace detail;
  if (plan.strips == 0) return UINT64_MAX;  // no plan
  const Visits visits = visits_of(counts, view, plan);
  const std::uint64_t meshlets = counts.meshlets > 1 ? counts.meshlets : 1;
  const std::uint64_t pass =
      counts.vertices * kCostOfVertex + counts.triangles * kCostOfCulling + meshlets * kCostOfMeshlet;
  std::uint64_t geometry = pass;
  if (plan.mode == Mode::binned) {
    geometry += visits.triangles * kCostOfBinning;
  } else if (plan.strips > 1) {
    geometry += pass / meshlets * visits.meshlets;
  }
  return geometry + visits.triangles * kCostOfSetup +
         std::uint64_t{view.width} * view.height * view.samples * (kCostOfFragment + kCostOfClearing) +
         (view.samples == 1 ? 0 : std::uint64_t{view.width} * view.height * kCostOfAveraging) +
         std::uint64_t{plan.strips} * kCostOfMeshlet;
}

}  // namespace zstrip
