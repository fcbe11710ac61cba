// Fits the renderer's animation to motions in floating point, with as few keyframes as the tolerance allows.
#pragma once

#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "motion/affine.hpp"
#include "result.hpp"
#include "zstrip/animation.hpp"

namespace zstrip::sim {

/// The motion of one instance: its map from object space to the scene, `seconds` after the start.
struct InstanceMotion {
  std::uint16_t instance = 0;
  std::function<Affine(double seconds)> at;
  std::vector<Vector> corners;  ///< of the moving object, in object space
};

inline constexpr double kMaxAnimation = 3600;  ///< seconds
/// Largest error of keyframes, relative to the scene's radius: a tenth of a pixel if the radius fills 320 pixels.
inline constexpr double kAnimationTolerance = 1.0 / 1600;

/// Owns the data that an Animation views, which stays valid when it is moved.
class FittedAnimation {
 public:
  Animation view() const { return {tracks_, keyframes_, duration_}; }
  /// Returns the largest distance of a corner from its exact place, over all sampled times; in the scene's units.
  double error() const { return error_; }

 private:
  friend Result<FittedAnimation> fit_animation(std::span<const InstanceMotion>, double, const std::set<double>&,
                                               double);
  std::vector<Track> tracks_;
  std::vector<Keyframe> keyframes_;
  std::uint32_t duration_ = 0;
  double error_ = 0;
};

/// `duration`: seconds, > 0, at most kMaxAnimation. `key_times`: the times at which motions may bend or jump; between
/// them they are sampled 60 times a second. Every corner stays within `tolerance` (the scene's units) of its exact
/// place, except for motions that shear, which no keyframe can represent: error() has the distance. Fails
/// (ExitStatus::input, message starts with a verb) if a motion leaves the renderer's range.
Result<FittedAnimation> fit_animation(std::span<const InstanceMotion> motions, double duration,
                                      const std::set<double>& key_times, double tolerance);

}  // namespace zstrip::sim
