// A stage for a scene file (.toml).
#include "render/composed_stage.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "compose/composed_scene.hpp"
#include "import/quantise.hpp"
#include "render/camera_stage.hpp"
#include "render/model_animation.hpp"
#include "render/skinned_meshes.hpp"
#include "zstrip_scenes/baked_stage.hpp"

namespace zstrip::sim {
namespace {

double length(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

/// Returns the unit vector of a vector that is not zero.
Vector unit(const Vector& v) { return {v[0] / length(v), v[1] / length(v), v[2] / length(v)}; }

/// Returns the vector to the point that the camera looks at, for a camera at an `eye`.
Vector ahead_of(const FileCamera& from) {
  Vector ahead{};
  for (std::size_t i = 0; i < 3; ++i) ahead[i] = from.look_at[i] - (*from.eye)[i];
  return ahead;
}

/// Returns the distance to the point that the camera looks at.
double distance_of(const FileCamera& from) { return from.radius ? *from.radius : length(ahead_of(from)); }

/// Converts the values of [camera], in the file's units.
Result<Camera> camera_of(const FileCamera& from, const Units& units, double radius) {
  const double degrees = from.field_of_view.value_or(kDefaultFieldOfView);
  if (from.radius) {
    return place_camera({.orbit = Orbit{*from.radius, from.phi, from.theta},
                         .look_at = from.look_at,
                         .field_of_view = degrees,
                         .orthographic = from.orthographic},
                        units, radius);
  }
  const Vector ahead = ahead_of(from);
  const double distance = length(ahead);
  return file_camera({.name = "of the scene",
                      .eye = *from.eye,
                      .towards = unit(ahead),
                      .up = unit(from.up),
                      .orthographic = from.orthographic,
                      .field_of_view = degrees,
                      .half_height = distance * std::tan(degrees * std::numbers::pi / 360)},
                     units, radius);
}

/// Converts a length of the file to 16.16; returns nullopt if it is out of range.
std::optional<Fixed> scaled(double length, double scale) {
  const double fixed = length * scale * kFixedOne;
  if (!(fixed >= 1 && fixed <= 0x7FFFFFFF)) return std::nullopt;
  return static_cast<Fixed>(std::llround(fixed));
}

/// Sets the planes of the file, for any position of the camera.
Result<Done> set_planes(const SceneFile& file, const Units& units, Camera& camera) {
  const auto set = [&](const std::optional<double>& length, Fixed& to) {
    if (!length) return true;
    const std::optional<Fixed> fixed = scaled(*length, units.scale);
    if (fixed) to = *fixed;
    return fixed.has_value();
  };
  if (!set(file.camera->near_plane, camera.near_plane) || !set(file.camera->far_plane, camera.far_plane) ||
      camera.near_plane >= camera.far_plane) {
    return at_line(file.path, file.camera->line, "[camera]: 'near' or 'far' is too large or too small for this scene");
  }
  return Done{};
}

Result<Camera> finished_camera(const SceneFile& file, const Units& units, double radius) {
  const FileCamera& from = *file.camera;
  Result<Camera> camera = camera_of(from, units, radius);
  if (!camera) {
    return at_line(file.path, from.line,
                   "[camera] is too far away for this scene, or too near to the point that it looks at");
  }
  if (from.half_height) {
    const std::optional<Fixed> focal = scaled(1 / *from.half_height, 1 / units.scale);
    if (!focal) {
      return at_line(file.path, from.line, "[camera]: 'half_height' is too large or too small for this scene");
    }
    camera->focal = *focal;
  }
  if (const Result<Done> set = set_planes(file, units, *camera); !set) return set.failure();
  return camera;
}

class ComposedStage : public CameraStage {
 public:
  ComposedStage(std::shared_ptr<const SceneFile> file, std::shared_ptr<const ComposedScene> composed)
      : file_(std::move(file)),
        composed_(std::move(composed)),
        instances_(composed_->instances),
        skins_(composed_->bent, joint_animation(), weight_animation(), file_->path.filename().string()) {}
  ComposedStage(const ComposedStage&) = delete;
  ComposedStage& operator=(const ComposedStage&) = delete;

  Result<Camera> camera(std::uint32_t frames) const override {
    Result<Camera> camera = choose_camera(frames);
    // A fixed range, because depths of the two layers are compared.
    if (camera) camera->fixed_depth_range = composed_->static_instances > 0;
    return camera;
  }

  Result<Staging> place(std::uint32_t frame, std::uint32_t frames) override {
    Scene at_rest = composed_->scene();
    if (bends()) {
      const Result<std::span<const Mesh>> meshes = skins_.at(frame, frames);
      if (!meshes) return meshes.failure();
      at_rest.meshes = *meshes;
    }
    const scenes::BakedFrame staged =
        scenes::stage({at_rest, chosen_camera(), animation(), turn()}, frame, frames, {.instances = instances_});
    return Staging{.scene = staged.scene,
                   .camera = staged.camera,
                   .version = bends() ? frame + 1 : 0,
                   .bent_vertices = skins_.vertices()};
  }

  std::unique_ptr<Stage> copy() const override {
    auto stage = std::make_unique<ComposedStage>(file_, composed_);
    stage->take_camera(*this);
    return stage;
  }

  const std::vector<std::string>& warnings() const override { return composed_->warnings; }
  Animation animation() const override { return composed_->animation.view(); }
  bool bends() const override { return skins_.moves(); }
  const Model* bent() const override { return bends() ? &composed_->bent : nullptr; }
  Animation joint_animation() const override { return composed_->joint_animation.view(); }
  WeightAnimation weight_animation() const override { return composed_->weight_animation.view(); }
  /// If something bends, the one clip that moves joints, weights and instances.
  Result<std::vector<ModelClip>> clips() const override {
    std::vector<ModelClip> clips;
    if (bends()) {
      clips.push_back({{}, composed_->animation, composed_->joint_animation, composed_->weight_animation, events()});
    }
    return clips;
  }
  /// The file's limits hold for the file's camera.
  OrbitLimits orbit_limits() const override {
    if (!file_->camera || options().placed()) return {};
    OrbitLimits limits = file_->camera->orbit;
    limits.target = composed_->units.scale * distance_of(*file_->camera);
    return limits;
  }
  std::vector<ClipEvent> events() const override {
    return fit_events(file_->events,
                      std::max({animation().duration, joint_animation().duration, weight_animation().duration}));
  }
  /// The number of instances fits in 16 bits.
  Turn turn() const override {
    return {bends() ? Turning::nothing : Turning::instances, static_cast<std::uint16_t>(composed_->static_instances)};
  }
  Origins origins() const override {
    const bool own_projection = file_->camera && !options().placed() && !options().orthographic;
    return {composed_->material_names,
            composed_->material_origins,
            own_projection ? origin_of(file_->path, file_->camera->projection_line) : std::string(),
            composed_->fog_origin,
            composed_->shadow_origin,
            composed_->csg_origin,
            composed_->instance_names};
  }

 private:
  Result<Camera> choose_camera(std::uint32_t frames) const {
    const std::vector<Instance> poses = all_poses(animation(), composed_->instances);
    Scene whole = composed_->scene();
    whole.instances = poses;
    SkinnedMeshes skins(composed_->bent, joint_animation(), weight_animation(), file_->path.filename().string());
    if (bends()) {
      const Result<std::span<const Mesh>> posed = skins.all_poses();
      if (!posed) return posed.failure();
      whole.meshes = *posed;
    }
    const double radius = radius_about_origin(whole);
    if (options().placed()) {
      Result<Camera> camera = place_camera(options(), composed_->units, radius);
      if (camera && file_->camera) {
        const Result<Done> set = set_planes(*file_, composed_->units, *camera);
        if (!set) return set.failure();
      }
      return camera;
    }
    if (file_->camera) {
      const Result<Camera> camera = finished_camera(*file_, composed_->units, radius);
      if (!camera) return camera.failure();
      return change_projection(*camera, options());
    }
    const double degrees = options().field_of_view.value_or(kDefaultFieldOfView);
    return framed_camera(options(),
                         frame_scene(whole, {.aspect = static_cast<double>(view().width) / view().height,
                                             .half_tangent = std::tan(degrees * std::numbers::pi / 360),
                                             .orthographic = options().orthographic,
                                             .whole_turn = frames > 1 && animation().tracks.empty() && !bends()}),
                         radius);
  }

  std::shared_ptr<const SceneFile> file_;
  std::shared_ptr<const ComposedScene> composed_;
  std::vector<Instance> instances_;
  SkinnedMeshes skins_;
};

}  // namespace

Result<std::unique_ptr<Stage>> open_composed_stage(const std::string& path, const CameraOptions& options,
                                                   const View& view, std::uint32_t frames) {
  const Result<SceneFile> file = read_scene_file(path);
  if (!file) return file.failure();
  Result<std::unique_ptr<const ComposedScene>> composed = compose(*file);
  if (!composed) return composed.failure();
  auto stage = std::make_unique<ComposedStage>(std::make_shared<const SceneFile>(*file),
                                               std::shared_ptr<const ComposedScene>(std::move(*composed)));
  if (const Result<Done> camera = stage->set_camera(options, view, frames); !camera) return camera.failure();
  return std::unique_ptr<Stage>(std::move(stage));
}

}  // namespace zstrip::sim
