// Makes a model smaller before it is converted: shrinks textures, removes triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "import/source_model.hpp"

namespace zstrip::sim {

/// The limits that the user sets for a model.
struct Reduction {
  std::uint32_t texture_side = 0;  ///< texels of a texture's longer side, a power of two; 0: unlimited
  bool fold_textures = false;      ///< vertices get the colours of opaque textures, which are removed
  std::uint64_t triangles = 0;     ///< of all meshes together; 0: unlimited
  double triangle_share = 1;       ///< of the file's triangles, above 0

  bool removes_triangles() const { return triangles > 0 || triangle_share < 1; }
};

/// Why triangles stay that exceed a limit, and what the user can do.
inline constexpr const char* kTrianglesStay =
    "three or more materials, flat faces or parts of a texture meet at their vertices; a modeller can shade faces "
    "smooth";

/// The result of removing triangles.
struct Reduced {
  std::uint64_t triangles_before = 0, triangles = 0;  ///< of the file; back faces that become meshes are not counted
  bool keeps_limit = true;
  bool slides = false;  ///< vertices went at which colours, joints or the texture change visibly
  double error = 0;  ///< how far the surface moved at most, by the simplifier's measure, in the units of the vertices
};

/// The textures that were made smaller than without a limit.
struct Shrunk {
  std::size_t textures = 0;
  std::uint64_t texels_before = 0, texels = 0;  ///< of these textures; before: without a limit
};

/// Makes the sides of all textures powers of two, at most kMaxTextureSide. `side`, a power of two: textures whose
/// longer side would be longer get sides that are halved until it is not, and each texel the mean of its area; 0:
/// unlimited.
Shrunk fit_textures(SourceModel& model, std::uint32_t side);

/// Removes vertices where the surface changes least, from all meshes by the same error in the file's units, until the
/// limit of triangles is kept or nothing more can be removed. Meshes that move together are one surface: edges that two
/// triangles share stay shared, across meshes and seams of texture coordinates, too. Flat faces stay flat. Vertices
/// stay where open borders of parts that move apart meet; and, unless that takes more than twice the error, where
/// colours or joints change across a triangle, or the texture would slide visibly. Meshes may end up without triangles.
/// Expects welded meshes with normals.
Reduced remove_triangles(SourceModel& model, const Reduction& reduction);

/// A mesh from which triangles were removed.
struct ReducedMesh {
  std::uint64_t triangles = 0;
  double error = 0;  ///< as Reduced::error
};

/// Removes triangles from each mesh by itself, until its share is left or no vertex can go that is not kept as in
/// remove_triangles. Vertices on open borders that meshes share stay, so that each reduced mesh fits to the others as
/// they were. Expects welded meshes with normals and triangles; none may bend.
std::vector<ReducedMesh> reduce_each(SourceModel& model, double share);

}  // namespace zstrip::sim
