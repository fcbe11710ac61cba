// A part of a model that an instance of the scene file places. It becomes an instance of the composed scene.
#pragma once

#include <cstddef>
#include <filesystem>

#include "compose/placed_model.hpp"
#include "compose/scene_file.hpp"
#include "motion/affine.hpp"
#include "result.hpp"

namespace zstrip::sim {

struct PlacedPart {
  const FileInstance* file = nullptr;
  const PlacedModel* model = nullptr;
  const ModelPart* part = nullptr;
  std::size_t model_index = 0, part_index = 0;

  bool moves() const { return file->moves() || model->moves(*part); }
  /// True if joints or morph targets move its vertices.
  bool bends() const { return (part->skin != nullptr || part->morph != nullptr) && model->bends(); }
  bool scaled_evenly() const {
    const Vector& scale = file->placement.scale;
    return scale[0] == scale[1] && scale[1] == scale[2];
  }
  /// Returns the map from object space to the scene file's coordinates. `duration`: of the scene's animation.
  Affine at(double seconds, double duration) const;
};

/// Returns the part with its map to the model's coordinates, which is diagonal, applied to its mesh. The part then
/// rotates about the model's origin.
ModelPart around_origin(const ModelPart& part);

/// Checks that this part can be placed; the failure says the line of the instance in `scene`.
Result<Done> check_placed(const PlacedPart& placed, const std::filesystem::path& scene);

}  // namespace zstrip::sim
