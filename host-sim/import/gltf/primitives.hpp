// Primitives of a glTF file's meshes: vertices and triangles, placed in the file's coordinates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "import/gltf/accessors.hpp"
#include "import/gltf/attributes.hpp"
#include "import/gltf/buffers.hpp"
#include "import/gltf/json.hpp"
#include "import/gltf/materials.hpp"
#include "import/gltf/morphs.hpp"
#include "import/gltf/nodes.hpp"
#include "import/gltf/skins.hpp"
#include "import/mesh_groups.hpp"
#include "import/source_model.hpp"
#include "result.hpp"

namespace zstrip::sim {

class GltfPrimitives {
 public:
  GltfPrimitives(const GltfJson& json, GltfBuffers& buffers, GltfAccessors& accessors, const GltfNodes& nodes,
                 const GltfMaterials& materials, const GltfMorphs& morphs, Texcoords texcoords, SourceModel& model);

  /// Reads all of the scene's nodes. The failure's message starts with a verb.
  Result<Done> read_all();

 private:
  /// The numbers of a primitive's vertices, as in the file.
  struct Vertices {
    GltfValues<float> positions, normals, colours, texcoords;
    /// One list for each vertex if animations move targets, else empty. In the mesh's coordinates.
    std::vector<std::vector<SourceMorphOffset>> morphs{};
  };

  void set_alpha(const GltfValues<float>& colours, SourcePrimitive& to);
  void set_opaque(SourcePrimitive& to);
  /// Adds the primitives of a mesh on a node. `copy`: from the mesh to the node's coordinates.
  Result<Done> add_mesh(const GltfJson& mesh, std::size_t node, const Affine& copy);
  /// Returns the places of EXT_mesh_gpu_instancing on a node; one without effect if the node has none.
  Result<std::vector<Affine>> copies_on(const GltfJson& node);
  /// Empty: nothing to draw. The failure's message is a reason, as for the functions below.
  Result<SourcePrimitive> read_primitive(const GltfJson& primitive, std::size_t node, const Affine& copy);
  Result<Vertices> read_vertices(const GltfJson& primitive, const GltfAttributes& attributes);
  /// Adds targets at rest to the vertices, and lists what moving targets add to each of them.
  Result<Done> add_morphs(const GltfJson& primitive, std::size_t node, Vertices& vertices);
  Result<Done> add_moved_target(const GltfJson& target, const GltfMorphs::Moved& moved, Vertices& vertices);
  /// Returns SourceVertex::morph for offsets, which are the same as those of another vertex or new.
  std::uint32_t morph_of(const std::vector<SourceMorphOffset>& offsets);

  const GltfJson& json_;
  GltfBuffers& buffers_;
  GltfAccessors& accessors_;
  const GltfNodes& nodes_;
  const GltfMaterials& materials_;
  const GltfMorphs& morphs_;
  Texcoords texcoords_;
  SourceModel& model_;
  GltfSkins skins_;
  MeshGroups groups_;
  /// Materials with the alpha of vertices, by the file's material and that alpha.
  std::map<std::pair<std::uint32_t, std::uint8_t>, std::uint32_t> with_alpha_;
  std::map<std::uint32_t, std::uint32_t> opaque_;  ///< opaque copies of materials that blend but have no transparent
                                                   ///< texel
  std::map<std::vector<float>, std::uint32_t> known_morphs_;  ///< by weights, positions and normals
  std::uint64_t invisible_ = 0;                               ///< nodes with meshes that the file hides
  std::uint64_t bad_offsets_ = 0;                             ///< of morph targets, that are not finite
};

}  // namespace zstrip::sim
