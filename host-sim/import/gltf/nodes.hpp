// The nodes of a glTF file: nodes in its scene, their positions, and nodes that animations move.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "import/gltf/json.hpp"
#include "import/source_model.hpp"
#include "motion/affine.hpp"
#include "result.hpp"

namespace zstrip::sim {

class GltfNodes {
 public:
  /// `turn` is applied after all nodes. Fails if nodes do not form trees; the message is a reason.
  static Result<GltfNodes> read(const GltfJson& json, const Affine& turn);

  /// Returns the nodes of the scene, parents before children, in the file's order.
  const std::vector<std::size_t>& in_scene() const { return in_scene_; }
  std::size_t size() const { return nodes_.size(); }
  /// Returns the map from the node to the file's coordinates, at rest.
  const Affine& world(std::size_t node) const { return nodes_[node].world; }
  /// Returns the index into SourceModel::nodes of the node that moves its contents: itself, or its nearest moving
  /// ancestor.
  std::int32_t mover_of(std::size_t node) const { return nodes_[node].mover; }

  /// Sets `model.nodes.nodes` to these nodes of the file, which animations move. If that is impossible, warns and moves
  /// no node.
  void set_moved(const std::set<std::size_t>& moved, const Affine& turn, SourceModel& model);

 private:
  /// Returns a node that is its own ancestor, if there is one.
  std::optional<std::size_t> node_in_a_circle() const;

  struct Place {
    Affine local, world;
    std::optional<Placement> parts;  ///< of `local`, unless the file has a matrix
    std::int32_t mover = kNoNode;
    std::vector<std::size_t> children;
    std::optional<std::size_t> parent;
    std::string name;
  };
  std::vector<Place> nodes_;
  std::vector<std::size_t> roots_;
  std::vector<std::size_t> in_scene_;
};

/// Returns the map of a matrix of 16 numbers, column by column.
Affine affine_of_columns(const std::array<double, 16>& columns);

}  // namespace zstrip::sim
