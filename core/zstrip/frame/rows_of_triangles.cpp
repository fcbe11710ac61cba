// Pipelines of what most scenes are: triangles, with and without light, colours and textures. Exact sets, because one
// that tests how a triangle gets its colours takes a fiftieth longer for ten thousand of them.
#include "zstrip/frame/make_rows.hpp"

namespace zstrip::detail {
namespace {

constexpr Effects kAllShades =
    effect::lighting | effect::vertex_colours | effect::gouraud | effect::textures | effect::bins;
/// Layers are seldom: one way to draw them is for all shades.
template <Effects shade>
constexpr PipelineRow shaded() {
  constexpr Effects kEffects = shade | effect::bins;
  return {kEffects, {&begin_frame<kEffects>, &draw_strip<kEffects>, &draw_over<kAllShades>}};
}

constexpr PipelineRow kRowsOfTriangles[] = {
    shaded<Effects{}>(),
    shaded<effect::lighting>(),
    shaded<effect::vertex_colours>(),
    shaded<effect::lighting | effect::vertex_colours>(),
    shaded<effect::lighting | effect::gouraud>(),
    shaded<effect::vertex_colours | effect::gouraud>(),
    shaded<effect::lighting | effect::vertex_colours | effect::gouraud>(),
    shaded<effect::textures>(),
    shaded<effect::textures | effect::lighting>(),
    shaded<effect::textures | effect::vertex_colours>(),
    shaded<effect::textures | effect::lighting | effect::vertex_colours>(),
    shaded<effect::textures | effect::lighting | effect::gouraud>(),
    shaded<effect::textures | effect::vertex_colours | effect::gouraud>(),
    shaded<effect::textures | effect::lighting | effect::vertex_colours | effect::gouraud>(),
    pipeline_row<effect::textures | effect::lighting | effect::gouraud | effect::skins | effect::bins>(),
    pipeline_row<kAllShades | effect::statistics>(),
    pipeline_row<kAllShades | effect::statistics | effect::orthographic>(),
};

}  // namespace

std::span<const PipelineRow> rows_of_triangles() { return kRowsOfTriangles; }

}  // namespace zstrip::detail
