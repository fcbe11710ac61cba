// The picture of a scene in double precision: every surface at its exact place, the nearest one visible, colours and
// texture coordinates correct in perspective. Shares no code with the renderer.
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

/// No triangle is visible.
inline constexpr std::uint32_t kNoTriangle = 0xFFFFFFFF;

/// The data of one sample of the picture.
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
  std::vector<std::uint32_t> code;   ///< row by row, if Stages::depth is set; 0: nothing was drawn
  const TruthSample& at(std::uint32_t x, std::uint32_t y) const { return samples[std::size_t{y} * width + x]; }
};

/// The mean of 16 samples of each pixel, 0..255, row by row.
using MeanPicture = std::vector<std::array<float, 3>>;

/// The exact picture at the pixels' middles, and the mean of 16 samples of each pixel, in place of infinitely many.
struct Truth {
  TruthPicture
      snapped;  ///< as `centres`, with corners rounded to 1/16 pixel: the best result of a renderer with such corners
  TruthPicture centres;                                  ///< at the middle of each pixel
  MeanPicture mean;                                      ///< the mean of each pixel's samples
  std::vector<std::array<std::uint32_t, 16>> triangles;  ///< of the samples
};

/// Returns ExitStatus::input for a scene whose truth cannot be drawn: with a material that has its own depth test or
/// bias, whose result depends on the z-buffer's codes; with highlights, point or spot lights, alpha, bilinear texels,
/// palettes, mipmaps, environments, lines, outlines, shadows or CSG. The message names each of them, and its place if
/// `origins` has it.
Result<Done> check_truth(const Scene& scene, const Camera& camera, const Origins& origins);

/// Draws `scale` x `scale` samples a pixel, each in the middle of its square. Smooth surfaces are lit at each sample by
/// the interpolated normal, also if the material has light at vertices; flat ones by the normal of their first vertex.
/// `stages` have the renderer's precision, and samples are then its pixels. Quadrics have no corners: only their depth
/// and colour can be coarse. Failures: those of check_truth.
Result<TruthPicture> draw_truth(const Scene& scene, const Camera& camera, const View& view, std::uint32_t scale,
                                const Stages& stages = {});

/// Draws only the mean. Failures: those of check_truth.
Result<MeanPicture> draw_mean(const Scene& scene, const Camera& camera, const View& view);

/// Draws all parts of Truth.
Result<Truth> find_truth(const Scene& scene, const Camera& camera, const View& view);

}  // namespace zstrip::sim
