// What a model's surface is as a whole, across meshes: which corners meet, where it is closed, which normals it lacks.
#pragma once

#include "import/source_model.hpp"

namespace zstrip::sim {

/// Faces that meet at less than this angle (degrees) are shaded as one smooth surface.
inline constexpr double kCreaseAngle = 60;

/// Gives every vertex without a normal the mean of the faces around it, weighted by their angles, creases kept.
/// Such meshes come out with three vertices of their own a triangle; weld() joins what is equal.
void generate_missing_normals(SourceModel& model);

/// How much of a mesh's back faces can be seen.
struct Outside {
  /// It is the outside of closed bodies: each edge is used as often in one direction as in the other, and the volume
  /// inside is positive. Only then may back faces be culled unasked.
  bool is_closed = false;
  /// Through its openings, as a share of its area: 0 closed, 1 a flat sheet, 0.2 a cube without a lid.
  double opening = 0;
  friend bool operator==(const Outside&, const Outside&) = default;
};

/// Of each mesh.
std::vector<Outside> find_outsides(const SourceModel& model);

/// Joins vertices that are equal in every byte and drops those that no triangle uses.
void weld(SourceMesh& mesh);

}  // namespace zstrip::sim
