// Collects the surfaces of a file, which a reader finds, in the meshes of a source model.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "import/source_model.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Triangles, lines and points of one material from a reader; vertices have the coordinates of SourceMesh.
struct SourcePrimitive {
  std::uint32_t material = 0;   ///< index into SourceModel::materials
  std::int32_t node = kNoNode;  ///< as in SourceMesh::node
  bool has_colours = false, has_texcoords = false, has_skin = false, has_morphs = false;
  bool mirrored = false;                ///< a node mirrors it: the winding of triangles is restored
  bool vertex_alpha = false;            ///< alpha of vertex colours differs, and has an effect
  bool left_at_rest = false;            ///< has morph targets that an animation may move, and that are left out
  std::uint64_t bad_texcoords = 0;      ///< vertices whose texture coordinates are not finite, and were set to 0
  std::vector<SourceVertex> vertices;   ///< without positions
  std::vector<Vector> positions;        ///< one for each vertex, in the file's coordinates
  std::vector<std::uint32_t> indices;   ///< three a triangle; may be out of range
  std::vector<std::uint32_t> segments;  ///< two a line, twice the same for a point; may be out of range
};

class MeshGroups {
 public:
  explicit MeshGroups(SourceModel& model) : model_(model) {}

  /// Adds the parts that can be drawn to the mesh of their kind. The first ones choose the model's origin. Fails above
  /// kMaxTriangles; the message starts with a verb.
  Result<Done> add(SourcePrimitive primitive);
  bool is_empty() const { return triangles_seen_ + segments_seen_ == 0; }
  /// Fails if nothing can be drawn; otherwise adds warnings for the parts that were left out.
  Result<Done> finish();

 private:
  void choose_origin(const std::vector<Vector>& positions);
  SourceMesh& mesh_for(const SourcePrimitive& primitive);
  void add_triangles(const SourcePrimitive& primitive);
  void add_segments(const SourcePrimitive& primitive);

  SourceModel& model_;
  /// Groups by material, colours, texture coordinates, node, skin, morph targets, and a number for separate meshes.
  std::map<std::tuple<std::uint32_t, bool, bool, std::int32_t, bool, bool, std::uint32_t>, std::size_t> groups_;
  /// Groups of lines, by material, colours, node.
  std::map<std::tuple<std::uint32_t, bool, std::int32_t>, std::size_t> line_groups_;
  bool has_origin_ = false;
  std::uint64_t vertices_ = 0;
  std::uint64_t triangles_seen_ = 0;
  std::uint64_t segments_seen_ = 0;
  std::uint64_t kept_ = 0;  ///< triangles and segments
  std::uint64_t not_finite_ = 0;
  std::uint64_t bad_index_ = 0;
  std::uint64_t vertex_alpha_ = 0;
  std::uint64_t morphs_ = 0;
  std::uint64_t bad_texcoords_ = 0;
  std::uint64_t no_texcoords_ = 0;  ///< primitives whose material has a texture
  std::uint64_t bent_segments_ = 0;
  std::uint64_t bad_segments_ = 0;
};

}  // namespace zstrip::sim
