// What a frame takes on a Cortex-M3, estimated from what it did on this machine.
#include "plan/estimate.hpp"

#include <algorithm>
#include <cmath>

namespace zstrip::sim {
namespace {

// Instructions, by least squares of relative errors over 144 frames of the workloads.
constexpr double kVertex = 100;
constexpr double kLighting = 27;    // a vertex
constexpr double kCulling = 58;     // a triangle, each time that its vertices are transformed
constexpr double kBinning = 63;     // a triangle, once
constexpr double kBin = 33;         // a triangle in a strip's list
constexpr double kSetUp = 56;       // a triangle in a strip
constexpr double kRow = 134;        // of such a triangle: their number grows as the root of its pixels
constexpr double kPixel = 1.9;      // of a triangle, beyond what its row takes
constexpr double kTexel = 18.2;     // a pixel with texels as they are
constexpr double kLitTexel = 40.1;  // a pixel with lit texels
constexpr double kClearing = 1.5;   // a pixel or sample
constexpr double kAveraging = 16;   // a pixel of several samples
constexpr double kMeshlet = 169;    // in each strip

double pixel_cost(Effects effects) {
  if (!effects.has(effect::textures)) return kPixel;
  return effects.has(effect::lighting) ? kLitTexel : kTexel;
}

}  // namespace

std::uint64_t estimated_instructions(const SceneCounts& counts, Effects effects, const Statistics& done,
                                     const View& view, const Plan& plan) {
  const double pixels = static_cast<double>(view.width) * view.height;
  const double covering = done.covering, fragments = done.fragments;
  // Triangles come with their vertices.
  const double culled = static_cast<double>(done.vertices) * counts.triangles / std::max(counts.vertices, 1U);
  double sum = done.vertices * kVertex + culled * kCulling + covering * kSetUp +
               std::sqrt(covering * fragments) * kRow + fragments * pixel_cost(effects) +
               pixels * view.samples * kClearing + static_cast<double>(counts.meshlets) * plan.strips * kMeshlet;
  if (effects.has(effect::lighting)) sum += done.vertices * kLighting;
  if (plan.mode == Mode::binned) sum += culled * kBinning + covering * kBin;
  if (view.samples != 1) sum += pixels * kAveraging;
  return static_cast<std::uint64_t>(sum);
}

}  // namespace zstrip::sim
