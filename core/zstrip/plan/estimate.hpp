// Estimates the instructions of a frame on a Cortex-M3 from its work, and the work of a plan from counts alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "zstrip/base/statistics.hpp"
#include "zstrip/budget.hpp"
#include "zstrip/effects.hpp"

namespace zstrip {
namespace detail {

/// Instructions. A least-squares fit of relative errors over 190 frames of the workloads, for bins over 112 frames;
/// then, for skins and textures, over 60 frames of `character`, K5T, CT and `room`.
inline constexpr std::uint64_t kCostOfVertex = 100;
inline constexpr std::uint64_t kCostOfSkin = 160;      // a vertex that joints move, normal included
inline constexpr std::uint64_t kCostOfCulling = 58;    // a triangle, each time that its vertices are transformed
inline constexpr std::uint64_t kCostOfBinning = 31;    // a triangle, once
inline constexpr std::uint64_t kCostOfBinBoxes = 30;   // in addition, with both sides or in columns of strips
inline constexpr std::uint64_t kCostOfBin = 20;        // a triangle in a strip's list
inline constexpr std::uint64_t kCostOfSetup = 56;      // a triangle in a strip
inline constexpr std::uint64_t kCostOfRow = 134;       // a row of a triangle, counted as in rows_of
inline constexpr std::uint64_t kCostOfAveraging = 16;  // a pixel of two samples
inline constexpr std::uint64_t kCostOfFour = 52;       // a pixel of four samples
inline constexpr std::uint64_t kCostOfClipped = 2499;  // a triangle that is cut, in a strip
inline constexpr std::uint64_t kCostOfMeshlet = 169;   // a meshlet in each strip, streamed
inline constexpr std::uint64_t kCostOfBatch = 60;      // a meshlet in each strip, binned
/// In eighths of an instruction.
inline constexpr std::uint64_t kCostOfPixel = 15;     // a pixel of a plain triangle, in addition to its row
inline constexpr std::uint64_t kCostOfClearing = 12;  // a pixel or sample
inline constexpr std::uint64_t kCostOfMono = 248;     // a pixel dithered to a format of few bits

/// Eighths of an instruction for each kind of work, in addition to those of each vertex, triangle and, without stages,
/// row. Textures as above. Stages, light of vertices, clips and shadows were fitted over 48 frames of the six scenes of
/// the gallery, near the counts of their functions. Effects that these scenes lack are from docs/measured/effects.csv.
inline constexpr std::uint32_t kCostOfWork[] = {
    970 * 8,   // textured_triangles
    146,       // textured_fragments
    970 * 8,   // lit_textured_triangles
    321,       // lit_textured_fragments
    900 * 8,   // staged_triangles
    66,        // staged_fragments
    760 * 8,   // staged_textures
    86 * 8,    // spans
    152 * 8,   // runs
    376 * 8,   // runs_of_levels
    185,       // nearest_texels
    590,       // bilinear_texels
    106,       // texel_alphas
    100,       // lit_texels
    680 * 8,   // lit_fragments
    54 * 8,    // masked
    278,       // fogged
    300,       // blended
    150 * 8,   // dithered
    60 * 8,    // lit_vertices
    222 * 8,   // lights_of_vertices
    398 * 8,   // shining_vertices
    328 * 8,   // mirroring_vertices
    3794 * 8,  // clips
    95 * 8,    // cells_of_shadow_map
    106 * 8,   // shadow_samples
    118 * 8,   // hull_vertices
    670 * 8,   // meshlets_again: kCostOfMeshlet is the mean of scenes with many more of them
    0,         // vertices_again, which are counted as vertices
    550 * 8,   // triangles_again, as no kernel draws those of the map
    0,         // fragments_again
    340 * 8,   // fragments_of_quadrics
    26 * 8,    // fragments_of_lines
    18 * 8,    // searched_edges; all except the next one are near the counts of their functions
    1050 * 8,  // surveyed_edges: they take about 300; the rest corrects the estimates of six gallery scenes
    190 * 8,   // projected_edges
    500 * 8,   // blended_edges
    150 * 8,   // pixels_of_edges: they take 130, the start of a walk included
};
static_assert(std::size(kCostOfWork) == kWorkKinds);

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

/// The work of a frame, counted or expected. Counts are those of all strips.
struct Work {
  std::uint64_t vertices = 0;   ///< transformed vertices; each transform counts
  std::uint64_t covering = 0;   ///< triangles that are set up
  std::uint64_t fragments = 0;  ///< fragments of all triangles
  std::uint64_t rows = 0;       ///< rows of triangles without stages
  std::uint64_t clipped = 0;    ///< triangles that are cut
  WorkCounts kinds{};
};
constexpr Work work_of(const Statistics& done) {
  const WorkCounts kinds = done.work;
  Work work{.vertices = done.vertices + kinds[WorkKind::vertices_again],
            .covering = done.covering + kinds[WorkKind::triangles_again],
            .fragments = done.fragments + kinds[WorkKind::fragments_again],
            .clipped = done.clipped,
            .kinds = kinds};
  work.rows = detail::rows_of(work.covering - kinds[WorkKind::staged_triangles],
                              work.fragments - kinds[WorkKind::staged_fragments]);
  return work;
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

/// Sets the kinds of work of a scene in which every triangle has all `effects`.
constexpr void expect_kinds(Work& work, const SceneCounts& counts, Effects effects) {
  const auto triangles = static_cast<std::uint32_t>(work.covering), rows = static_cast<std::uint32_t>(work.rows);
  const auto fragments = static_cast<std::uint32_t>(work.fragments);
  const auto set = [&](Effects needed, WorkKind kind, std::uint32_t count) {
    if (effects.any(needed)) work.kinds[kind] = count;
  };
  if (effects.any(effect::fragments)) {
    work.kinds[WorkKind::staged_triangles] = triangles;
    work.kinds[WorkKind::staged_fragments] = fragments;
    work.kinds[WorkKind::spans] = rows;
    work.kinds[WorkKind::runs] = rows + fragments / 16;
    work.rows = 0;
    set(effect::textures, WorkKind::staged_textures, triangles);
    const bool bilinear = effects.has(effect::bilinear);
    set(effect::textures, bilinear ? WorkKind::bilinear_texels : WorkKind::nearest_texels, fragments);
    set(effect::texture_alpha, WorkKind::texel_alphas, fragments);
    if (effects.has(effect::textures)) set(effect::lighting, WorkKind::lit_texels, fragments);
    set(effect::pixel_shading, WorkKind::lit_fragments, fragments);
    set(effect::mipmaps, WorkKind::runs_of_levels, rows + fragments / 16);
    set(effect::alpha_test, WorkKind::masked, fragments);
    set(effect::fog, WorkKind::fogged, fragments);
    set(effect::blending, WorkKind::blended, fragments);
    set(effect::dithered_colours, WorkKind::dithered, fragments);
  } else if (effects.has(effect::textures)) {
    const bool lit = effects.has(effect::lighting);
    work.kinds[lit ? WorkKind::lit_textured_triangles : WorkKind::textured_triangles] = triangles;
    work.kinds[lit ? WorkKind::lit_textured_fragments : WorkKind::textured_fragments] = fragments;
  }
  // The pass that only finds the strips of a meshlet does not light vertices; strips light those of half of the faces.
  const bool once = work.vertices == counts.vertices;
  const auto lit_vertices = static_cast<std::uint32_t>(once ? work.vertices : (work.vertices - counts.vertices) / 2);
  set(effect::lighting, WorkKind::lit_vertices, lit_vertices);
  set(effect::punctual_lights, WorkKind::lights_of_vertices, lit_vertices);
  set(effect::specular, WorkKind::shining_vertices, lit_vertices);
  set(effect::environment, WorkKind::mirroring_vertices, lit_vertices);
  // Counted in these scenes, of 100 edges: 32 to 57 are surveyed, 40 to 119 projected, 22 to 72 blended.
  const std::uint32_t edges = counts.edge_groups * std::uint32_t{kEdgesOfGroup};
  set(effect::edges, WorkKind::searched_edges, edges);
  set(effect::edges, WorkKind::surveyed_edges, edges / 2);
  set(effect::edges, WorkKind::projected_edges, edges);
  set(effect::edges, WorkKind::blended_edges, edges / 2);
  set(effect::edges, WorkKind::pixels_of_edges, 4 * edges);
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
  expect_kinds(work, counts, effects);
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
  const WorkCounts& kinds = work.kinds;
  const std::uint64_t plain = work.fragments - kinds[WorkKind::textured_fragments] -
                              kinds[WorkKind::lit_textured_fragments] - kinds[WorkKind::staged_fragments];
  std::uint64_t eighths = plain * kCostOfPixel + pixels * view.samples * kCostOfClearing;
  for (std::size_t kind = 0; kind < kWorkKinds; ++kind) eighths += std::uint64_t{kinds.of[kind]} * kCostOfWork[kind];
  std::uint64_t cost = work.vertices * kCostOfVertex + culled * kCostOfCulling + work.clipped * kCostOfClipped +
                       (work.covering - kinds[WorkKind::staged_triangles]) * kCostOfSetup + work.rows * kCostOfRow +
                       eighths / 8;
  if (effects.has(effect::skins)) cost += work.vertices * kCostOfSkin;
  const std::uint64_t meshlets = std::uint64_t{counts.meshlets} * plan.strips;  // in strips
  if (plan.mode == Mode::binned) {
    cost += culled * kCostOfBinning + work.covering * kCostOfBin + meshlets * kCostOfBatch;
    if (effects.has(effect::two_sided) || plan.strip_columns != view.width) cost += culled * kCostOfBinBoxes;
  } else {
    cost += meshlets * kCostOfMeshlet;
  }
  if (effects.has(effect::dithered_format)) cost += pixels * kCostOfMono / 8;
  if (view.samples != 1) cost += pixels * (view.samples == 2 ? kCostOfAveraging : kCostOfFour);
  return cost;
}

constexpr std::uint64_t estimated_cost(const SceneCounts& counts, Effects effects, const View& view, const Plan& plan) {
  if (plan.strips == 0) return UINT64_MAX;  // not a plan
  return estimated_cost(counts, effects, view, plan, detail::expected_work(counts, effects, view, plan));
}

}  // namespace zstrip
