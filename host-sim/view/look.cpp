// Pictures of a scene other than its colours: wireframe, depth, overdraw.
#include "view/look.hpp"

#include "render/render_frame.hpp"
#include "view/wireframe.hpp"
#include "visibility/show.hpp"

namespace zstrip::sim {
namespace {

LookPicture copied(const View& view, std::span<const std::byte> pixels) {
  return {view, std::vector<std::byte>(pixels.begin(), pixels.end())};
}

}  // namespace

const char* name_of(Look look) {
  switch (look) {
    case Look::colour: return "colours";
    case Look::wireframe: return "wireframe";
    case Look::depth: return "depth";
    case Look::overdraw: return "overdraw";
    case Look::accuracy: return "accuracy";
  }
  return "";
}

Result<LookPicture> draw_look(const Staging& staging, Look look, const View& view) {
  const View plain{view.width, view.height};
  if (look == Look::wireframe) {
    Wireframe wireframe;
    FrameRenderer renderer(plain, {});
    const Result<FrameReport> report = renderer.render(wireframe.of(staging));
    if (!report) return report.failure();
    return copied(plain, renderer.pixels());
  }
  Staging without_edges = staging;
  without_edges.scene.edges = {};
  const Result<ShownFrame> shown =
      draw_shown(without_edges, {.view = plain, .budget = {}, .effects = {}, .options = {}},
                 look == Look::depth ? Show::depth : Show::overdraw);
  if (!shown) return shown.failure();
  return copied(plain, std::as_bytes(std::span(shown->pixels)));
}

}  // namespace zstrip::sim
