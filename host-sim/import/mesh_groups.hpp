// Gathers what a reader finds of a file's surfaces into the meshes of a source model.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "import/source_model.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Triangles, lines and points of one material as a reader finds them; vertices are where SourceMesh has them.
struct SourcePrimitive {
  std::uint32_t material = 0;   ///< index into SourceModel::materials
  std::int32_t node = kNoNode;  ///< as SourceMesh::node
  bool has_colours = false, has_texcoords = false, has_skin = false;
  bool mirrored = false;            ///< a node turned it inside out: triangles are turned back
  bool vertex_alpha = false;        ///< of vertex colours differs, and would count
  bool morphs = false;              ///< an animation would change its shape
  std::uint64_t bad_texcoords = 0;  ///< vertices whose texture coordinates are not finite, and became 0
  std::vector<SourceVertex> vertices;
  std::vector<std::uint32_t> indices;   ///< three a triangle; any numbers
  std::vector<std::uint32_t> segments;  ///< two a line, twice the same for a point; any numbers
};

class MeshGroups {
 public:
  explicit MeshGroups(SourceModel& model) : model_(model) {}

  /// Adds to the mesh of its kind what of it can be drawn. Fails beyond kMaxTriangles; the message starts with a verb.
  Result<Done> add(const SourcePrimitive& primitive);
  /// Fails where nothing can be drawn; else adds warnings for what has been left out.
  Result<Done> finish();

 private:
  SourceMesh& mesh_for(const SourcePrimitive& primitive);
  void add_triangles(const SourcePrimitive& primitive);
  void add_segments(const SourcePrimitive& primitive);

  SourceModel& model_;
  /// By material, colours, texture coordinates, node, skin; and a number where meshes must stay apart.
  std::map<std::tuple<std::uint32_t, bool, bool, std::int32_t, bool, std::uint32_t>, std::size_t> groups_;
  /// Of lines: by material, colours, node.
  std::map<std::tuple<std::uint32_t, bool, std::int32_t>, std::size_t> line_groups_;
  std::uint64_t vertices_ = 0;
  std::uint64_t triangles_seen_ = 0;
  std::uint64_t segments_seen_ = 0;
  std::uint64_t kept_ = 0;  ///< triangles and segments
  std::uint64_t not_finite_ = 0;
  std::uint64_t bad_index_ = 0;
  std::uint64_t vertex_alpha_ = 0;
  std::uint64_t morphs_ = 0;
  std::uint64_t bad_texcoords_ = 0;
  std::uint64_t bent_segments_ = 0;
  std::uint64_t bad_segments_ = 0;
};

}  // namespace zstrip::sim
