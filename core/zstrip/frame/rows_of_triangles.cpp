// Pipelines of most scenes: triangles, with and without light, colours and textures. The sets are exact, because a
// pipeline that tests how a triangle gets its colours takes 2 % longer for ten thousand triangles.
#include "zstrip/frame/make_rows.hpp"

namespace zstrip::detail {
namespace {

constexpr Effects kAllShades =
    effect::lighting | effect::vertex_colours | effect::gouraud | effect::textures | effect::bins;
/// draw_over is rare, so that one function with all shades serves all rows.
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
