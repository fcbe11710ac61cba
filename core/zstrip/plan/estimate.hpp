// Estimates the instructions of a frame on a Cortex-M3 from its work, and the work of a plan from counts alone.
#pragma once

#include "zstrip/base/statistics.hpp"
#include "zstrip/budget.hpp"
#include "zstrip/effects.hpp"

namespace zstrip {
namespace detail {

/// Instructions. A least-squares fit of relative errors over 190 frames of the workloads, for bins over 112 frames;
/// then, for skins and textures, over 60 frames of `character`, K5T, CT and `room`.
inline constexpr std::uint64_t kCostOfVertex = 100;
inline constexpr std::uint64_t kCostOfLighting = 27;   // a vertex
inline constexpr std::uint64_t kCostOfSkin = 160;      // a vertex that joints move, normal included
inline constexpr std::uint64_t kCostOfCulling = 58;    // a triangle, each time that its vertices are transformed
inline constexpr std::uint64_t kCostOfBinning = 31;    // a triangle, once
inline constexpr std::uint64_t kCostOfBinBoxes = 30;   // in addition, with both sides or in columns of strips
inline constexpr std::uint64_t kCostOfBin = 20;        // a triangle in a strip's list
inline constexpr std::uint64_t kCostOfSetup = 56;      // a triangle in a strip
inline constexpr std::uint64_t kCostOfTexture = 970;   // in addition, a textured triangle in a strip
inline constexpr std::uint64_t kCostOfRow = 134;       // a row of a triangle, counted as in rows_of
inline constexpr std::uint64_t kCostOfAveraging = 16;  // a pixel of several samples
inline constexpr std::uint64_t kCostOfMeshlet = 169;   // a meshlet in each strip, streamed
inline constexpr std::uint64_t kCostOfBatch = 60;      // a meshlet in each strip, binned
/// In eighths of an instruction.
inline constexpr std::uint64_t kCostOfPixel = 15;      // a pixel of a triangle, in addition to its row
inline constexpr std::uint64_t kCostOfTexel = 146;     // a pixel with unlit texels
inline constexpr std::uint64_t kCostOfLitTexel = 321;  // a pixel with lit texels
inline constexpr std::uint64_t kCostOfClearing = 12;   // a pixel or sample

constexpr std::uint32_t rough_square_root(std::uint64_t value) {
  std::uint64_t root = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 31; bit != 0; bit >>= 1) {
    if ((root + bit) * (root + bit) <= value) root += bit;
  }
  return static_cast<std::uint32_t>(root);
}

/// Returns the rows of triangles in strips: a triangle's rows grow as the square root of its pixels.
constexpr std::uint64_t rows_of(std::uint64_t covering, std::uint64_t fragments) {
  return std::uint64_t{rough_square_root(covering << 8)} * rough_square_root(fragments << 8) >> 8;
}

}  // namespace detail

/// The work of a frame, counted or expected.
struct Work {
  std::uint64_t vertices = 0;   ///< transformed vertices; each transform counts
  std::uint64_t covering = 0;   ///< triangles that are set up, counted in each strip
  std::uint64_t fragments = 0;  ///< fragments of all triangles
  std::uint64_t rows = 0;       ///< rows of triangles, counted in each strip
};
constexpr Work work_of(const Statistics& done) {
  return {done.vertices, done.covering, done.fragments, detail::rows_of(done.covering, done.fragments)};
}

