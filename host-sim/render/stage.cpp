// The scene that is rendered: a built-in scene, a scene file, a model file or a baked scene, placed for each frame.
#include "render/stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <utility>

#include "compose/scene_file.hpp"
#include "import/lit_pixels.hpp"
#include "import/read_file.hpp"
#include "render/blob_stage.hpp"
#include "render/camera_stage.hpp"
#include "render/composed_stage.hpp"
#include "render/model_animation.hpp"
#include "render/skinned_meshes.hpp"
#include "text/text.hpp"
#include "zstrip/scene/validate.hpp"
#include "zstrip_scenes/baked_stage.hpp"
#include "zstrip_scenes/presentation.hpp"
#include "zstrip_scenes/scenes.hpp"

namespace zstrip::sim {
namespace {

/// Added to a file's own lights, which often leave the visible side dark.
constexpr DirectionalLight kFillLight{.x = scenes::kKeyLight[0].x,
                                      .y = scenes::kKeyLight[0].y,
                                      .z = scenes::kKeyLight[0].z,
                                      .colour = {112, 112, 112, 255}};

/// Checks a scene of the import or of the program. Such a scene is always valid; if not, the failure reports a bug.
Result<Done> check(const Scene& scene, const std::string& name) {
  const Status status = validate(scene);
  if (status) return Done{};
  return Failure{ExitStatus::internal, fmt::format("'{}' became a scene that the renderer refuses: {} (number {})",
                                                   name, message(status.error), status.needed)};
}

/// Completes a failure of an animation.
Failure fitted_failure(const Failure& failure, const NodeAnimation& animation, const std::string& file) {
  return {failure.status, fmt::format("'{}': the animation '{}' {}; choose another with --animation", file,
                                      animation.name, failure.message)};
}

Result<ModelClip> fit_clip(const Model& model, const NodeAnimation& animation, const std::string& file) {
  Result<FittedAnimation> instances = fit_model_animation(model, animation);
  if (!instances) return fitted_failure(instances.failure(), animation, file);
  Result<FittedAnimation> joints = fit_joint_animation(model, animation);
  if (!joints) return fitted_failure(joints.failure(), animation, file);
  Result<FittedWeights> weights = fit_weight_animation(model, animation);
  if (!weights) return fitted_failure(weights.failure(), animation, file);
  std::vector<ClipEvent> events = fit_events(animation.events, instances->view().duration);
  return ModelClip{animation.name, std::move(*instances), std::move(*joints), std::move(*weights), std::move(events)};
}

/// The animation that is shown, and whether it was chosen by its name.
struct ModelMotion {
  ModelClip shown;
  bool is_chosen = false;
};

/// Returns the file's animation of this name, or its first one.
Result<ModelMotion> motion_of(const Model& model, const std::optional<std::string>& name, const std::string& file) {
  const Result<const NodeAnimation*> chosen = find_animation(model, name);
  if (!chosen) return chosen.failure();
  if (*chosen == nullptr) return ModelMotion();
  Result<ModelClip> clip = fit_clip(model, **chosen, file);
  if (!clip) return clip.failure();
  return ModelMotion{std::move(*clip), name.has_value()};
}

std::vector<std::string> names_of_built_in() {
  std::vector<std::string> names;
  for (const scenes::BuiltIn& each : scenes::built_in()) names.emplace_back(each.name);
  return names;
}

class BuiltInStage : public Stage {
 public:
  BuiltInStage(const scenes::BuiltIn& built_in, const View& view) : built_in_(built_in), view_(view) {}

  Result<Done> set_camera(const CameraOptions& options) {
    if (options.placed()) {
      const Result<Camera> camera = place_camera(options, Units{}, radius_about_origin(built_in_.scene));
      if (!camera) return camera.failure();
      own_camera_ = *camera;
    }
    options_ = options;
    return Done{};
  }

  Result<Staging> place(std::uint32_t frame, std::uint32_t frames) override {
    const Result<Camera> at_rest = camera(frames);
    if (!at_rest) return at_rest.failure();
    scenes::stage(built_in_, staged_, frame, frames, view_);
    return Staging{staged_.scene, turn().what == Turning::camera ? scenes::turned(*at_rest, frame, frames) : *at_rest};
  }

  Result<Camera> camera(std::uint32_t frames) const override {
    if (own_camera_) return *own_camera_;
    scenes::Staged at_rest;
    scenes::stage(built_in_, at_rest, 0, frames, view_);
    return change_projection(at_rest.camera, options_);
  }

  /// With a camera from the options, the scene does not move if the motion is one around the scene's own camera.
  Turn turn() const override {
    if (built_in_.turns == scenes::Turns::model) return {.what = Turning::instances};
    return {.what = own_camera_ ? Turning::nothing : Turning::camera};
  }

  std::unique_ptr<Stage> copy() const override {
    auto stage = std::make_unique<BuiltInStage>(built_in_, view_);
    stage->own_camera_ = own_camera_;
    stage->options_ = options_;
    return stage;
  }

