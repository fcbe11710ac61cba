// A model of a scene file: its parts, as they lie in the coordinates that the scene file places.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compose/scene_file.hpp"
#include "import/model.hpp"
#include "motion/affine.hpp"
#include "result.hpp"

namespace zstrip::sim {

struct ModelPart {
  Mesh mesh;
  std::uint16_t material = 0;  ///< of PlacedModel::materials
  Affine to_file;              ///< from the mesh's object space to the model's coordinates, at rest
  std::int32_t node = kNoNode;
};

/// Lines or points of a model, which are no edges of triangles. They stand still.
struct LinePart {
  ModelPart part;  ///< its mesh has vertices alone
  std::span<const Segment> segments;
};

/// Views the Model that it was made of, or a built-in scene.
struct PlacedModel {
  std::vector<ModelPart> parts;
  std::vector<LinePart> lines{};
  std::span<const Material> materials;
  std::span<const Texture> textures;
  std::span<const Finish> finishes;
  std::vector<std::string> material_names;
  const Model* model = nullptr;              ///< null: built in
  const NodeAnimation* animation = nullptr;  ///< null: stands still

  bool moves(const ModelPart& part) const {
    return animation != nullptr && part.node != kNoNode && model->tree.moves(*animation, part.node);
  }
  /// From the part's object space to the model's coordinates. Animations shorter than the time begin again.
  Affine placed(const ModelPart& part, double seconds) const;
};

/// `model`: import_model's of the same entry.
Result<PlacedModel> place_model(const FileModel& entry, const Model& model, const std::filesystem::path& scene);
Result<PlacedModel> place_built_in(const FileModel& entry, const std::filesystem::path& scene);

}  // namespace zstrip::sim
