// The nodes of a glTF file: nodes in its scene, their positions, and nodes that animations move.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
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
  /// False if KHR_node_visibility hides the node or an ancestor.
  bool is_visible(std::size_t node) const { return nodes_[node].visible; }
  /// Returns the index into SourceModel::nodes of the node that moves its contents: itself, or its nearest moving
  /// ancestor.
  std::int32_t mover_of(std::size_t node) const { return nodes_[node].mover; }

  /// Sets `model.nodes.nodes` to these nodes of the file, which animations move; each has the largest scales of its
  /// animations. If that is impossible, warns and moves no node. Vertices are stored in the pose at rest: a node that
  /// is much smaller there is enlarged, and set_rest_scale() gives its size back.
  void set_moved(const std::map<std::size_t, Vector>& moved, const Affine& turn, SourceModel& model);
  /// Adds the scale at rest of nodes that set_moved() enlarged to an animation that does not scale them.
  void set_rest_scale(NodeAnimation& animation) const;

 private:
  /// Returns a node that is its own ancestor, if there is one.
  std::optional<std::size_t> node_in_a_circle() const;

  /// Sets `world` of all nodes, and `in_scene_`.
  void place_all(const Affine& turn);

  struct Place {
    Affine local, world;
    std::optional<Placement> parts;    ///< of `local`, unless the file has a matrix
    std::optional<Vector> rest_scale;  ///< of the file, if `local` is larger
    bool visible = true;
    std::int32_t mover = kNoNode;
    std::vector<std::size_t> children;
    std::optional<std::size_t> parent;
    std::string name;
  };
  /// Gives a node its largest scale where that at rest is 0, or many times smaller. Returns false if it is not.
  static bool enlarge(Place& place, const Vector& largest);

  std::vector<Place> nodes_;
  std::vector<std::size_t> roots_;
  std::vector<std::size_t> in_scene_;
};

/// Returns the map of a matrix of 16 numbers, column by column.
Affine affine_of_columns(const std::array<double, 16>& columns);

}  // namespace zstrip::sim
