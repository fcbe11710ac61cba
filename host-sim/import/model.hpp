// An imported model: owns all data that a Scene refers to, in the renderer's fixed-point formats.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "import/reduction.hpp"
#include "import/source_model.hpp"
#include "result.hpp"
#include "zstrip/morph.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/skin.hpp"

namespace zstrip::sim {

/// Converts the file's units (after its upward axis has become +y) to the scene's: scene = (file - origin) * scale.
struct Units {
  std::array<double, 3> origin{0, 0, 0};
  double scale = 1;
};

/// The largest errors of the conversion from the file's values to fixed point.
struct Accuracy {
  double size = 0;      ///< longest side of the bounding box, the file's units
  double position = 0;  ///< of a vertex, the file's units
  double normal = 0;    ///< degrees
  double texcoord = 0;  ///< texels
  double texel = 0;     ///< of a channel; 1 is its whole range
};

struct MeshData {
  std::vector<Position> positions;
  std::vector<Normal> normals;
  std::vector<Colour> colours;
  std::vector<TexCoord> texcoords;
  std::vector<Triangle> triangles;
  std::vector<Meshlet> meshlets;
  std::vector<VertexJoints> joints{};   ///< of a skin, else empty
  std::vector<std::uint32_t> morphs{};  ///< SourceVertex::morph of each vertex; empty without morph targets
};

/// Returns `mesh` with views of `data`.
inline Mesh with_data(Mesh mesh, const MeshData& data) {
  mesh.positions = data.positions;
  mesh.normals = data.normals;
  mesh.colours = data.colours;
  mesh.texcoords = data.texcoords;
  mesh.triangles = data.triangles;
  mesh.meshlets = data.meshlets;
  return mesh;
}

/// The tables of a morph target.
struct MorphTables {
  std::vector<MorphRun> runs;
  std::vector<MorphOffset> positions;
  std::vector<NormalOffset> normals;
};

/// A mesh of Model::meshes that morph targets move. Weights are those of Model::weights.
struct ModelMorph {
  std::size_t mesh = 0;  ///< index into Model::meshes, whose mesh has all weights 0, and joints at rest
  Mesh base;             ///< with all weights 0, as a skin's joints move it further
  std::vector<MorphTarget> targets;
};

/// A weight of morph targets that animations change; 0 is the file's weight at rest.
struct ModelWeight {
  double reach = 0;  ///< largest distance by which a weight of 1 moves a vertex, in scene units
};

/// A mesh of Model::meshes that joints move.
struct ModelSkin {
  std::size_t mesh = 0;  ///< index into Model::meshes, whose mesh is in the pose at rest
  Mesh bind;             ///< the mesh as it was modelled
  std::span<const VertexJoints> vertices;
};

/// A joint of Model::joints, in the model's scene units.
struct ModelJoint {
  std::size_t parent = kNoSourceJoint;
  std::int32_t node = kNoNode;  ///< index into Model::tree; none: no movement relative to the parent
  double size = 1;              ///< length in the file of a unit of its coordinates, which at rest is a unit of the
                                ///< scene
  double reach = 0;             ///< distance to the farthest vertex that it moves, directly or through other joints
};

/// All meshes are in one common bounding box around the origin, whose longest side goes from -1 to 1, so that common
/// borders of meshes stay identical. Moving a Model keeps the views valid; it cannot be copied.
class Model {
 public:
  Model() = default;
  Model(Model&&) = default;
  Model& operator=(Model&&) = default;
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  std::deque<MeshData> mesh_data;
  std::deque<std::vector<std::uint16_t>> texels;
  std::deque<std::vector<Segment>> segments;
  std::deque<MorphTables> morph_tables;
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Instance> instances;  ///< one for each mesh of triangles, untransformed
  std::vector<LineSet> lines;       ///< untransformed
  std::vector<std::int32_t> nodes;  ///< for each instance: the node of `tree` that moves it, or kNoNode
  NodeTree tree;                    ///< the file's nodes, in its units
  std::vector<ModelSkin> skins;
  std::vector<ModelMorph> morphs;
  std::vector<ModelWeight> weights;
  std::vector<Joint> joints;            ///< of all skins
  std::vector<JointPose> rest;          ///< of each joint
  std::vector<ModelJoint> joint_nodes;  ///< of each joint
  std::vector<DirectionalLight> lights;
  std::vector<PunctualLight> punctual_lights;
  std::vector<Finish> finishes;
  std::vector<std::string> material_names;  ///< one for each material, from the file; may be empty
  std::vector<SourceCamera> cameras;        ///< the file's cameras, in its units
  Units units;
  Accuracy accuracy;
  std::optional<Reduced> reduced;     ///< if triangles were to be removed
  std::optional<Shrunk> shrunk;       ///< if textures were limited
  double outlying = 1;                ///< as outlying_of()
  std::vector<std::string> warnings;  ///< features that are missing in the picture, one line each

  /// Returns the morph targets of a mesh, or null if it has none.
  const ModelMorph* morph_of(std::size_t mesh) const {
    const auto found = std::ranges::find(morphs, mesh, &ModelMorph::mesh);
    return found == morphs.end() ? nullptr : &*found;
  }
};

/// Selects the light of back faces of double-sided materials.
enum class BackFaces : std::uint8_t {
  lit_alike,  ///< like front faces: they are separate meshes
  as_front,   ///< by the normals of the front; meshes with other materials need not be divided
};

/// Reads, repairs, reduces and quantises a model file. `up`: the axis that points upwards; empty: the format's axis.
/// The failure's message is complete: it names the file.
Result<Model> import_model(const std::filesystem::path& path, std::optional<UpAxis> up = {},
                           Texcoords texcoords = Texcoords::of_textures, BackFaces back_faces = BackFaces::lit_alike,
                           Shine shine = {}, const Reduction& reduction = {});

}  // namespace zstrip::sim
