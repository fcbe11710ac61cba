// A part of a model that an instance of the scene file places. It becomes an instance of the composed scene.
#include "compose/placed_part.hpp"

#include "import/quantise.hpp"

namespace zstrip::sim {
namespace {

/// Returns the scene file's placement of an instance at a time.
Affine placement_at(const FileInstance& instance, double seconds, double duration) {
  Placement placement = instance.placement;
  if (!instance.translation.times.empty()) placement.translation = sample(instance.translation, seconds);
  if (!instance.rotation.times.empty()) placement.rotation = sample(instance.rotation, seconds);
  if (!instance.scale.times.empty()) placement.scale = sample(instance.scale, seconds);
  const Affine turned = rotation(placement.rotation) * scaling(placement.scale);
  if (!instance.turntable) return translation(placement.translation) * turned;
  const double degrees = 360 * instance.turntable->turns * seconds / duration;
  return translation(placement.translation) * rotation(about_axis(instance.turntable->axis, degrees)) * turned;
}

}  // namespace

Affine PlacedPart::at(double seconds, double duration) const {
  return placement_at(*file, seconds, duration) * model->placed(*part, seconds);
}

ModelPart around_origin(const ModelPart& part) {
  ModelPart moved = part;
  std::size_t axis = 0;
  for (Fixed Vec3::*const member : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    auto& row = moved.to_file.m[axis];
    moved.mesh.centre.*member += to_fixed(row[3] / row[axis]);
    row[3] = 0;
    ++axis;
  }
  return moved;
}

Result<Done> check_placed(const PlacedPart& placed, const std::filesystem::path& scene) {
  const auto wrong = [&](const char* what) { return at_line(scene, placed.file->line, what); };
  const bool animated = placed.model->moves(*placed.part) || placed.bends();
  if (placed.bends() && placed.file->outline)
    return wrong("an outline does not bend, and joints or morph targets move this model");
  if (placed.file->is_static && animated) {
    return wrong("an instance of the static layer cannot have an animation; its model has one");
  }
  if (placed.file->billboard != Billboard::none && (animated || !is_diagonal(placed.part->to_file))) {
    return wrong("a billboard's model must have no animation and no part that is turned");
  }
  if (placed.scaled_evenly()) return Done{};
  if (animated) return wrong("a model that has an animation can only be scaled evenly");
  if (!is_diagonal(placed.part->to_file)) return wrong("this built-in scene can only be scaled evenly");
  return Done{};
}

}  // namespace zstrip::sim
