// One part of a model where an instance of the scene file places it: what becomes an instance of the composed scene.
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
  bool scaled_evenly() const {
    const Vector& scale = file->placement.scale;
    return scale[0] == scale[1] && scale[1] == scale[2];
  }
  /// From object space to the scene file's coordinates. `duration`: of the scene's animation.
  Affine at(double seconds, double duration) const;
};

/// The same part with its mesh moved instead of itself, so that it turns about the model's origin. Its map to the
/// model's coordinates is diagonal.
ModelPart around_origin(const ModelPart& part);

/// Whether this part can be placed like this; the failure names the line of the instance in `scene`.
Result<Done> check_placed(const PlacedPart& placed, const std::filesystem::path& scene);

}  // namespace zstrip::sim
