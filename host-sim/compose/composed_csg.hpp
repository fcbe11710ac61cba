// CSG of a composed scene: finds the instances of products, and checks that they can be solids.
#pragma once

#include <cstddef>
#include <span>

#include "compose/composed_scene.hpp"
#include "compose/placed_part.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Counts edges of a mesh's triangles that no other triangle has in the other direction, where corners in one place
/// count as one. Returns 0 for a closed mesh.
std::size_t open_edges(const Mesh& mesh);

/// Adds the products of the scene file. `placed`: the parts of the composed instances. Failures say the line of a
/// [[csg]].
Result<Done> add_products(const SceneFile& file, std::span<const PlacedPart> placed, ComposedScene& scene);

}  // namespace zstrip::sim
