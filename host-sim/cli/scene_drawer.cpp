// Draws the frames of a scene with the options, on one thread.
#include "cli/scene_drawer.hpp"

#include <fmt/format.h>

#include <utility>

#include "cli/print.hpp"
#include "render/edged_stage.hpp"
#include "render/levelled_stage.hpp"
#include "visibility/drawing.hpp"
#include "visibility/methods.hpp"
#include "visibility/tree_stage.hpp"
#include "zstrip/frame/pipeline.hpp"

namespace zstrip::sim {
namespace {

Result<std::unique_ptr<SimulatedPanel>> start_panel(const PanelRequest& request) {
  std::unique_ptr<SimulatedPanel> panel = open_panel(request);
  if (const hal::Error error = panel->start(); error != hal::Error::none) {
    return Failure{ExitStatus::internal, fmt::format("the panel does not start: {}", hal::message(error))};
  }
  return panel;
}

/// Looks for the pipeline of a frame before anything is printed: the command without it is replaced by zstrip-any.
void find_pipeline(const Staging& staging, const Drawing& drawing) {
  const Effects counts = drawing.visibility.show == Show::overdraw ? method::culling : Effects{};
  pipeline_for(effects_of(staging.scene, staging.camera) | effects_of(drawing.view) | drawing.effects() |
               drawing.visibility.method | counts | effect::bins);
}

}  // namespace

Result<std::unique_ptr<Stage>> open_scene(const std::string& scene, const Drawing& drawing, std::uint32_t frames) {
  Result<std::unique_ptr<Stage>> stage = open_stage(scene, drawing.model, drawing.camera, drawing.view, frames);
  const bool shows_picture = shows_the_picture(drawing.visibility.show);
  if (stage) {
    const Result<Staging> staging = (*stage)->place(0, frames);
    if (staging) find_pipeline(*staging, drawing);
    if (staging && !shows_picture && (drawing.edges.value_or(false) || !staging->scene.edges.empty())) {
      print_warning("--show shows pixels as they were drawn: edges are not smoothed");
    }
  }
  if (stage && drawing.lod) stage = with_levels(std::move(*stage), drawing.view);
  if (stage) stage = with_edges(std::move(*stage), shows_picture ? drawing.edges : false, drawing.view);
  if (!stage) return stage;
  for (const std::string& warning : (*stage)->warnings()) print_warning(warning);
  // Show::error compares with the scene itself, without the tree.
  if (frames > 1 && drawing.visibility.method.has(method::bsp) && drawing.visibility.show != Show::error) {
    stage = with_tree(std::move(*stage), frames);
  }
  return stage;
}

SceneDrawer::SceneDrawer(const Drawing& drawing, std::unique_ptr<Stage> stage, const VisibleSetFile* sets,
                         unsigned strip_threads)
    : drawing_(&drawing),
      stage_(std::move(stage)),
      sets_(sets),
      renderer_(drawing.view, drawing.budget, drawing.effects(), strip_threads) {
  renderer_.set_ram_limit(drawing.ram_limit);
}

Result<SceneDrawer> SceneDrawer::open(const Drawing& drawing, std::unique_ptr<Stage> stage, const VisibleSetFile* sets,
                                      unsigned strip_threads) {
  SceneDrawer drawer(drawing, std::move(stage), sets, strip_threads);
  if (drawing.panel) {
    Result<std::unique_ptr<SimulatedPanel>> panel = start_panel(*drawing.panel);
    if (!panel) return panel.failure();
    drawer.panel_ = std::move(*panel);
    drawer.renderer_.show_on(*drawer.panel_, row_step(*drawing.panel));
  }
  return drawer;
}

Result<DrawnFrame> SceneDrawer::draw(const Staging& placed, Show show) {
  Staging staging = placed;
  if (show == Show::accuracy) staging.scene.overlay = nullptr;
  const VisibilityRequest& request = drawing_->visibility;
  const Result<Done> checked = check_visibility(
      effects_of(staging.scene, staging.camera) | effects_of(drawing_->view) | drawing_->effects() | request.method,
      drawing_->depth_given);
  if (!checked) return checked.failure();
  VisibilityOptions visibility = request.options;
  if (sets_ != nullptr) {
    const auto visible = sets_->at(staging.scene, staging.camera, stage_->animation());
    if (!visible) return visible.failure();
    visibility.potentially_visible = *visible;
  }
  renderer_.set_visibility(request.method, visibility, request.temporal);
  const auto bus_use = [this] { return panel_ ? BusUse{panel_->bytes(), panel_->busy().count()} : BusUse{}; };
  const BusUse before = bus_use();
  const Result<FrameReport> report = renderer_.render(staging);
  if (!report) return report.failure();
  const BusUse after = bus_use();
  DrawnFrame drawn{*report,
                   {after.bytes - before.bytes, after.nanoseconds - before.nanoseconds},
                   drawing_->view,
                   renderer_.pixels(),
                   std::nullopt};
  if (show == Show::colour) return drawn;
  drawn.view = View{drawing_->view.width, drawing_->view.height};
  if (show == Show::accuracy) {
    Result<HeatMap> heat = draw_heat_map(staging, stage_->origins(), drawing_->view, renderer_.pixels());
    if (!heat) return heat.failure();
    drawn.heat = std::move(*heat);
    drawn.pixels = std::as_bytes(std::span(drawn.heat->pixels));
    drawn.report.crc32 = checksum(drawn.pixels);
    return drawn;
  }
  // They show the whole picture in one strip, unless a limit is given.
  const Budget shown_budget = drawing_->ram_limit == RamLimit::usual ? Budget{} : drawing_->budget;
  Result<ShownFrame> shown =
      draw_shown(staging, {drawing_->view, shown_budget, drawing_->effects() | request.method, visibility}, show);
  if (!shown) return shown.failure();
  drawn.shown = std::move(*shown);
  drawn.pixels = std::as_bytes(std::span(drawn.shown->pixels));
  drawn.report.crc32 = checksum(drawn.pixels);
  return drawn;
}

Result<std::vector<std::uint8_t>> SceneDrawer::encoded(ImageType type, const DrawnFrame& drawn) const {
  if (!panel_ || drawn.shown || drawn.heat) return encode(type, drawn.view, drawn.pixels);
  if (const std::string dark = panel_->model().darkness(); !dark.empty()) {
    return Failure{ExitStatus::internal, "the panel shows nothing: " + dark};
  }
  return encode(type, panel_->model().seen());
}

}  // namespace zstrip::sim
