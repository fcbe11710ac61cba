// Converts skins of a glTF file to joints: the joints that move a vertex, and the vertex's position.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "import/gltf/accessors.hpp"
#include "import/gltf/attributes.hpp"
#include "import/gltf/json.hpp"
#include "import/gltf/nodes.hpp"
#include "import/source_model.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Joints and weights as in SourceVertex.
struct SkinnedVertex {
  std::array<std::uint8_t, 4> joints{}, weights{};
};

/// The conversion of a primitive's vertices.
struct SkinnedPrimitive {
  Affine modelled;                      ///< from the mesh's coordinates to those in which vertices are stored
  std::vector<SkinnedVertex> joints{};  ///< one for each vertex if joints move it; else empty
  std::vector<Affine> at_rest{};        ///< one for each vertex if the skin does not move; replaces `modelled`
};

class GltfSkins {
 public:
  GltfSkins(const GltfJson& json, GltfAccessors& accessors, const GltfNodes& nodes, SourceModel& model)
      : json_(json), accessors_(accessors), nodes_(nodes), model_(model) {}

  /// Converts a primitive of `vertices` vertices on this node. Adds to the model's joints. A primitive without a skin
  /// moves with its node. The failure's message is a reason.
  Result<SkinnedPrimitive> read(const GltfAttributes& primitive, std::size_t vertices, std::size_t node);

  /// Adds warnings for data that was left out.
  void warn() const;

 private:
  /// A joint of a vertex, by its index in Binds.
  struct Influence {
    std::size_t bind;
    double weight;
  };
  /// A skin's joints, followed by the node of its mesh, for vertices without a joint.
  struct Binds {
    std::vector<std::size_t> nodes;
    std::vector<Affine> inverse_binds;
  };

  Result<Binds> read_binds(const GltfJson& skin, std::size_t node);
  Result<std::vector<std::vector<Influence>>> read_influences(const GltfAttributes& primitive, std::size_t vertices,
                                                              std::size_t binds);
  std::size_t joint_of_node(std::int32_t node);
  std::size_t joint_with(std::size_t node, const Affine& inverse_bind, const Affine& modelled);
  SkinnedVertex strongest(const std::vector<Influence>& influences, const std::vector<std::size_t>& joints);

  const GltfJson& json_;
  GltfAccessors& accessors_;
  const GltfNodes& nodes_;
  SourceModel& model_;
  std::uint64_t unweighted_ = 0;  ///< vertices with a weight that is negative or not a number
  std::uint64_t weightless_ = 0;  ///< vertices whose weights are all zero
  std::uint64_t unmoved_ = 0;     ///< vertices of a joint whose matrix has no inverse
  std::uint64_t weakened_ = 0;    ///< vertices with more than four joints
  std::uint64_t still_ = 0;       ///< meshes that need too many joints
};

}  // namespace zstrip::sim
