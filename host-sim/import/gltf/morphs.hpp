// Weights of morph targets in a glTF file: those at rest, and those that animations change.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "import/gltf/json.hpp"
#include "import/source_model.hpp"
#include "motion/node_tree.hpp"
#include "result.hpp"

namespace zstrip::sim {

class GltfMorphs {
 public:
  using Weight = std::array<double, 1>;

  explicit GltfMorphs(const GltfJson& json) : json_(json) {}

  /// Returns the number of targets of the mesh on a node; 0 without one.
  std::size_t targets_of(std::size_t node) const;
  /// Returns the weight in the file of a target of the mesh on a node.
  double at_rest(std::size_t node, std::size_t target) const;

  /// Adds the curves of a node's targets, one each, to an animation, which is complete before the next one begins.
  /// Curves that never leave the weight at rest are left out. Fails above 65,535 weights; the message is a reason.
  Result<Done> add(std::size_t node, std::vector<Curve<Weight>> curves, NodeAnimation& animation);
  /// Sets `model.weights`, and makes the curves of its animations relative to the weights at rest. Call it once, after
  /// all animations are read.
  void finish(SourceModel& model);

  /// A target whose weight animations change.
  struct Moved {
    std::uint32_t weight = 0;  ///< index into SourceModel::weights
    double scale = 1;          ///< factor for its offsets: the weights were divided by it to fit the renderer's range
  };
  /// Empty: no animation changes the weight.
  std::optional<Moved> moved(std::size_t node, std::size_t target) const;

 private:
  const GltfJson& mesh_of(std::size_t node) const;

  const GltfJson& json_;
  std::map<std::pair<std::size_t, std::size_t>, std::uint32_t> moved_;  ///< by node and target
  std::vector<double> rest_, scale_;                                    ///< of each weight
  std::vector<std::size_t> places_;  ///< of each weight, in the animation that had it last
};

}  // namespace zstrip::sim
