// The meshes of a composed scene: each once for each size that it has in the scene.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

#include "compose/composed_scene.hpp"
#include "compose/placed_part.hpp"

namespace zstrip::sim {

/// Outline::hull where a mesh has too many vertices for one.
inline constexpr std::uint16_t kNoHull = kOwnMesh - 1;

class ComposedMeshes {
 public:
  /// Adds to `scene`, whose units are set.
  explicit ComposedMeshes(ComposedScene& scene) : scene_(scene) {}

  /// The size of a part in the scene, which goes into its mesh, so that what turns it has all its bits.
  Vector scale_of(const PlacedPart& placed);
  /// The index of the mesh of this size, with the outline that the instance has.
  std::uint16_t index_of(const PlacedPart& placed, const Vector& scale);

 private:
  /// The index of the hull of this mesh.
  std::uint16_t hull_of(const PlacedPart& placed, const Mesh& mesh, const Vector& scale);

  ComposedScene& scene_;
  std::map<std::pair<std::size_t, std::size_t>, Vector> first_scales_;
  /// Part, size, what it is as a billboard, the width of its outline and its colour, what it has to do with shadows.
  using Key =
      std::tuple<std::size_t, std::size_t, Vector, Billboard, std::uint16_t, std::array<std::uint8_t, 3>, ShadowRole>;
  std::map<Key, std::uint16_t> known_;
  std::map<std::tuple<std::size_t, std::size_t, Vector, Billboard>, std::uint16_t> hulls_;
};

}  // namespace zstrip::sim
