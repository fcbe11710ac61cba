// The duration and the key times of a scene file's animation.
#include "compose/timeline.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace zstrip::sim {
namespace {

constexpr double kTurntableSeconds = 4;  // of a scene without another duration
constexpr std::size_t kMaxModelTimes = 10000;

/// Returns the times of the instances' own keyframes.
std::set<double> keyframe_times(const SceneFile& file) {
  std::set<double> times;
  for (const FileInstance& instance : file.instances) {
    for (const std::vector<double>& own : {instance.translation.times, instance.rotation.times, instance.scale.times}) {
      times.insert(own.begin(), own.end());
    }
  }
  return times;
}

}  // namespace

double duration_of(const SceneFile& file, std::span<const PlacedPart> placed) {
  const std::set<double> times = keyframe_times(file);
  double longest = times.empty() ? 0 : *times.rbegin();
  for (const PlacedPart& each : placed) {
    if (each.model->moves(*each.part) || each.bends()) longest = std::max(longest, each.model->animation->duration);
  }
  return file.duration.value_or(longest > 0 ? longest : kTurntableSeconds);
}

std::set<double> all_key_times(const SceneFile& file, std::span<const PlacedModel> models, double duration) {
  std::set<double> times = keyframe_times(file);
  for (const PlacedModel& model : models) {
    if (model.animation == nullptr) continue;
    const std::set<double> own = key_times(*model.animation);
    for (double begin = 0; begin < duration && times.size() < kMaxModelTimes; begin += model.animation->duration) {
      for (const double time : own) times.insert(begin + time);
    }
  }
  return times;
}

}  // namespace zstrip::sim
