// The nodes of a model that its animations move, with the file's structure.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "motion/affine.hpp"

namespace zstrip::sim {

enum class Interpolation : std::uint8_t { step, linear, cubic_spline };

/// Values at times (seconds, ascending). A value of a cubic spline has the slopes (per second) before and after it.
/// Empty: not animated.
template <typename Value>
struct Curve {
  Interpolation interpolation = Interpolation::linear;
  std::vector<double> times;
  std::vector<Value> values;
  std::vector<Value> slopes_in, slopes_out;  ///< for cubic splines, else empty
};

inline constexpr std::int32_t kNoNode = -1;

/// A node that an animation moves; other nodes are merged into the maps of the nodes above or below.
struct Node {
  std::int32_t parent = kNoNode;     ///< the nearest ancestor that is animated, too: a smaller index
  Affine before;                     ///< from the node's own placement to the parent, or to the file's coordinates
  Affine at_rest;                    ///< the node's placement in the file, in these coordinates
  std::optional<Placement> parts{};  ///< the placement as the file gives it: a matrix does not tell which axis is
                                     ///< mirrored
  std::string name{};                ///< the file's name, or "node" and its number there; for messages
};

/// The curves that move one node; the node keeps its values at rest where a curve is empty.
struct NodeCurves {
  std::int32_t node = 0;
  Curve<Vector> translation;
  Curve<Quaternion> rotation;
  Curve<Vector> scale;
};

/// The curve of one weight of morph targets.
struct WeightCurve {
  std::uint32_t weight = 0;  ///< index into SourceModel::weights
  Curve<std::array<double, 1>> curve;
};

/// A number for programs at a time of an animation.
struct AnimationEvent {
  double seconds = 0;  ///< after the start
  std::uint16_t number = 0;
};

struct NodeAnimation {
  std::string name;     ///< may be empty
  double duration = 0;  ///< seconds, > 0
  std::vector<NodeCurves> moved;
  std::vector<WeightCurve> weights{};  ///< at most one for each weight
  std::vector<AnimationEvent> events{};
};

struct NodeTree {
  std::vector<Node> nodes;
  std::vector<NodeAnimation> animations;

  /// Returns the map from the node to the file's coordinates, at rest, or `seconds` after an animation's start.
  Affine at_rest(std::int32_t node) const;
  Affine at(const NodeAnimation& animation, std::int32_t node, double seconds) const;
  /// Returns the map from the node to its parent's coordinates, `seconds` after the start; at rest without an
  /// animation.
  Affine local(const NodeAnimation* animation, std::int32_t node, double seconds) const;
  /// Returns the node's own placement, without Node::before, `seconds` after the start; at rest if the animation does
  /// not move it.
  Placement placement(const NodeAnimation& animation, std::int32_t node, double seconds) const;
  /// True if this animation moves the node itself or an ancestor.
  bool moves(const NodeAnimation& animation, std::int32_t node) const;
};

/// Returns the first value before the first time, and the last value after the last time. `curve` has values.
Vector sample(const Curve<Vector>& curve, double seconds);
Quaternion sample(const Curve<Quaternion>& curve, double seconds);
double sample(const Curve<std::array<double, 1>>& curve, double seconds);

/// Returns all times at which a curve of the animation has a value.
std::set<double> key_times(const NodeAnimation& animation);

}  // namespace zstrip::sim
