// What a scene looks like, in double precision: every surface at its exact place, the nearest one visible,
// colours and texture coordinates correct in perspective. Shares no code with the renderer.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "accuracy/truth_stages.hpp"
#include "bake/effects_found.hpp"
#include "result.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// Nothing is visible there.
inline constexpr std::uint32_t kNoTriangle = 0xFFFFFFFF;

/// What one sample of the picture shows.
struct TruthSample {
  std::uint32_t triangle =
      kNoTriangle;             ///< number among the triangles of all instances, in drawing order; quadrics follow them
  double w = 0;                ///< distance along the viewing direction, world units
  float u = 0, v = 0;          ///< texels of its texture
  std::array<float, 3> rgb{};  ///< 0..255, not rounded
};

struct TruthPicture {
  std::uint32_t width = 0, height = 0;
  std::vector<TruthSample> samples;  ///< row by row
  std::vector<std::uint32_t> code;   ///< likewise, where Stages::depth is there; 0: nothing drawn
  const TruthSample& at(std::uint32_t x, std::uint32_t y) const { return samples[std::size_t{y} * width + x]; }
};

/// The mean of 16 samples of each pixel, 0..255, row by row.
using MeanPicture = std::vector<std::array<float, 3>>;

/// What a pixel shows and what it would show with an infinite number of samples, of which there are 16.
struct Truth {
  TruthPicture
      snapped;  ///< as `centres`, of corners rounded to 1/16 pixel: what a renderer with these can draw at best
  TruthPicture centres;                                  ///< at the middle of each pixel
  MeanPicture mean;                                      ///< what it would show
  std::vector<std::array<std::uint32_t, 16>> triangles;  ///< of the samples
};

/// ExitStatus::input for a scene of which no truth can be drawn: with materials that have a depth test or bias of their
/// own, whose result depends on the z-buffer's codes; with highlights, point or spot lights, alpha, bilinear texels,
/// palettes, mipmaps, environments, lines, outlines, shadows or CSG. The message names each of them, and
/// where it stands as far as `origins` has it.
Result<Done> check_truth(const Scene& scene, const Camera& camera, const Origins& origins);

/// Draws `scale` x `scale` samples a pixel, each in the middle of its square. Surfaces that are smooth are lit at each
/// sample by the interpolated normal, also if the material has light at vertices; flat ones by that of
/// their first vertex. `stages` are as coarse as the renderer's, where samples are its pixels. Quadrics have no
/// corners: of them only depth and colour can be coarse. Failures: those of check_truth.
Result<TruthPicture> draw_truth(const Scene& scene, const Camera& camera, const View& view, std::uint32_t scale,
                                const Stages& stages = {});

/// The mean alone. Failures: those of check_truth.
Result<MeanPicture> draw_mean(const Scene& scene, const Camera& camera, const View& view);

/// All of the above.
Result<Truth> find_truth(const Scene& scene, const Camera& camera, const View& view);

}  // namespace zstrip::sim
