// Assimp's bones as joints: which of them move a vertex, and from where.
#pragma once

#include <assimp/scene.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "import/moved_nodes.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// As SourceVertex has them.
struct VertexBones {
  std::array<std::uint8_t, 4> joints{}, weights{};
};

/// What becomes of a mesh's vertices.
struct MeshBones {
  aiMatrix4x4 modelled;                ///< from the mesh's coordinates to where vertices are kept
  std::vector<VertexBones> joints{};   ///< one a vertex, of a mesh whose joints move; else empty
  std::vector<aiMatrix4x4> at_rest{};  ///< one a vertex, instead of `modelled`, where a skin stands still
};

class BoneReader {
 public:
  /// `turn` comes after all nodes.
  BoneReader(const aiScene& scene, const aiMatrix4x4& turn, const MovedNodes& moved, SourceModel& model);

  /// Of a mesh on this node, whose `transform` leads to the file's coordinates. Adds to the model's joints. A mesh
  /// without bones stays where its node is.
  MeshBones read(const aiMesh& mesh, const aiMatrix4x4& transform, const aiNode& on);

  /// Adds warnings for what has been left out.
  void warn() const;

 private:
  /// A vertex' bone, as Assimp has it.
  struct Influence {
    unsigned bone;
    double weight;
  };

  const aiNode* node_of(const aiBone& bone) const;
  aiMatrix4x4 world_of(const aiNode& node) const;
  std::size_t joint_of_node(std::int32_t node);
  std::size_t joint_with(const aiNode* node, const aiMatrix4x4& world, const aiMatrix4x4& offset,
                         const aiMatrix4x4& modelled);
  VertexBones strongest(const std::vector<Influence>& influences, const std::vector<std::size_t>& joints);

  const aiScene& scene_;
  aiMatrix4x4 turn_;
  const MovedNodes& moved_;
  SourceModel& model_;
  std::uint64_t weakened_ = 0;  ///< vertices that more than four joints move
  std::uint64_t still_ = 0;     ///< meshes that need too many joints
};

}  // namespace zstrip::sim
