// The nodes of a model that its animations move, as in the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "motion/affine.hpp"

namespace zstrip::sim {

enum class Interpolation : std::uint8_t { step, linear, cubic_spline };

/// Values at times (seconds, growing). Of a cubic spline each has the slopes (per second) before and after it. Empty:
/// not animated.
template <typename Value>
struct Curve {
  Interpolation interpolation = Interpolation::linear;
  std::vector<double> times;
  std::vector<Value> values;
  std::vector<Value> slopes_in, slopes_out;  ///< of cubic splines, else empty
};

inline constexpr std::int32_t kNoNode = -1;

/// A node that some animation moves; all others are part of what is below or above them.
struct Node {
  std::int32_t parent = kNoNode;     ///< the nearest ancestor that is moved too: a smaller index
  Affine before;                     ///< from where the node is placed to the parent, or to the file's coordinates
  Affine at_rest;                    ///< where the file places it, in these
  std::optional<Placement> parts{};  ///< likewise, as the file says it: a matrix does not tell which axis is mirrored
  std::string name{};                ///< the file's, or "node" and its number there; for messages
};

/// What moves one node; what is empty stays as it is at rest.
struct NodeCurves {
  std::int32_t node = 0;
  Curve<Vector> translation;
  Curve<Quaternion> rotation;
  Curve<Vector> scale;
};

struct NodeAnimation {
  std::string name;     ///< may be empty
  double duration = 0;  ///< seconds, > 0
  std::vector<NodeCurves> moved;
};

struct NodeTree {
  std::vector<Node> nodes;
  std::vector<NodeAnimation> animations;

  /// From the node to the file's coordinates, at rest, or `seconds` after an animation's start.
  Affine at_rest(std::int32_t node) const;
  Affine at(const NodeAnimation& animation, std::int32_t node, double seconds) const;
  /// From the node to its parent's coordinates, likewise; at rest without an animation.
  Affine local(const NodeAnimation* animation, std::int32_t node, double seconds) const;
  /// Whether this animation moves the node, itself or an ancestor.
  bool moves(const NodeAnimation& animation, std::int32_t node) const;
};

/// Before the first time the first value, after the last the last one. `curve` has values.
Vector sample(const Curve<Vector>& curve, double seconds);
Quaternion sample(const Curve<Quaternion>& curve, double seconds);

/// All times at which a curve of the animation has a value.
std::set<double> key_times(const NodeAnimation& animation);

}  // namespace zstrip::sim
