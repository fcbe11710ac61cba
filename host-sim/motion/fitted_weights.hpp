// Fits the renderer's animation of weights to curves in floating point.
#pragma once

#include <span>
#include <vector>

#include "motion/node_tree.hpp"
#include "result.hpp"
#include "zstrip/morph.hpp"

namespace zstrip::sim {

/// Owns the data that a WeightAnimation views, which stays valid when it is moved.
class FittedWeights {
 public:
  WeightAnimation view() const { return {tracks_, keys_, duration_}; }

 private:
  friend Result<FittedWeights> fit_weights(const NodeAnimation&, std::span<const double>);
  std::vector<Track> tracks_;
  std::vector<WeightKey> keys_;
  std::uint32_t duration_ = 0;
};

/// `tolerances`: the largest error of each weight; 0: it is left out. The times are those of fit_animation(). Fails as
/// it does.
Result<FittedWeights> fit_weights(const NodeAnimation& animation, std::span<const double> tolerances);

}  // namespace zstrip::sim
