// The meshes of a composed scene: each once for each size that it has in the scene.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "compose/composed_scene.hpp"
#include "compose/placed_part.hpp"

namespace zstrip::sim {

/// For Outline::hull if a mesh has too many vertices for one hull.
inline constexpr std::uint16_t kNoHull = kOwnMesh - 1;

class ComposedMeshes {
 public:
  /// Meshes are added to `scene`, whose units must be set.
  explicit ComposedMeshes(ComposedScene& scene) : scene_(scene) {}

  /// Returns the size of a part in the scene, which is applied to its mesh, so that its rotation keeps full precision.
  Vector scale_of(const PlacedPart& placed);
  /// Returns the index of the mesh with this size and with the outline of the instance, if its hull has an area.
  std::uint16_t index_of(const PlacedPart& placed, const Vector& scale);

 private:
  /// Returns the index of the hull of this mesh; none if its triangles have no area in the scene's fixed point.
  std::optional<std::uint16_t> hull_of(const PlacedPart& placed, const Mesh& mesh, const Vector& scale);

  ComposedScene& scene_;
  std::map<std::pair<std::size_t, std::size_t>, Vector> first_scales_;
  /// Part, size, kind of billboard, width and colour of its outline, role for shadows.
  using Key =
      std::tuple<std::size_t, std::size_t, Vector, Billboard, std::uint16_t, std::array<std::uint8_t, 3>, ShadowRole>;
  std::map<Key, std::uint16_t> known_;
  std::map<std::tuple<std::size_t, std::size_t, Vector, Billboard>, std::optional<std::uint16_t>> hulls_;
};

/// Leaves out the normals of meshes that neither light, nor an environment, nor an outline needs: headers and blobs are
/// smaller, and the picture is the same.
void leave_out_unread_normals(ComposedScene& scene);

}  // namespace zstrip::sim
