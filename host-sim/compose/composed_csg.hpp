// CSG of a composed scene: which instances they are of, and whether those can be solids.
#pragma once

#include <cstddef>
#include <span>

#include "compose/composed_scene.hpp"
#include "compose/placed_part.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Edges of a mesh's triangles that no other triangle has in the other direction, where corners in one place count as
/// one; 0 of what is closed.
std::size_t open_edges(const Mesh& mesh);

/// Adds the products of the scene file. `placed`: what the composed instances are. Failures name the line of a [[csg]].
Result<Done> add_products(const SceneFile& file, std::span<const PlacedPart> placed, ComposedScene& scene);

}  // namespace zstrip::sim
