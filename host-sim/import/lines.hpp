// Converts lines and points of a model to fixed point.
#pragma once

#include "import/grid.hpp"

namespace zstrip::sim {

/// Adds a set of lines, a mesh without triangles and a material to `model` for each set of the source; several of them
/// if a set has more vertices than indices of 16 bits can address. Vertices are on the model's grid, so that a line
/// along an edge has the edge's vertices. Fails above kMaxMeshes; the message starts with a verb.
Result<Done> add_lines(const SourceModel& source, const Grid& grid, Model& model);

}  // namespace zstrip::sim
