// The nodes of a glTF file: which of them are in its scene, where they are, and which of them animations move.
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
  /// `turn` comes after all nodes. Fails where nodes are no trees; the message is a reason.
  static Result<GltfNodes> read(const GltfJson& json, const Affine& turn);

  /// Those of the scene, parents before children, in the file's order.
  const std::vector<std::size_t>& in_scene() const { return in_scene_; }
  std::size_t size() const { return nodes_.size(); }
  /// From the node to the file's coordinates, at rest.
  const Affine& world(std::size_t node) const { return nodes_[node].world; }
  /// The node of SourceModel::nodes that moves what hangs on it: itself, or its nearest ancestor that is one.
  std::int32_t mover_of(std::size_t node) const { return nodes_[node].mover; }

  /// Fills `model.nodes.nodes` with these of the file's, which animations move. Warns and moves nothing where they
  /// cannot be.
  void set_moved(const std::set<std::size_t>& moved, const Affine& turn, SourceModel& model);

 private:
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

/// Of a matrix of 16 numbers, column by column.
Affine affine_of_columns(const std::array<double, 16>& columns);

}  // namespace zstrip::sim