  const std::vector<std::string>& warnings() const override { return warnings_; }

 private:
  const scenes::BuiltIn& built_in_;
  View view_;
  scenes::Staged staged_;
  std::optional<Camera> own_camera_;  ///< used in place of the scene's camera
  CameraOptions options_;             ///< otherwise: the scene's camera with the field of view and projection of these
                                      ///< options
  std::vector<std::string> warnings_;
};

class ModelStage : public CameraStage {
 public:
  /// `file`: its name, for the origins.
  ModelStage(std::shared_ptr<const Model> model, std::shared_ptr<const ModelMotion> motion, std::string file,
             const DefaultLook& look)
      : model_(std::move(model)),
        motion_(std::move(motion)),
        skins_(*model_, motion_->shown.joints.view(), motion_->shown.weights.view(), file),
        instances_(model_->instances),
        lines_(model_->lines),
        lights_(model_->lights),
        file_(std::move(file)),
        look_(look) {
    const bool own_lights = !lights_.empty() || !model_->punctual_lights.empty();
    if (!own_lights) {
      lights_.push_back(look_.light);
    } else if (lights_.size() < kMaxLights) {
      lights_.push_back(kFillLight);
    }
    scene_ = {.meshes = model_->meshes,
              .materials = model_->materials,
              .textures = model_->textures,
              .instances = instances_,
              .lights = lights_,
              .ambient = own_lights ? scenes::kAmbient : look_.ambient,
              .background = look_.background,
              .finishes = model_->finishes,
              .punctual_lights = model_->punctual_lights,
              .lines = model_->lines};
  }
  ModelStage(const ModelStage&) = delete;
  ModelStage& operator=(const ModelStage&) = delete;

  const Scene& scene() const { return scene_; }

  Result<Camera> camera(std::uint32_t frames) const override {
    const double degrees = options().field_of_view.value_or(kDefaultFieldOfView);
    const std::vector<Instance> poses = all_poses(animation(), model_->instances);
    SkinnedMeshes skins(*model_, motion_->shown.joints.view(), motion_->shown.weights.view(), file_);
    const Result<std::span<const Mesh>> posed = skins.all_poses();
    if (!posed) return posed.failure();
    Scene whole = scene_;
    whole.instances = poses;
    whole.meshes = *posed;
    const double radius = radius_about_origin(whole);
    const FramingView framing{.aspect = static_cast<double>(view().width) / view().height,
                              .half_tangent = std::tan(degrees * std::numbers::pi / 360),
                              .orthographic = options().orthographic,
                              .whole_turn = frames > 1 && animation().tracks.empty() && !bends(),
                              .yaw = look_.yaw,
                              .filled = look_.filled};
    if (options().name) return named_camera(*options().name, radius);
    return options().placed() ? place_camera(options(), model_->units, radius)
                              : framed_camera(options(), frame_scene(whole, framing), radius);
  }

  Result<Staging> place(std::uint32_t frame, std::uint32_t frames) override {
    const Result<std::span<const Mesh>> meshes = skins_.at(frame, frames);
    if (!meshes) return meshes.failure();
    Scene at_rest = scene_;
    at_rest.instances = model_->instances;
    at_rest.meshes = *meshes;
    const scenes::BakedFrame staged = scenes::stage({at_rest, chosen_camera(), animation(), turn()}, frame, frames,
                                                    {.instances = instances_, .lines = lines_});
    return Staging{.scene = staged.scene,
                   .camera = staged.camera,
                   .version = bends() ? frame + 1 : 0,
                   .bent_vertices = skins_.vertices()};
  }

  std::unique_ptr<Stage> copy() const override {
    auto stage = std::make_unique<ModelStage>(model_, motion_, file_, look_);
    stage->take_camera(*this);
    return stage;
  }

  const std::vector<std::string>& warnings() const override { return model_->warnings; }
  Animation animation() const override { return motion_->shown.instances.view(); }
  bool bends() const override { return skins_.moves(); }
  Animation joint_animation() const override { return motion_->shown.joints.view(); }
  Result<std::vector<ModelClip>> clips() const override {
    std::vector<ModelClip> clips;
    for (const NodeAnimation& animation : model_->tree.animations) {
      if (motion_->is_chosen && animation.name != motion_->shown.name) continue;
      Result<ModelClip> clip = fit_clip(*model_, animation, file_);
      if (!clip) return clip.failure();
      const bool bends = !clip->joints.view().tracks.empty() && !model_->skins.empty();
      const bool morphs = !clip->weights.view().tracks.empty() && !model_->morphs.empty();
      if (bends || morphs || !clip->instances.view().tracks.empty()) clips.push_back(std::move(*clip));
      if (motion_->is_chosen) break;
    }
    return clips;
  }
  WeightAnimation weight_animation() const override { return motion_->shown.weights.view(); }
  std::vector<ClipEvent> events() const override { return motion_->shown.events; }
  Turn turn() const override { return bends() ? Turn{.what = Turning::nothing} : Turn{}; }
  Origins origins() const override {
    Origins origins{model_->material_names, std::vector<std::string>(model_->materials.size(), file_), {}, {}};
    for (const std::int32_t node : model_->nodes) {
      origins.instance_names.push_back(node == kNoNode ? "" : model_->tree.nodes[static_cast<std::size_t>(node)].name);
    }
    return origins;
  }
  const Model* model() const override { return model_.get(); }

