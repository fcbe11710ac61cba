// Which of Assimp's nodes a file's animations move, and how.
#pragma once

#include <assimp/scene.h>

#include <cstdint>
#include <filesystem>
#include <map>

#include "import/source_model.hpp"

namespace zstrip::sim {

Affine to_affine(const aiMatrix4x4& from);

class MovedNodes {
 public:
  /// Fills `model.nodes`, and adds warnings for what of the animations is left out. `turn` comes after all nodes.
  /// Nothing is moved unless `file`, the glTF 2.0 file that `scene` was read from, is given.
  MovedNodes(const aiScene& scene, const aiMatrix4x4& turn, const std::filesystem::path& file, SourceModel& model);

  /// The node of `model.nodes` that moves what hangs on `node`: itself or its nearest ancestor that is one.
  std::int32_t mover_of(const aiNode& node) const;

 private:
  void find_moved(const aiScene& scene, const aiMatrix4x4& turn, SourceModel& model);
  void read_animations(const aiScene& scene, const std::filesystem::path& file, SourceModel& model) const;

  std::map<const aiNode*, std::int32_t> movers_;
};

}  // namespace zstrip::sim
