// Poses, their truth, and the results of settings for them.
#include "accuracy/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <utility>

#include "accuracy/board_cost.hpp"
#include "accuracy/observation.hpp"
#include "accuracy/variant.hpp"
#include "bake/scene_blob.hpp"
#include "zstrip/plan.hpp"

namespace zstrip::sim {
namespace {

constexpr std::uint32_t kTurn = 720;  // frames of a full rotation: adjacent ones are half a degree apart
constexpr int kRounds = 5;

}  // namespace

std::string scene_name(const AccuracyRequest& request) { return std::filesystem::path(request.scene).stem().string(); }

double time_of(const AccuracyPoint& point) {
  return point.cost.instructions ? static_cast<double>(*point.cost.instructions) : point.cost.nanoseconds;
}

struct AccuracyScene::Poses {
  std::vector<std::unique_ptr<Stage>> stages;  ///< two for each pose, slightly apart
  std::vector<Staging> staged;
  std::vector<Truth> truths;

  /// Former results of settings without strips, which change no pixel.
  struct Found {
    Errors errors;
    std::optional<AccuracyPictures> pictures;
  };
  std::map<Settings, Found> found;
  std::mutex mutex;  ///< protects `found`
};

AccuracyScene::AccuracyScene(AccuracyRequest request, std::shared_ptr<Poses> poses)
    : request_(std::move(request)), poses_(std::move(poses)) {}

Result<std::unique_ptr<AccuracyScene>> AccuracyScene::open(const AccuracyRequest& request) {
  Result<std::unique_ptr<Stage>> stage = open_stage(request.scene, {.up = request.up}, {}, request.view, kTurn);
  if (!stage) return stage.failure();
  auto poses = std::make_shared<Poses>();
  for (std::uint32_t pose = 0; pose < request.frames; ++pose) {
    for (std::uint32_t next = 0; next < 2; ++next) {
      poses->stages.push_back((*stage)->copy());
      Result<Staging> staged = poses->stages.back()->place(pose * (kTurn / request.frames) + next, kTurn);
      if (!staged) return staged.failure();
      staged->scene.edges = {};  // the settings select anti-aliasing
      staged->scene.overlay = nullptr;
      const Result<Done> checked = check_truth(staged->scene, staged->camera, (*stage)->origins());
      if (!checked) return checked.failure();
      Result<Truth> truth = find_truth(staged->scene, staged->camera, request.view);
      if (!truth) return truth.failure();
      poses->staged.push_back(*staged);
      poses->truths.push_back(std::move(*truth));
    }
  }
  return std::unique_ptr<AccuracyScene>(new AccuracyScene(request, std::move(poses)));
}

AccuracyScene AccuracyScene::on(std::string_view target) const {
  AccuracyRequest request = request_;
  request.target = target;
  return {std::move(request), poses_};
}

const Staging& AccuracyScene::first() const { return poses_->staged[0]; }
const std::vector<std::array<float, 3>>& AccuracyScene::true_picture() const { return poses_->truths[0].mean; }

std::span<const Staging> AccuracyScene::staged() const { return poses_->staged; }
std::span<const Truth> AccuracyScene::truths() const { return poses_->truths; }

Effects AccuracyScene::effects() const { return effects_of(first().scene, first().camera); }

Effects AccuracyScene::effects_with(const Settings& settings) const {
  Settings shading;
  shading[Knob::shading] = settings[Knob::shading];
  const SceneVariant variant(first().scene, shading);
  const Staging shaded = variant.apply(first());
  // Includes all shades, because settings change how triangles are drawn.
  return without_shades(effects_of(shaded.scene, shaded.camera)) | extra_effects(settings);
}

std::vector<Knob> AccuracyScene::knobs() const {
  const Scene& scene = first().scene;
  const bool textured = std::ranges::any_of(scene.instances, [&](const Instance& instance) {
    return scene.materials[instance.material].texture != kNoTexture && !scene.meshes[instance.mesh].texcoords.empty();
  });
  return knobs_for(effects(), may_simplify(scene), textured);
}

bool AccuracyScene::possible(const Settings& settings) const {
  const Effects effects = effects_with(settings);
  if (blends_edges(settings) && first().scene.instances.empty()) return false;
  // In a scene without light, lighting at pixels changes nothing.
  if (settings.name_of(Knob::shading) == "pixel" && !effects.has(effect::pixel_shading)) return false;
  return sim::possible(effects);
}

Result<Errors> AccuracyScene::errors(const Settings& settings, AccuracyPictures* pictures) const {
  const Settings key = without_strips(settings);
  {
    const std::scoped_lock lock(poses_->mutex);
    const auto known = poses_->found.find(key);
    if (known != poses_->found.end() && (pictures == nullptr || known->second.pictures)) {
      if (pictures != nullptr) *pictures = *known->second.pictures;
      return known->second.errors;
    }
  }
  Result<Errors> errors = find_errors(key, pictures);
  if (!errors) return errors.failure();
  const std::scoped_lock lock(poses_->mutex);
  Poses::Found& found = poses_->found[key];
  found.errors = *errors;
  if (pictures != nullptr) found.pictures = *pictures;
  return errors;
}

Result<Errors> AccuracyScene::find_errors(const Settings& settings, AccuracyPictures* pictures) const {
  const std::vector<Staging>& staged = poses_->staged;
  const std::vector<Truth>& truths = poses_->truths;
  const SceneVariant variant(first().scene, settings);
  const DepthScale depth{depth_format(extra_effects(settings)), effects().has(effect::orthographic)};
  ErrorSum sum(request_.view, first().camera, depth, variant.simplified());
  std::vector<Observation> seen;
  for (std::size_t i = 0; i < staged.size(); ++i) {
    Result<Observation> observed = observe(variant.apply(staged[i]), request_.view, settings);
    if (!observed) return observed.failure();
    seen.push_back(std::move(*observed));
    if (i % 2 == 0) {
      sum.add(seen[i], truths[i]);
    } else {
      sum.add_flicker(seen[i - 1], truths[i - 1], seen[i], truths[i]);
    }
  }
  if (pictures != nullptr) *pictures = {seen[0].rgb, sum.heat()};
  return sum.take();
}

Result<MemoryCost> AccuracyScene::memory(const Settings& settings) const {
  const SceneVariant variant(first().scene, settings);
  const View view = picture(settings, request_.view);
  const Staging staged = variant.apply(first());
  const PlanResult planned = plan(count(staged.scene), view, effects_with(settings), budget(settings, view.height));
  if (!planned.status) {
    return Failure{ExitStatus::internal,
                   fmt::format("{} cannot be planned: {}", to_text(settings), message(planned.status.error))};
  }
  const Result<std::vector<std::uint8_t>> blob = to_scene_blob({staged.scene, staged.camera, view, {}});
  if (!blob) return blob.failure();
  return MemoryCost{planned.plan.wide_bytes() + planned.plan.strip_pixel_bytes(view), blob->size()};
}

Result<Cost> AccuracyScene::cost(const Settings& settings) const {
  const SceneVariant variant(first().scene, settings);
  const View view = picture(settings, request_.view);
  const Budget strips = budget(settings, view.height);
  const Effects extra = extra_effects(settings);
  const auto poses = static_cast<double>(request_.frames);

  const Result<MemoryCost> memory_cost = memory(settings);
  if (!memory_cost) return memory_cost.failure();
  Cost cost;
  cost.ram_bytes = memory_cost->ram_bytes;
  cost.scene_bytes = memory_cost->scene_bytes;
  if (request_.target != "host") {
    std::vector<Staging> staged;
    for (std::size_t i = 0; i < poses_->staged.size(); i += 2) staged.push_back(variant.apply(poses_->staged[i]));
    const Result<Done> measured = measure_on_board(request_, staged, view, effects_with(settings), strips, cost);
    if (!measured) return measured.failure();
    return cost;
  }
  for (std::size_t i = 0; i < poses_->staged.size(); i += 2) {
    const Staging staged = variant.apply(poses_->staged[i]);
    double least = 1e300;
    for (int round = 0; round < kRounds; ++round) {
      const auto start = std::chrono::steady_clock::now();
      const Result<Drawn> drawn = draw(staged, view, extra, strips, false);
      const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
      if (!drawn) return drawn.failure();
      least = std::min(least, took.count());
    }
    cost.nanoseconds += least / poses;
  }
  return cost;
}

}  // namespace zstrip::sim
