// Lines and points of a model in fixed point.
#pragma once

#include "import/grid.hpp"

namespace zstrip::sim {

/// Adds a set of lines, a mesh without triangles and a material to `model` for each of the source, more of them where
/// one has more vertices than indices of 16 bits reach. On the grid of the model, so that a line along an edge has its
/// vertices. Fails beyond kMaxMeshes; the message starts with a verb.
Result<Done> add_lines(const SourceModel& source, const Grid& grid, Model& model);

}  // namespace zstrip::sim
