// Makes a model smaller before it is converted: halves textures, removes triangles.
#pragma once

#include <cstdint>

#include "import/source_model.hpp"

namespace zstrip::sim {

/// The limits that the user sets for a model.
struct Reduction {
  std::uint32_t texture_side = 0;  ///< texels of a texture's longer side, a power of two; 0: unlimited
  std::uint64_t triangles = 0;     ///< of all meshes together; 0: unlimited
  double triangle_share = 1;       ///< of the file's triangles, above 0

  bool removes_triangles() const { return triangles > 0 || triangle_share < 1; }
};

/// The result of removing triangles.
struct Reduced {
  std::uint64_t triangles_before = 0, triangles = 0;  ///< of the file; back faces that become meshes are not counted
  bool keeps_limit = true;
  double error = 0;  ///< how far the surface moved at most, by the simplifier's measure, in the units of the vertices
};

/// Halves the sides of each texture, whose sides are powers of two, until the longer one is at most `side`.
void shrink_textures(SourceModel& model, std::uint32_t side);

/// Removes vertices where the surface changes least, from all meshes by the same error, until the limit of triangles is
/// kept or nothing more can be removed. Vertices at the borders of a mesh stay, and so do triangles across which vertex
/// colours change; seams of texture coordinates and creases stay closed. Expects welded meshes with normals.
Reduced remove_triangles(SourceModel& model, const Reduction& reduction);

}  // namespace zstrip::sim
