// Fits the renderer's animation of weights to curves in floating point: each weight is a motion along x.
#include "motion/fitted_weights.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/affine.hpp"
#include "motion/fitted_animation.hpp"

namespace zstrip::sim {

Result<FittedWeights> fit_weights(const NodeAnimation& animation, std::span<const double> tolerances) {
  FittedWeights fitted;
  for (const WeightCurve& weight : animation.weights) {
    if (weight.curve.times.empty() || tolerances[weight.weight] == 0) continue;
    const InstanceMotion motion{.instance = static_cast<std::uint16_t>(weight.weight),
                                .at =
                                    [&weight](double seconds) {
                                      return translation({sample(weight.curve, seconds), 0, 0});
                                    },
                                .corners = {Vector{0, 0, 0}}};
    const std::set<double> times(weight.curve.times.begin(), weight.curve.times.end());
    Result<FittedAnimation> along_x = fit_animation({&motion, 1}, animation.duration, times, tolerances[weight.weight]);
    if (!along_x) return along_x.failure();
    const Animation view = along_x->view();
    fitted.duration_ = view.duration;
    fitted.tracks_.push_back({.instance = motion.instance,
                              .count = view.tracks[0].count,
                              .first = static_cast<std::uint32_t>(fitted.keys_.size())});
    for (const Keyframe& key : view.keyframes) {
      constexpr int kShift = 4;  // from 16.16 to 4.12
      const Fixed rounded = (key.translation.x + (1 << (kShift - 1))) >> kShift;
      fitted.keys_.push_back({key.time, static_cast<MorphWeight>(std::clamp<Fixed>(rounded, -32768, 32767))});
    }
  }
  return fitted;
}

}  // namespace zstrip::sim
