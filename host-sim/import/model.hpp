// An imported model: owns all that a Scene only views, in the renderer's fixed-point formats.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "import/source_model.hpp"
#include "result.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/skin.hpp"

namespace zstrip::sim {

/// From the file's units (after turning its up axis to +y) to the scene's: scene = (file - origin) * scale.
struct Units {
  std::array<double, 3> origin{0, 0, 0};
  double scale = 1;
};

/// The most that becoming fixed point has moved anything away from the file's values.
struct Accuracy {
  double size = 0;      ///< longest side of the bounding box, the file's units
  double position = 0;  ///< of a vertex, the file's units
  double normal = 0;    ///< degrees
  double texcoord = 0;  ///< texels
  double texel = 0;     ///< of a channel, 1 is its whole range
};

struct MeshData {
  std::vector<Position> positions;
  std::vector<Normal> normals;
  std::vector<Colour> colours;
  std::vector<TexCoord> texcoords;
  std::vector<Triangle> triangles;
  std::vector<Meshlet> meshlets;
  std::vector<VertexJoints> joints{};  ///< of a skin, else empty
};

/// A mesh of Model::meshes that joints move.
struct ModelSkin {
  std::size_t mesh = 0;  ///< index into Model::meshes, where it stands as it is at rest
  Mesh bind;             ///< as it was modelled
  std::span<const VertexJoints> vertices;
};

/// A joint of Model::joints, of the model's scene units.
struct ModelJoint {
  std::size_t parent = kNoSourceJoint;
  std::int32_t node = kNoNode;  ///< of Model::tree; none: it stays where its parent is
  double size = 1;              ///< of its coordinates, in the file's: they are as long as the scene's at rest
  double reach = 0;             ///< the farthest from it that a vertex is which it moves, itself or by other joints
};

/// All meshes lie in one common bounding box around the origin, whose longest side goes from -1 to 1, so that borders
/// which meshes share stay identical. Moving it keeps the views valid; it cannot be copied.
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
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Instance> instances;  ///< one for each mesh of triangles, untransformed
  std::vector<LineSet> lines;       ///< untransformed
  std::vector<std::int32_t> nodes;  ///< of each instance: the one of `tree` that moves it, or kNoNode
  NodeTree tree;                    ///< of the file, in its units
  std::vector<ModelSkin> skins;
  std::vector<Joint> joints;            ///< of all skins
  std::vector<JointPose> rest;          ///< of each joint
  std::vector<ModelJoint> joint_nodes;  ///< of each joint
  std::vector<DirectionalLight> lights;
  std::vector<PunctualLight> punctual_lights;
  std::vector<Finish> finishes;
  std::vector<std::string> material_names;  ///< one for each material, from the file; may be empty
  std::vector<SourceCamera> cameras;        ///< of the file, in its units
  Units units;
  Accuracy accuracy;
  double outlying = 1;                ///< as outlying_of()
  std::vector<std::string> warnings;  ///< what the picture will lack, one line each
};

/// How back faces of double-sided materials are lit.
enum class BackFaces : std::uint8_t {
  lit_alike,  ///< as front faces: they are meshes of their own
  as_front,   ///< by the normals of the front; what is drawn with other materials stays one mesh
};

/// Reads, repairs and quantises a model file. `up`: the axis that points upwards; empty: as the format says. The
/// failure's message is whole: it names the file.
Result<Model> import_model(const std::filesystem::path& path, std::optional<UpAxis> up = {},
                           Texcoords texcoords = Texcoords::of_textures, BackFaces back_faces = BackFaces::lit_alike,
                           Highlights highlights = Highlights::none);

}  // namespace zstrip::sim
