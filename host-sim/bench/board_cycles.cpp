// The costs of a Pico are a fit of relative errors, with a prior of some cycles an instruction of the estimate for a
// Cortex-M3, over 117 frames of 36 models in 120x120, 240x240 and 320x240 pixels, which `zstrip bench --board` counted.
// 98 of these frames differ by at most a tenth. A kind of work that only one model has is a guess for others. Triangles
// with stages and masked pixels, which only two grounds of 512 triangles have, half transparent and with holes, were
// fitted again, to three frames of each: these differ by at most 2.1 %.
#include "bench/board_cycles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace zstrip::sim {
namespace {

/// Cycles of a Pico for a kind of work.
struct KindCost {
  WorkKind kind;
  double cycles;
};
constexpr KindCost kPicoKinds[] = {{WorkKind::textured_triangles, 1886},
                                   {WorkKind::textured_fragments, 32.1},
                                   {WorkKind::lit_textured_triangles, 2366},
                                   {WorkKind::lit_textured_fragments, 157.7},
                                   {WorkKind::staged_triangles, 4480},
                                   {WorkKind::staged_textures, 5907},
                                   {WorkKind::spans, 190},
                                   {WorkKind::staged_fragments, 6.6},
                                   {WorkKind::nearest_texels, 170.5},
                                   {WorkKind::lit_texels, 74.8},
                                   {WorkKind::masked, 235},
                                   {WorkKind::blended, 126.3},
                                   {WorkKind::lit_vertices, 189},
                                   {WorkKind::mirroring_vertices, 262},
                                   {WorkKind::surveyed_edges, 2695},
                                   {WorkKind::projected_edges, 386.5},
                                   {WorkKind::blended_edges, 1072},
                                   {WorkKind::pixels_of_edges, 226}};
/// These are part of the costs above.
constexpr WorkKind kIncluded[] = {WorkKind::runs, WorkKind::texel_alphas};

constexpr double kFrame = 158'500;
constexpr double kVertex = 397, kSkinnedVertex = 1053, kCulled = 118, kMeshletInStrip = 723;
constexpr double kSetup = 646, kRow = 360, kTexturedRow = 1650, kLitTexturedRow = 888;
constexpr double kShadedFragment = 20.7, kFlatFragment = 2.2, kPixel = 5.5;
constexpr double kOther = 4;  // a cycle of an instruction of other work, an assumption

/// Returns the rows of triangles, which grow as the square root of their pixels.
double rows_of(double triangles, double fragments) { return std::sqrt(triangles * fragments); }

double cycles_of_pico(const SceneCounts& counts, Effects effects, const View& view, const Plan& plan,
                      const Work& work) {
  const auto of = [&work](WorkKind kind) { return static_cast<double>(work.kinds[kind]); };
  const auto vertices = static_cast<double>(work.vertices);
  double cycles = kFrame + vertices * kVertex + (effects.has(effect::skins) ? vertices * kSkinnedVertex : 0);
  cycles += counts.triangles * vertices / std::max(counts.vertices, 1U) * kCulled;
  cycles += static_cast<double>(counts.meshlets) * plan.strips * kMeshletInStrip;
  const double triangles = std::max(0.0, static_cast<double>(work.covering) - of(WorkKind::staged_triangles) -
                                             of(WorkKind::textured_triangles) - of(WorkKind::lit_textured_triangles));
  const double fragments = std::max(0.0, static_cast<double>(work.fragments) - of(WorkKind::staged_fragments) -
                                             of(WorkKind::textured_fragments) - of(WorkKind::lit_textured_fragments));
  cycles += triangles * kSetup + rows_of(triangles, fragments) * kRow;
  cycles += fragments * (effects.has(effect::gouraud) ? kShadedFragment : kFlatFragment);
  cycles += rows_of(of(WorkKind::textured_triangles), of(WorkKind::textured_fragments)) * kTexturedRow;
  cycles += rows_of(of(WorkKind::lit_textured_triangles), of(WorkKind::lit_textured_fragments)) * kLitTexturedRow;
  const double pixels = static_cast<double>(view.width) * view.height;
  cycles += pixels * view.samples * kPixel;
  if (view.samples != 1) {
    const std::uint64_t averaging = view.samples == 2 ? detail::kCostOfAveraging : detail::kCostOfFour;
    cycles += pixels * static_cast<double>(averaging) * kOther;
  }
  if (effects.has(effect::dithered_format)) cycles += pixels * static_cast<double>(detail::kCostOfMono) / 8 * kOther;
  cycles += static_cast<double>(work.clipped * detail::kCostOfClipped) * kOther;
  for (std::size_t i = 0; i < kWorkKinds; ++i) {
    const auto kind = static_cast<WorkKind>(i);
    const auto* const known = std::ranges::find(kPicoKinds, kind, &KindCost::kind);
    if (std::ranges::find(kIncluded, kind) != std::end(kIncluded)) continue;
    cycles += of(kind) * (known != std::end(kPicoKinds) ? known->cycles : detail::kCostOfWork[i] / 8.0 * kOther);
  }
  return cycles;
}

}  // namespace

std::optional<double> estimated_cycles(std::string_view board, const SceneCounts& counts, Effects effects,
                                       const View& view, const Plan& plan, const Work& work) {
  if (board != "pico" || plan.mode != Mode::streamed) return std::nullopt;
  return cycles_of_pico(counts, effects, view, plan, work);
}

}  // namespace zstrip::sim
