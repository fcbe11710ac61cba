// Fits keyframes to motions in floating point: each as late as possible after the one before.
#include "motion/fitted_animation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "import/quantise.hpp"

namespace zstrip::sim {
namespace {

constexpr std::uint32_t kMaxSamples = 20000;  // of one motion; longer animations are sampled less often

/// A motion at one time: the exact placement, and the keyframe for it.
struct Sample {
  Affine wanted;
  Keyframe keyframe{};
};

/// Returns ascending milliseconds: 0, the end, 60 a second, every key and the last millisecond before it.
std::vector<std::uint32_t> sample_times(std::uint32_t duration, const std::set<double>& key_times) {
  std::set<std::uint32_t> times{0, duration};
  const std::uint32_t count = std::min(kMaxSamples / 2, duration * 60 / 1000);
  for (std::uint32_t i = 1; i < count; ++i) {
    times.insert(static_cast<std::uint32_t>(std::uint64_t{duration} * i / count));
  }
  for (const double seconds : key_times) {
    const double milliseconds = std::ceil(seconds * 1000 - 1e-6);
    if (!(milliseconds >= 1 && milliseconds <= duration)) continue;
    times.insert({static_cast<std::uint32_t>(milliseconds), static_cast<std::uint32_t>(milliseconds) - 1});
    if (times.size() >= kMaxSamples) break;
  }
  return {times.begin(), times.end()};
}

bool to_fixed(const Vector& from, double limit, Vec3& to) {
  for (const double component : from) {
    if (!(std::abs(component) <= limit)) return false;
  }
  to = {sim::to_fixed(from[0]), sim::to_fixed(from[1]), sim::to_fixed(from[2])};
  return true;
}

bool to_keyframe(std::uint32_t time, const Affine& wanted, Keyframe& keyframe) {
  const Placement placement = to_placement(wanted);
  keyframe.time = time;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!std::isfinite(placement.rotation[i])) return false;
    keyframe.rotation[i] = static_cast<std::int16_t>(std::lround(32767 * placement.rotation[i]));  // 1.15
  }
  return to_fixed(placement.translation, 32767, keyframe.translation) && to_fixed(placement.scale, 255, keyframe.scale);
}

/// Returns the keyframe with the sign of its quaternion that is nearer to the quaternion of `before`.
Keyframe after(const Keyframe& before, Keyframe keyframe) {
  std::int64_t cosine = 0;
  for (std::size_t i = 0; i < 4; ++i) cosine += std::int64_t{before.rotation[i]} * keyframe.rotation[i];
  if (cosine < 0) {
    for (std::int16_t& component : keyframe.rotation) component = static_cast<std::int16_t>(-component);
  }
  return keyframe;
}

/// Returns the error of the renderer's interpolation of a few keyframes at a sample.
double deviation(std::span<const Keyframe> keyframes, const Sample& sample, std::span<const Vector> corners) {
  const Track track{.instance = 0, .count = static_cast<std::uint16_t>(keyframes.size()), .first = 0};
  Instance instance;
  pose({.tracks = {&track, 1}, .keyframes = keyframes, .duration = 0xFFFFFFFF}, sample.keyframe.time, {&instance, 1});
  const Affine got = to_affine(instance.transform);
  double farthest = 0;
  for (const Vector& corner : corners) {
    const Vector a = got * corner, b = sample.wanted * corner;
    farthest = std::max(farthest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
  }
  return farthest;
}

class Fit {
 public:
  Fit(std::span<const Sample> samples, std::span<const Vector> corners, double tolerance)
      : samples_(samples), corners_(corners), tolerance_(tolerance) {}

  std::vector<Keyframe> keyframes() const {
    std::vector<Keyframe> kept{samples_[0].keyframe};
    if (stands_still()) return kept;
    for (std::size_t at = 0; at + 1 < samples_.size();) {
      at = farthest_from(kept.back(), at);
      kept.push_back(after(kept.back(), samples_[at].keyframe));
    }
    return kept;
  }

 private:
  bool stands_still() const {
    return std::ranges::all_of(samples_, [&](const Sample& sample) {
      return deviation({&samples_[0].keyframe, 1}, sample, corners_) <= tolerance_;
    });
  }

  bool reaches(const Keyframe& from, std::size_t at, std::size_t next) const {
    const std::array pair{from, after(from, samples_[next].keyframe)};
    for (std::size_t i = at + 1; i < next; ++i) {
      if (deviation(pair, samples_[i], corners_) > tolerance_) return false;
    }
    return true;
  }

  /// Returns the next keyframe: a late sample that can be reached from the one at `at`, found by doubling and halving
  /// the step.
  std::size_t farthest_from(const Keyframe& from, std::size_t at) const {
    const std::size_t last = samples_.size() - 1;
    std::size_t good = at + 1, step = 1;
    while (good < last && reaches(from, at, std::min(good + step, last))) {
      good = std::min(good + step, last);
      step *= 2;
    }
    for (; step > 0; step /= 2) {
      if (good + step <= last && reaches(from, at, good + step)) good += step;
    }
    return good;
  }

  std::span<const Sample> samples_;
  std::span<const Vector> corners_;
  double tolerance_;
};

}  // namespace

Result<FittedAnimation> fit_animation(std::span<const InstanceMotion> motions, double duration,
                                      const std::set<double>& key_times, double tolerance) {
  FittedAnimation fitted;
  fitted.duration_ = static_cast<std::uint32_t>(std::max(1.0, std::round(duration * 1000)));
  const std::vector<std::uint32_t> times = sample_times(fitted.duration_, key_times);
  for (const InstanceMotion& motion : motions) {
    std::vector<Sample> samples;
    for (const std::uint32_t time : times) {
      Sample& sample = samples.emplace_back(Sample{.wanted = motion.at(time / 1000.0)});
      if (!to_keyframe(time, sample.wanted, sample.keyframe)) {
        return Failure{ExitStatus::input, "moves something out of range, or makes it more than 255 times as large"};
      }
    }
    const std::vector<Keyframe> kept = Fit(samples, motion.corners, tolerance).keyframes();
    if (kept.size() > 0xFFFF) return Failure{ExitStatus::input, "has more than 65,535 keyframes; make it shorter"};
    for (const Sample& sample : samples)
      fitted.error_ = std::max(fitted.error_, deviation(kept, sample, motion.corners));
    fitted.tracks_.push_back({.instance = motion.instance,
                              .count = static_cast<std::uint16_t>(kept.size()),
                              .first = static_cast<std::uint32_t>(fitted.keyframes_.size())});
    fitted.keyframes_.insert(fitted.keyframes_.end(), kept.begin(), kept.end());
  }
  return fitted;
}

}  // namespace zstrip::sim
