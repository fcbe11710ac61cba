// Levels of detail: far instances are drawn with coarser meshes. The table lies in flash or in a blob, and
// choose_levels() writes the choice into instances in RAM, after pose() and before begin_frame:
//     choose_levels(kLevels, kScene, camera, instances);
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/status.hpp"

namespace zstrip {

inline constexpr std::size_t kMaxDetailLevels = 8;  ///< of a mesh, in addition to itself

/// A coarser mesh for the instances of a mesh, from a distance on.
struct DetailLevel {
  std::uint16_t mesh;     ///< index into Scene::meshes, of the mesh that instances have
  std::uint16_t coarser;  ///< index into Scene::meshes
  Fixed distance;         ///< 16.16, along the viewing direction, of the centre of `mesh` from the camera; >= 0
};

/// Returns Error::mesh (`needed` = index of the level) unless levels ascend by mesh and then by distance, their coarser
/// meshes ascend, too, and each of these can take the place of its mesh in every plan and effect: it has no more
/// triangles, vertices, meshlets and edges, no larger meshlet, the same tables of normals, colours and texture
/// coordinates, and no levels of its own, and neither of both has an outline or a skin. `scene` must be valid.
Status validate(std::span<const DetailLevel> levels, const Scene& scene);

/// Gives each instance the coarsest mesh whose distance it has reached, or its own. `at_rest` has the instances with
/// their own meshes; `instances`, as many, have the transforms of the frame. With an orthographic camera all keep their
/// own. Safe for levels that passed validate. The result has the same bits on every target.
void choose_levels(std::span<const DetailLevel> levels, const Scene& at_rest, const Camera& camera,
                   std::span<Instance> instances);

}  // namespace zstrip
