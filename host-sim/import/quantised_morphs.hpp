// Converts morph targets to fixed point: the box that holds a mesh with any weights, and the tables of targets.
#pragma once

#include <cstdint>
#include <vector>

#include "import/grid.hpp"
#include "import/model.hpp"
#include "import/source_box.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// Returns the places of a vertex with all weights within their ranges: a box, of one point without morph targets.
SourceBox places_of(const SourceModel& source, const SourceVertex& vertex);

/// Visits the vertex's place, or the corners of places_of().
template <class Visit>
void for_each_place(const SourceModel& source, const SourceVertex& vertex, const Visit& visit) {
  if (vertex.morph == 0) {
    visit(place_of(source, vertex));
  } else {
    for_each_corner(places_of(source, vertex), visit);
  }
}

/// Returns the box of a mesh with all weights within their ranges.
SourceBox box_of_morphs(const SourceModel& source, const SourceMesh& mesh);
/// Returns the largest component of all offsets of the mesh's vertices, in the file's units; 0 without morph targets.
double longest_offset(const SourceModel& source, const SourceMesh& mesh);

/// Adds the targets of the model's last mesh to `model.morphs`, if there are any: offsets of less than half a step are
/// left out. `grid`: the mesh's. `vertices`: as MeshData::morphs.
void add_morph(const SourceModel& source, const Grid& grid, const std::vector<std::uint32_t>& vertices, Model& model);

}  // namespace zstrip::sim
