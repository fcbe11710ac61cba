// Properties of a model's surface across meshes: corners that meet, closed parts, missing normals.
#pragma once

#include "import/source_model.hpp"

namespace zstrip::sim {

/// Faces that meet at less than this angle (degrees) are shaded as one smooth surface.
inline constexpr double kCreaseAngle = 60;

/// Sets the normal of every vertex without one to the mean of the faces around it, weighted by their angles, with
/// creases. Such meshes then have three separate vertices for each triangle; weld() joins equal vertices.
void generate_missing_normals(SourceModel& model);

/// The visibility of a mesh's back faces.
struct Outside {
  /// The mesh is the outside of closed bodies: each edge is used as often in one direction as in the other, and the
  /// volume inside is positive. Only then are back faces culled without a request.
  bool is_closed = false;
  /// The area of its openings, as a share of its area: 0 closed, 1 a flat sheet, 0.2 a cube without a lid.
  double opening = 0;
  friend bool operator==(const Outside&, const Outside&) = default;
};

/// Returns one entry for each mesh.
std::vector<Outside> find_outsides(const SourceModel& model);

/// Joins vertices that are equal in every byte and removes unused ones.
void weld(SourceMesh& mesh);

}  // namespace zstrip::sim
