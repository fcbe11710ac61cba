// A stage with the edges of its meshes: see edged_stage.hpp.
#include "render/edged_stage.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "import/edges.hpp"
#include "render/stage_over.hpp"
#include "zstrip/effects.hpp"

namespace zstrip::sim {
namespace {

class EdgedStage : public StageOver {
 public:
  EdgedStage(std::unique_ptr<Stage> stage, std::shared_ptr<const SceneEdges> edges)
      : StageOver(std::move(stage)), edges_(std::move(edges)) {}

  Result<Staging> place(std::uint32_t frame, std::uint32_t frames) override {
    Result<Staging> staging = under().place(frame, frames);
    if (staging) staging->scene.edges = edges_->sets;
    return staging;
  }
  std::unique_ptr<Stage> copy() const override { return std::make_unique<EdgedStage>(under().copy(), edges_); }

 private:
  std::shared_ptr<const SceneEdges> edges_;
};

/// Returns the effect of the scene that edges cannot be combined with; empty if there is none.
std::string_view rival_of_edges(Effects effects) {
  if (effects.has(effect::outlines)) return "outlines";
  if (effects.has(effect::skins)) return "skins that are moved while they are drawn";
  return effects.has(effect::csg) ? "CSG" : "";
}

}  // namespace

Result<std::unique_ptr<Stage>> with_edges(std::unique_ptr<Stage> stage, std::optional<bool> edges, const View& view) {
  const Result<Staging> staging = stage->place(0, 1);
  if (!staging) return staging.failure();
  if (edges.value_or(!staging->scene.edges.empty()) && view.samples != 1) {
    return Failure{ExitStatus::usage,
                   "smoothed edges and several samples exclude each other; use --no-edges, or --samples 1"};
  }
  if (!edges) return stage;
  auto found = std::make_shared<SceneEdges>();
  if (*edges) {
    const std::string_view rival = rival_of_edges(effects_of(staging->scene, staging->camera));
    if (!rival.empty()) {
      return Failure{ExitStatus::usage,
                     fmt::format("edges are not smoothed in a scene with {}; use --no-edges", rival)};
    }
    if (!staging->scene.edges.empty()) return stage;
    *found = find_edges(staging->scene, staging->levels);
  }
  return std::unique_ptr<Stage>(std::make_unique<EdgedStage>(std::move(stage), std::move(found)));
}

}  // namespace zstrip::sim
