// A model of a scene file: its parts in the coordinates that the scene file places.
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
  std::uint16_t material = 0;  ///< index into PlacedModel::materials
  Affine to_file;              ///< from the mesh's object space to the model's coordinates, at rest
  std::int32_t node = kNoNode;
  const ModelSkin* skin = nullptr;    ///< null: no joint moves its vertices
  const ModelMorph* morph = nullptr;  ///< null: it has no morph targets
};

/// Lines or points of a model that are not edges of triangles. They do not move.
struct LinePart {
  ModelPart part;  ///< its mesh has only vertices
  std::span<const Segment> segments;
};

/// Refers to the Model from which it was made, or to a built-in scene.
struct PlacedModel {
  std::vector<ModelPart> parts;
  std::vector<LinePart> lines{};
  std::span<const Material> materials;
  std::span<const Texture> textures;
  std::span<const Finish> finishes;
  std::vector<std::string> material_names;
  const Model* model = nullptr;              ///< null: a built-in scene
  const NodeAnimation* animation = nullptr;  ///< null: no motion

  bool moves(const ModelPart& part) const {
    return animation != nullptr && part.node != kNoNode && model->tree.moves(*animation, part.node);
  }
  /// True if the animation moves vertices of a part: by joints of a skin or by weights of morph targets.
  bool bends() const;
  /// Returns the map from the part's object space to the model's coordinates. An animation that is shorter than the
  /// time is repeated.
  Affine placed(const ModelPart& part, double seconds) const;
};

/// Adds the sequence of the entry's clips, if it has any, to the model's animations.
Result<Done> join_clips(const FileModel& entry, Model& model, const std::filesystem::path& scene);
/// `model`: the result of import_model for the same entry, after join_clips.
Result<PlacedModel> place_model(const FileModel& entry, const Model& model, const std::filesystem::path& scene);
Result<PlacedModel> place_built_in(const FileModel& entry, const std::filesystem::path& scene);

}  // namespace zstrip::sim
