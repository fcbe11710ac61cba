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
#include "import/gltf/nodes.hpp"
#include "import/gltf/skins.hpp"
#include "import/mesh_groups.hpp"
#include "import/source_model.hpp"
#include "result.hpp"

namespace zstrip::sim {

class GltfPrimitives {
 public:
  GltfPrimitives(const GltfJson& json, GltfBuffers& buffers, GltfAccessors& accessors, const GltfNodes& nodes,
                 const GltfMaterials& materials, Texcoords texcoords, SourceModel& model);

  /// Reads all of the scene's nodes. The failure's message starts with a verb.
  Result<Done> read_all();

 private:
  /// The numbers of a primitive's vertices, as in the file.
  struct Vertices {
    GltfValues<float> positions, normals, colours, texcoords;
  };

  void set_alpha(const GltfValues<float>& colours, SourcePrimitive& to);
  void set_opaque(SourcePrimitive& to);
  /// Adds the primitives of a mesh on a node. `copy`: from the mesh to the node's coordinates.
  Result<Done> add_mesh(const GltfJson& mesh, std::size_t node, const Affine& copy);
  /// Returns the places of EXT_mesh_gpu_instancing on a node; one without effect if the node has none.
  Result<std::vector<Affine>> copies_on(const GltfJson& node);
  /// Empty: nothing to draw. The failure's message is a reason, as for the functions below.
  Result<SourcePrimitive> read_primitive(const GltfJson& mesh, const GltfJson& primitive, std::size_t node,
                                         const Affine& copy);
  Result<Vertices> read_vertices(const GltfJson& primitive, const GltfAttributes& attributes);
  Result<Done> add_morphs(const GltfJson& mesh, const GltfJson& primitive, std::size_t node, Vertices& vertices);

  const GltfJson& json_;
  GltfBuffers& buffers_;
  GltfAccessors& accessors_;
  const GltfNodes& nodes_;
  const GltfMaterials& materials_;
  Texcoords texcoords_;
  SourceModel& model_;
  GltfSkins skins_;
  MeshGroups groups_;
  /// Materials with the alpha of vertices, by the file's material and that alpha.
  std::map<std::pair<std::uint32_t, std::uint8_t>, std::uint32_t> with_alpha_;
  std::map<std::uint32_t, std::uint32_t> opaque_;  ///< opaque copies of materials that blend but have no transparent
                                                   ///< texel
  bool animations_morph_ = false;
  std::uint64_t invisible_ = 0;     ///< nodes with meshes that the file hides
  std::uint64_t no_texcoords_ = 0;  ///< primitives whose texture has no texture coordinates
};

}  // namespace zstrip::sim
