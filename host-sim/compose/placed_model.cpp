// A model of a scene file: its parts in the coordinates that the scene file places.
#include "compose/placed_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "import/quantise.hpp"
#include "motion/clip_sequence.hpp"
#include "motion/fitted_animation.hpp"
#include "render/model_animation.hpp"
#include "zstrip_scenes/scenes.hpp"

namespace zstrip::sim {
Affine PlacedModel::placed(const ModelPart& part, double seconds) const {
  if (!moves(part)) return part.to_file;
  if (seconds > animation->duration) seconds = std::fmod(seconds, animation->duration);
  return moved_from_rest(*model, *animation, part.node, seconds) * part.to_file;
}

bool PlacedModel::bends() const {
  if (animation == nullptr) return false;
  const auto is_moved = [this](const ModelJoint& joint) {
    return joint.node != kNoNode &&
           std::ranges::find(animation->moved, joint.node, &NodeCurves::node) != animation->moved.end();
  };
  const bool moves_joints = std::ranges::any_of(model->joint_nodes, is_moved);
  return std::ranges::any_of(parts, [&](const ModelPart& part) {
    return (part.skin != nullptr && moves_joints) || (part.morph != nullptr && !animation->weights.empty());
  });
}

Result<Done> join_clips(const FileModel& entry, Model& model, const std::filesystem::path& scene) {
  if (entry.clips.empty()) return Done{};
  std::vector<ClipStep> steps;
  double seconds = 0;
  for (const FileClip& clip : entry.clips) {
    const Result<const NodeAnimation*> found = find_animation(model, clip.animation);
    if (!found) return at_line(scene, clip.line, "[[model.clip]]: " + found.failure().message);
    ClipStep& step = steps.emplace_back();
    step.clip = *found;
    step.seconds = clip.seconds > 0 ? clip.seconds : step.clip->duration;
    step.fade = clip.fade;
    if (step.fade > step.seconds) {
      return at_line(scene, clip.line,
                     fmt::format("[[model.clip]]: its fade of {} s must end within its {} s", step.fade, step.seconds));
    }
    seconds += step.seconds;
  }
  if (seconds > kMaxAnimation) {
    return at_line(scene, entry.clips.back().line,
                   fmt::format("[[model.clip]]: all clips together must be {} s at most", kMaxAnimation));
  }
  NodeAnimation joined = joined_clips(model.tree, steps);
  model.tree.animations.push_back(std::move(joined));
  return Done{};
}

Result<PlacedModel> place_model(const FileModel& entry, const Model& model, const std::filesystem::path& scene) {
  const Result<const NodeAnimation*> animation = entry.clips.empty()
                                                     ? find_animation(model, entry.animation)
                                                     : Result<const NodeAnimation*>(&model.tree.animations.back());
  if (!animation) return at_line(scene, entry.animation_line, animation.failure().message);
  PlacedModel placed{.parts = {},
                     .materials = model.materials,
                     .textures = model.textures,
                     .finishes = model.finishes,
                     .material_names = model.material_names,
                     .model = &model,
                     .animation = *animation};
  const double size = 1 / model.units.scale;
  const Affine to_file = translation(model.units.origin) * scaling({size, size, size});
  for (std::size_t i = 0; i < model.instances.size(); ++i) {
    const Instance& instance = model.instances[i];
    const auto skin = std::ranges::find(model.skins, std::size_t{instance.mesh}, &ModelSkin::mesh);
    placed.parts.push_back({.mesh = model.meshes[instance.mesh],
                            .material = instance.material,
                            .to_file = to_file,
                            .node = model.nodes[i],
                            .skin = skin == model.skins.end() ? nullptr : &*skin,
                            .morph = model.morph_of(instance.mesh)});
  }
  for (const LineSet& set : model.lines) {
    placed.lines.push_back({{model.meshes[set.mesh], set.material, to_file, kNoNode}, set.segments});
  }
  return placed;
}

Result<PlacedModel> place_built_in(const FileModel& entry, const std::filesystem::path& scene) {
  const scenes::BuiltIn* const found = scenes::find(entry.built_in);
  if (found == nullptr) {
    std::vector<std::string> names;
    std::string all;
    for (const scenes::BuiltIn& each : scenes::built_in()) {
      names.emplace_back(each.name);
      all += fmt::format("{}{}", all.empty() ? "" : ", ", each.name);
    }
    const std::string near = nearest(entry.built_in, names);
    return at_line(scene, entry.file_line,
                   fmt::format("there is no built-in scene '{}'; {}", entry.built_in,
                               near.empty() ? "there are " + all : fmt::format("did you mean '{}'?", near)));
  }
  PlacedModel placed{.parts = {},
                     .materials = found->scene.materials,
                     .textures = found->scene.textures,
                     .finishes = found->scene.finishes,
                     .material_names = std::vector<std::string>(found->scene.materials.size())};
  for (const Instance& instance : found->scene.instances) {
    placed.parts.push_back(
        {found->scene.meshes[instance.mesh], instance.material, to_affine(instance.transform), kNoNode});
  }
  return placed;
}

}  // namespace zstrip::sim
