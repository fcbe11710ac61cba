// The box in which a mesh's positions are expressed: 16 bits along each axis.
#pragma once

#include <array>

#include "import/model.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// A box, and the conversion to its steps.
struct Grid {
  Units units;
  Vector vertices_from{};  ///< SourceModel::origin
  Vec3 centre{};           // 16.16
  Vec3 half_extent{};      // 16.16

  /// `from`: as SourceVertex::position.
  Position position(const std::array<float, 3>& from) const;
  /// Returns the steps of an offset between two positions along x; the half extents must be equal and not 0.
  double steps_of(double offset) const;
};

/// Returns the common bounding box of the model, with which common borders of meshes stay identical.
Grid fit_grid(const SourceModel& source);
/// Returns the grid of a mesh that blends: the box of its own vertices, by whose distance the renderer sorts it.
Grid grid_of_own(const SourceMesh& mesh, const Grid& whole);
/// Returns the grid of a mesh with a skin or with morph targets: all poses, with a margin, equal along all axes.
Grid grid_of_moved(const SourceModel& source, const SourceMesh& mesh, const Grid& whole);

}  // namespace zstrip::sim