 private:
  Result<Camera> named_camera(const std::string& name, double radius) const {
    const std::vector<SourceCamera>& cameras = model_->cameras;
    auto found = std::ranges::find(cameras, name, &SourceCamera::name);
    if (found == cameras.end() && !name.empty()) found = std::ranges::find(cameras, name, &SourceCamera::other_name);
    if (found != cameras.end()) return file_camera(*found, model_->units, radius);
    std::string names;
    for (const SourceCamera& source : cameras) names += fmt::format("{}'{}'", names.empty() ? "" : ", ", source.name);
    return Failure{ExitStatus::input,
                   fmt::format("there is no camera '{}' in the file; {}", name,
                               names.empty() ? "it has none, or is not glTF 2.0" : "it has " + names)};
  }

  std::shared_ptr<const Model> model_;
  std::shared_ptr<const ModelMotion> motion_;
  SkinnedMeshes skins_;
  std::vector<Instance> instances_;
  std::vector<LineSet> lines_;
  std::vector<DirectionalLight> lights_;
  std::string file_;
  DefaultLook look_;
  Scene scene_;
};

}  // namespace

std::uint32_t milliseconds_of(const Stage& stage) {
  constexpr std::uint32_t kTurn = 4000;
  for (const Animation& animation : {stage.animation(), stage.joint_animation()}) {
    if (!animation.tracks.empty()) return animation.duration;
  }
  if (const WeightAnimation weights = stage.weight_animation(); !weights.tracks.empty()) return weights.duration;
  return kTurn;
}

SceneKind kind_of_scene(const std::string& name) {
  if (scenes::find(name) != nullptr) return SceneKind::built_in;
  const std::string extension = lower(std::filesystem::path(name).extension().string());
  if (extension == ".zsc") return SceneKind::baked;
  return extension == ".toml" ? SceneKind::composed : SceneKind::model;
}

Result<std::unique_ptr<Stage>> open_stage(const std::string& name, const ModelOptions& model_options,
                                          const CameraOptions& options, const View& view, std::uint32_t frames) {
  if (const scenes::BuiltIn* built_in = scenes::find(name)) {
    if (const Result<Done> checked = check(built_in->scene, name); !checked) return checked.failure();
    auto stage = std::make_unique<BuiltInStage>(*built_in, view);
    if (const Result<Done> camera = stage->set_camera(options); !camera) return camera.failure();
    return std::unique_ptr<Stage>(std::move(stage));
  }
  // Other errors of a path are reported by the code that reads it.
  std::error_code ignored;
  if (std::filesystem::status(name, ignored).type() == std::filesystem::file_type::not_found) {
    if (const std::string advice = advice_on_address(name); !advice.empty()) {
      return Failure{ExitStatus::input, fmt::format("there is no file '{}'{}", name, advice)};
    }
    const std::string near = std::filesystem::path(name).has_extension() ? "" : nearest(name, names_of_built_in());
    return Failure{ExitStatus::input,
                   fmt::format("there is no file '{}', and no built-in scene of that name; {}'zstrip scenes' lists the "
                               "built-in ones",
                               name, near.empty() ? "" : fmt::format("did you mean '{}'? ", near))};
  }
  if (kind_of_scene(name) == SceneKind::baked) {
    return open_blob_stage(name, options, view, frames, model_options.animation);
  }
  if (kind_of_scene(name) == SceneKind::composed) return open_composed_stage(name, options, view, frames);
  Result<Model> model = import_model(name, model_options.up, Texcoords::of_textures, BackFaces::lit_alike,
                                     {model_options.highlights, model_options.style}, model_options.reduction);
  if (!model) return model.failure();
  light_at_pixels(*model);
  Result<ModelMotion> motion = motion_of(*model, model_options.animation, name);
  if (!motion) return motion.failure();
  auto stage = std::make_unique<ModelStage>(std::make_shared<const Model>(std::move(*model)),
                                            std::make_shared<const ModelMotion>(std::move(*motion)),
                                            std::filesystem::path(name).filename().string(), model_options.look);
  if (const Result<Done> checked = check(stage->scene(), name); !checked) return checked.failure();
  if (const Result<Done> camera = stage->set_camera(options, view, frames); !camera) return camera.failure();
  return std::unique_ptr<Stage>(std::move(stage));
}

}  // namespace zstrip::sim