namespace detail {

/// The triangles or meshlets that face the camera, modelled as squares that fill the view once.
struct FacingParts {
  std::uint64_t count;
  std::uint64_t across, down;  ///< average number of strips that one part touches, side by side and one below the
                               ///< other, 24.8
  constexpr std::uint64_t visits() const { return count * (across * down >> 8) >> 8; }
};

/// The eighths of a closed surface's parts that face the camera: the mean over all directions, and the largest share
/// for which bins have room. Seen from its widest side, 61 % of the triangles of `character` face the camera.
inline constexpr std::uint64_t kFacingOnAverage = 4, kFacingAtMost = 5;

/// Returns the parts that face the camera: `eighths` of `all`, or all if a material shows its back faces. The triangles
/// fill 1 / `boxes` of their boxes.
constexpr FacingParts facing_parts(std::uint32_t all, std::uint32_t boxes, std::uint64_t eighths, Effects effects,
                                   const View& view, const Plan& plan) {
  const std::uint64_t count = all < 2 ? 1 : effects.has(effect::two_sided) ? all : (all * eighths + 7) / 8;
  const std::uint64_t side = rough_square_root(std::uint64_t{view.width} * view.height * boxes / count);
  const auto touched = [side](std::uint64_t length, std::uint64_t strips) {
    const std::uint64_t on_average = 256 + (side << 8) / length;
    return on_average < strips << 8 ? on_average : strips << 8;
  };
  return {count, touched(plan.strip_columns, plan.columns_of_strips(view)),
          touched(plan.strip_rows, plan.rows_of_strips(view))};
}
constexpr FacingParts facing_meshlets(const SceneCounts& counts, Effects effects, const View& view, const Plan& plan,
                                      std::uint64_t eighths = kFacingOnAverage) {
  return facing_parts(counts.meshlets, 1, eighths, effects, view, plan);
}
constexpr FacingParts facing_triangles(const SceneCounts& counts, Effects effects, const View& view, const Plan& plan,
                                       std::uint64_t eighths = kFacingOnAverage) {
  return facing_parts(counts.triangles, 2, eighths, effects, view, plan);
}

constexpr Work expected_work(const SceneCounts& counts, Effects effects, const View& view, const Plan& plan) {
  const FacingParts triangles = facing_triangles(counts, effects, view, plan);
  Work work{.vertices = counts.vertices,
            .covering = triangles.visits(),
            .fragments = std::uint64_t{view.width} * view.height * view.samples};
  // Strips side by side repeat the rows.
  work.rows = rows_of(triangles.count * triangles.down >> 8, work.fragments) * triangles.across >> 8;
  if (plan.mode == Mode::streamed && plan.strips > 1) {
    const std::uint64_t visits = facing_meshlets(counts, effects, view, plan).visits();
    work.vertices += counts.vertices * ((visits << 8) / (counts.meshlets > 1 ? counts.meshlets : 1)) >> 8;
  }
  return work;
}

}  // namespace detail

constexpr std::uint64_t estimated_cost(const SceneCounts& counts, Effects effects, const View& view, const Plan& plan,
                                       const Work& work) {
  using namespace detail;
  const std::uint64_t pixels = std::uint64_t{view.width} * view.height;
  // The triangles of a meshlet are culled each time that its vertices are transformed.
  const std::uint64_t passes = (work.vertices << 8) / (counts.vertices > 1 ? counts.vertices : 1);  // 24.8
  const std::uint64_t culled = counts.triangles * passes >> 8;
  const std::uint64_t pixel = !effects.has(effect::textures)  ? kCostOfPixel
                              : effects.has(effect::lighting) ? kCostOfLitTexel
                                                              : kCostOfTexel;
  std::uint64_t cost = work.vertices * kCostOfVertex + culled * kCostOfCulling + work.covering * kCostOfSetup +
                       work.rows * kCostOfRow + (work.fragments * pixel + pixels * view.samples * kCostOfClearing) / 8;
  if (effects.has(effect::lighting)) cost += work.vertices * kCostOfLighting;
  if (effects.has(effect::skins)) cost += work.vertices * kCostOfSkin;
  if (effects.has(effect::textures)) cost += work.covering * kCostOfTexture;
  const std::uint64_t meshlets = std::uint64_t{counts.meshlets} * plan.strips;  // in strips
  if (plan.mode == Mode::binned) {
    cost += culled * kCostOfBinning + work.covering * kCostOfBin + meshlets * kCostOfBatch;
    if (effects.has(effect::two_sided) || plan.strip_columns != view.width) cost += culled * kCostOfBinBoxes;
  } else {
    cost += meshlets * kCostOfMeshlet;
  }
  if (view.samples != 1) cost += pixels * kCostOfAveraging;
  return cost;
}

constexpr std::uint64_t estimated_cost(const SceneCounts& counts, Effects effects, const View& view, const Plan& plan) {
  if (plan.strips == 0) return UINT64_MAX;  // not a plan
  return estimated_cost(counts, effects, view, plan, detail::expected_work(counts, effects, view, plan));
}

}  // namespace zstrip
