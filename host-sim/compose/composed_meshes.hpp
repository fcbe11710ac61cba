// The meshes of a composed scene: each once for each size that it is wanted in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

#include "compose/composed_scene.hpp"
#include "compose/placed_part.hpp"

namespace zstrip::sim {

class ComposedMeshes {
 public:
  /// Adds to `scene`, whose units are set.
  explicit ComposedMeshes(ComposedScene& scene) : scene_(scene) {}

  /// The size of a part in the scene, which goes into its mesh, so that what turns it has all its bits.
  Vector scale_of(const PlacedPart& placed);
  /// The index of the mesh of this size.
  std::uint16_t index_of(const PlacedPart& placed, const Vector& scale);

 private:
  ComposedScene& scene_;
  std::map<std::pair<std::size_t, std::size_t>, Vector> first_scales_;
  std::map<std::tuple<std::size_t, std::size_t, Vector, Billboard>, std::uint16_t> known_;
};

}  // namespace zstrip::sim
