// Three pipelines: a small one for most models, and one with all effects for each projection.
#include "pico/baked_pipelines.hpp"

#include "zstrip/frame/make_rows.hpp"

namespace zstrip::board {
namespace {

constexpr Effects kTriangles =
    effect::lighting | effect::vertex_colours | effect::gouraud | effect::textures | effect::bins;
constexpr Effects kAnything = without(detail::kEverything, effect::statistics);

/// draw_over is not used.
template <Effects effects>
constexpr detail::PipelineRow row() {
  return {effects, {&detail::begin_frame<effects>, &detail::draw_strip<effects>, nullptr}};
}

constexpr detail::PipelineRow kRows[] = {row<kTriangles>(), row<kAnything>(), row<kAnything | effect::orthographic>()};

}  // namespace

DrawnWith drawn_with_baked(Effects called_for) {
  Effects wanted = without_shades(called_for);
  // Without perspective, or without textures, these effects change no pixel.
  if (wanted.has(effect::orthographic) || !wanted.has(effect::textures)) {
    wanted = without(wanted, effect::perspective_runs);
  }
  for (const detail::PipelineRow& row : kRows) {
    if (detail::draws(row.effects, wanted)) return {called_for | effect::bins, row.pipeline};
  }
  return {kAnything, kRows[1].pipeline};
}

}  // namespace zstrip::board
