// Chooses the skins, morph targets and clips that `zstrip bake` writes.
#include "cli/output_skins.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "bake/stage_skins.hpp"
#include "cli/print.hpp"
#include "visibility/methods.hpp"

namespace zstrip::sim {
namespace {

/// Returns the option because of which vertices cannot move as in a blob: skins while they are drawn, morph targets
/// before; empty if they can.
std::string_view skins_stand_still(const BakeArguments& arguments, Effects method, const BakedSkins& skins,
                                   const Scene& scene) {
  if (method.any(zstrip::method::orders)) return "--visibility";
  if (arguments.visible_sets) return "--visible-sets";
  const auto is_skin = [&skins](const auto& set) { return skins.find(set.mesh) != nullptr; };
  if (std::ranges::any_of(scene.edges, is_skin)) return "--edges";
  return std::ranges::any_of(scene.lines, is_skin) ? "lines" : "";
}

}  // namespace

std::vector<ClipEvent> events_of(const std::vector<ModelClip>& clips, const Stage& stage) {
  if (clips.empty()) return stage.events();
  std::vector<ClipEvent> events;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    for (ClipEvent event : clips[i].events) {
      event.clip = static_cast<std::uint16_t>(i);
      events.push_back(event);
    }
  }
  return events;
}

Result<OutputSkins> skins_of(BakeKind kind, const BakeArguments& arguments, Effects method, const Stage& stage,
                             const Scene& scene, bool warn) {
  if (is_source(kind)) return OutputSkins{skins_of(stage), {}};
  OutputSkins output;
  Result<std::vector<ModelClip>> clips = stage.clips();
  if (!clips) return clips.failure();
  const auto bends = [](const ModelClip& clip) { return !clip.joints.view().tracks.empty(); };
  const auto morphs = [](const ModelClip& clip) { return !clip.weights.view().tracks.empty(); };
  const Model* const model = stage.bent();
  if (warn && stage.blob() != nullptr && !stage.blob()->morphs.meshes.empty()) {
    print_warning("the morph targets of a baked scene stand still; bake the model itself");
  }
  if (model != nullptr && std::ranges::any_of(*clips, bends)) {
    output.skins = {model->skins, model->joints, model->rest, {}};
  }
  if (model != nullptr && std::ranges::any_of(*clips, morphs)) {
    output.skins.morphs = model->morphs;
    output.skins.weights = model->weights.size();
  }
  const std::string_view why =
      output.skins.move() ? skins_stand_still(arguments, method, output.skins, scene) : std::string_view();
  if (!why.empty()) {
    if (warn) {
      print_warning(
          fmt::format("with {} a blob has no skins and no morph targets: their meshes stand still as at frame 0; in a "
                      "header (-o FILE.hpp) they move",
                      why));
    }
    return OutputSkins{};
  }
  if (output.skins.move() || clips->size() > 1) output.clips = std::move(*clips);
  return output;
}

std::set<std::size_t> meshes_in_motion(const Staging& at_rest, const Animation& animation, const Turn& turn,
                                       const OutputSkins& output) {
  std::set<std::size_t> meshes;
  for (const ModelSkin& skin : output.skins.meshes) meshes.insert(skin.mesh);
  for (const ModelMorph& morph : output.skins.morphs) meshes.insert(morph.mesh);
  for (const DetailLevel& level : at_rest.levels) meshes.insert({level.mesh, level.coarser});
  const auto add = [&](const Track& track) { meshes.insert(at_rest.scene.instances[track.instance].mesh); };
  std::ranges::for_each(animation.tracks, add);
  for (const ModelClip& clip : output.clips) std::ranges::for_each(clip.instances.view().tracks, add);
  // If only some instances turn, they turn in the light; otherwise the camera goes around them all.
  if (turn.still_instances == 0) return meshes;
  for (const Instance& instance : at_rest.scene.instances.subspan(turn.still_instances)) meshes.insert(instance.mesh);
  return meshes;
}

}  // namespace zstrip::sim
