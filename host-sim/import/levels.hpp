// Finds coarser meshes for a scene's levels of detail.
#pragma once

#include <deque>
#include <span>
#include <vector>

#include "import/model.hpp"
#include "zstrip/levels.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// A coarser mesh of a mesh of the scene.
struct CoarserMesh {
  std::uint16_t mesh = 0;  ///< index into Scene::meshes
  Mesh coarser;            ///< refers to SceneLevels::data
  double error = 0;        ///< the length by which the surface moved at most, by the simplifier's measure
};

struct SceneLevels {
  std::vector<CoarserMesh> meshes;  ///< ascending by mesh; of one mesh the finest first
  std::deque<MeshData> data;
};

/// Finds up to three levels for each mesh that an instance has, each with a quarter of the triangles of the one before,
/// if so few are possible, at least kMinLevelTriangles. `left_out`: meshes that get none. Each level fits to the
/// borders of all other meshes.
SceneLevels find_levels(const Scene& scene, std::span<const std::size_t> left_out);

inline constexpr std::size_t kMinLevelTriangles = 16;

}  // namespace zstrip::sim
