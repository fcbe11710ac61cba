// A stage with levels of detail: see levelled_stage.hpp.
#include "render/levelled_stage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "import/levels.hpp"
#include "import/quantise.hpp"
#include "render/model_animation.hpp"
#include "render/stage_over.hpp"

namespace zstrip::sim {
namespace {

struct LevelsOfStage {
  SceneLevels found;
  std::vector<DetailLevel> levels;
  std::vector<Mesh> coarser;  ///< they follow the scene's meshes
};

class LevelledStage : public StageOver {
 public:
  LevelledStage(std::unique_ptr<Stage> stage, std::shared_ptr<const LevelsOfStage> levels)
      : StageOver(std::move(stage)), levels_(std::move(levels)) {}

  Result<Staging> place(std::uint32_t frame, std::uint32_t frames) override {
    Result<Staging> staging = under().place(frame, frames);
    if (!staging) return staging;
    meshes_.assign(staging->scene.meshes.begin(), staging->scene.meshes.end());
    meshes_.insert(meshes_.end(), levels_->coarser.begin(), levels_->coarser.end());
    staging->scene.meshes = meshes_;
    staging->levels = levels_->levels;
    return staging;
  }
  std::unique_ptr<Stage> copy() const override { return std::make_unique<LevelledStage>(under().copy(), levels_); }

 private:
  std::shared_ptr<const LevelsOfStage> levels_;
  std::vector<Mesh> meshes_;
};

/// Returns the meshes whose vertices move, and the operands of CSG, which must stay solids.
std::vector<std::size_t> meshes_without_levels(const Stage& stage, const Scene& scene) {
  std::vector<std::size_t> meshes;
  if (const Model* const bent = stage.bent(); bent != nullptr) {
    for (const ModelSkin& skin : bent->skins) meshes.push_back(skin.mesh);
    for (const ModelMorph& morph : bent->morphs) meshes.push_back(morph.mesh);
  }
  if (const SceneBlob* const blob = stage.blob(); blob != nullptr) {
    for (const MovedMorph& morph : blob->morphs.meshes) meshes.push_back(morph.mesh);
  }
  for (const CsgOperand& operand : scene.csg) meshes.push_back(scene.instances[operand.instance].mesh);
  return meshes;
}

/// Returns the largest scale of each mesh's instances in all frames.
std::map<std::uint16_t, double> largest_scales(const Scene& scene, const Animation& animation) {
  std::map<std::uint16_t, double> scales;
  for (const Instance& instance : all_poses(animation, scene.instances)) {
    double& largest = scales[instance.mesh];
    for (std::size_t column = 0; column < 3; ++column) {
      const auto& m = instance.transform.m;
      largest =
          std::max(largest, std::hypot(from_fixed(m[0][column]), from_fixed(m[1][column]), from_fixed(m[2][column])));
    }
  }
  return scales;
}

/// Returns the distance from the middle of the mesh's box to its farthest vertex.
double radius_of(const Mesh& mesh) {
  constexpr double kStepsOfHalf = 32768;
  double radius = 0;
  for (const Position& p : mesh.positions) {
    radius = std::max(radius, std::hypot(from_fixed(mesh.half_extent.x) * p.x, from_fixed(mesh.half_extent.y) * p.y,
                                         from_fixed(mesh.half_extent.z) * p.z) /
                                  kStepsOfHalf);
  }
  return radius;
}

}  // namespace

Result<std::unique_ptr<Stage>> with_levels(std::unique_ptr<Stage> stage, const View& view) {
  const Result<Staging> staging = stage->place(0, 1);
  if (!staging) return staging.failure();
  if (!staging->levels.empty()) return stage;
  const Camera& camera = staging->camera;
  if (camera.projection == Projection::orthographic) {
    return Failure{ExitStatus::usage,
                   "--lod needs a camera with perspective: with --ortho nothing is small because it is "
                   "far away; use --triangles"};
  }
  Scene scene = staging->scene;
  auto made = std::make_shared<LevelsOfStage>();
  made->found = find_levels(scene, meshes_without_levels(*stage, scene));
  const std::map<std::uint16_t, double> scales = largest_scales(scene, stage->animation());
  const double pixels_of_unit = from_fixed(camera.focal) * view.height / 2;  // at a distance of 1
  std::vector<Mesh> meshes(scene.meshes.begin(), scene.meshes.end());
  for (const CoarserMesh& found : made->found.meshes) {
    const double scale = scales.at(found.mesh);
    const double distance = scale * (found.error * pixels_of_unit / kLevelPixels + radius_of(scene.meshes[found.mesh]));
    constexpr double kFarthestAsked = 16384;
    if (distance > kFarthestAsked || meshes.size() >= std::numeric_limits<std::uint16_t>::max()) continue;
    const DetailLevel level{found.mesh, static_cast<std::uint16_t>(meshes.size()), to_fixed(distance)};
    meshes.push_back(found.coarser);
    Scene tried = scene;
    tried.meshes = meshes;
    const bool grows =
        made->levels.empty() || made->levels.back().mesh != level.mesh || made->levels.back().distance < level.distance;
    if (grows && validate(std::span(&level, 1), tried)) {
      made->levels.push_back(level);
      made->coarser.push_back(found.coarser);
    } else {
      meshes.pop_back();
    }
  }
  return std::unique_ptr<Stage>(std::make_unique<LevelledStage>(std::move(stage), std::move(made)));
}

}  // namespace zstrip::sim
