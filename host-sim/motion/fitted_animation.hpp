// From motions in floating point to the renderer's animation: as few keyframes as show the same.
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

/// Where one instance is: from its object space to the scene, `seconds` after the start.
struct InstanceMotion {
  std::uint16_t instance = 0;
  std::function<Affine(double seconds)> at;
  std::vector<Vector> corners;  ///< of what moves, in object space
};

inline constexpr double kMaxAnimation = 3600;  ///< seconds
/// How far keyframes may be off, of the scene's radius: a tenth of a pixel where that fills 320 pixels.
inline constexpr double kAnimationTolerance = 1.0 / 1600;

/// Owns what an Animation views. Stays valid when it is moved; cannot be copied.
class FittedAnimation {
 public:
  FittedAnimation() = default;
  FittedAnimation(FittedAnimation&&) = default;
  FittedAnimation& operator=(FittedAnimation&&) = default;
  FittedAnimation(const FittedAnimation&) = delete;
  FittedAnimation& operator=(const FittedAnimation&) = delete;

  Animation view() const { return {tracks_, keyframes_, duration_}; }
  /// The farthest that a corner is from where it should be, of all times looked at; the scene's units.
  double error() const { return error_; }

 private:
  friend Result<FittedAnimation> fit_animation(std::span<const InstanceMotion>, double, const std::set<double>&,
                                               double);
  std::vector<Track> tracks_;
  std::vector<Keyframe> keyframes_;
  std::uint32_t duration_ = 0;
  double error_ = 0;
};

/// `duration`: seconds, > 0, at most kMaxAnimation. `key_times`: where motions may bend or jump; between them they
/// are looked at 60 times a second. Every corner stays within `tolerance` (the scene's units) of its place, but for
/// motions that shear, which no keyframe can represent: error() has the distance. Fails (ExitStatus::input, message
/// starts with a verb) for what leaves the renderer's range.
Result<FittedAnimation> fit_animation(std::span<const InstanceMotion> motions, double duration,
                                      const std::set<double>& key_times, double tolerance);

}  // namespace zstrip::sim
