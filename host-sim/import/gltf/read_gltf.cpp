// Reads a glTF 2.0 file.
#include "import/gltf/read_gltf.hpp"

#include "import/gltf/accessors.hpp"
#include "import/gltf/animations.hpp"
#include "import/gltf/buffers.hpp"
#include "import/gltf/damage.hpp"
#include "import/gltf/extensions.hpp"
#include "import/gltf/lights_and_cameras.hpp"
#include "import/gltf/materials.hpp"
#include "import/gltf/morphs.hpp"
#include "import/gltf/nodes.hpp"
#include "import/gltf/primitives.hpp"
#include "import/gltf/textures.hpp"
#include "import/gltf/types.hpp"

namespace zstrip::sim {

Result<SourceModel> read_gltf(const GltfDocument& document, const ReadUri& read_uri, const Affine& turn,
                              Texcoords texcoords, Shine shine) {
  const GltfJson& json = document.json;
  if (const Result<Done> checked = check_gltf_types(json); !checked) {
    return unreadable_model(checked.failure().message);
  }
  SourceModel model;
  model.warnings = document.warnings;
  warn_of_gltf_damage(json, model.warnings);
  if (const Result<Done> known = check_gltf_extensions(json, model.warnings); !known) return known.failure();
  GltfBuffers buffers(document, read_uri);
  GltfAccessors accessors(document, buffers);
  Result<GltfNodes> nodes = GltfNodes::read(json, turn);
  if (!nodes) return unreadable_model(nodes.failure().message);
  nodes->set_moved(nodes_of_animations(json, accessors), turn, model);
  GltfMorphs morphs(json);
  if (const Result<Done> read = read_gltf_animations(json, accessors, *nodes, morphs, model); !read) {
    return unreadable_model(read.failure().message);
  }
  GltfTextures textures(document, buffers, model);
  GltfMaterials materials(json, textures, shine, model);
  materials.read_all();
  GltfPrimitives primitives(json, buffers, accessors, *nodes, materials, morphs, texcoords, model);
  if (const Result<Done> read = primitives.read_all(); !read) return read.failure();
  read_gltf_lights(json, *nodes, model);
  read_gltf_cameras(json, *nodes, model);
  return model;
}

}  // namespace zstrip::sim
