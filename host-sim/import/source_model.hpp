// A model as its file describes it: floating point, the file's own units, any size. The import steps change it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "image/rgb_image.hpp"
#include "motion/node_tree.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Compared and hashed as bytes: it must have no padding and no negative zeros.
struct SourceVertex {
  std::array<float, 3> position{};  ///< the file's units, node transforms applied, from SourceModel::origin
  std::array<float, 3> normal{};    ///< unit; zero: to be generated
  std::array<float, 2> texcoord{};  ///< v grows downwards
  std::array<std::uint8_t, 4> colour{255, 255, 255, 255};
  std::array<std::uint8_t, 4> joints{};   ///< of a skin, as in VertexJoints
  std::array<std::uint8_t, 4> weights{};  ///< of a skin, as in VertexJoints
  std::uint32_t morph = 0;                ///< 1 + index into SourceModel::morphs; 0: no morph target moves it
  friend bool operator==(const SourceVertex&, const SourceVertex&) = default;
};
static_assert(sizeof(SourceVertex) == 48);

struct SourceMesh {
  std::uint32_t material = 0;   ///< index into SourceModel::materials
  std::int32_t node = kNoNode;  ///< index into SourceModel::nodes, of the node that moves it; vertices are in the pose
                                ///< at rest
  bool has_colours = false;
  bool has_texcoords = false;
  bool has_skin = false;    ///< joints move it: vertices are as they were modelled
  bool has_morphs = false;  ///< morph targets move some of its vertices
  std::vector<SourceVertex> vertices;
  std::vector<std::uint32_t> indices;  ///< three a triangle, counter-clockwise seen from the front
};

/// Lines and points, which have no surface: their width is the same at any distance.
struct SourceLines {
  std::uint32_t material = 0;   ///< index into SourceModel::materials
  std::int32_t node = kNoNode;  ///< as in SourceMesh::node
  bool has_colours = false;
  std::vector<SourceVertex> vertices;  ///< only positions and colours are used
  std::vector<std::uint32_t> indices;  ///< two a line; twice the same is a point
};

inline constexpr std::size_t kNoSourceJoint = static_cast<std::size_t>(-1);

/// A joint that moves vertices of skins: a moving node, or a descendant of one.
struct SourceJoint {
  std::size_t parent = kNoSourceJoint;  ///< an index below the joint's own; none: the file's coordinates
  std::int32_t node = kNoNode;          ///< index into SourceModel::nodes; none: no movement relative to the parent
  Affine inverse_bind;                  ///< from the modelled vertices to the joint's coordinates
  bool has_vertices = false;
};

/// The change of a vertex for a weight of 1 of a morph target.
struct SourceMorphOffset {
  std::uint32_t weight = 0;         ///< index into SourceModel::weights
  std::array<float, 3> position{};  ///< added to SourceVertex::position
  std::array<float, 3> normal{};    ///< added to SourceVertex::normal, before that is scaled to a length of 1
};

/// A weight that animations change. Weights count from the file's weights at rest, at which vertices are stored.
struct SourceWeight {
  double low = 0, high = 1;  ///< the values for which a mesh has room, of all animations and of 0 and 1 in the file
};

inline constexpr std::uint32_t kNoSourceTexture = 0xFFFFFFFF;

/// The grey of models whose files have no colours. Assimp's own is darker.
inline constexpr std::array<std::uint8_t, 3> kDefaultColour{204, 204, 204};

/// The continuation of a texture beyond its borders, along one axis.
enum class TextureWrap : std::uint8_t { repeat, clamp, mirror };

struct SourceMaterial {
  std::string name;  ///< the file's, for messages; may be empty
  std::array<std::uint8_t, 3> colour{255, 255, 255};
  std::array<std::uint8_t, 3> emissive{};
  std::array<std::uint8_t, 3> specular{};  ///< colour of highlights, black: none
  std::uint8_t shininess = 32;             ///< their exponent
  AlphaMode alpha_mode = AlphaMode::opaque;
  std::uint8_t alpha = 255;                            ///< of the colour; 255 if alpha has no effect
  std::uint8_t alpha_cutoff = 128;                     ///< for AlphaMode::mask
  std::uint32_t texture = kNoSourceTexture;            ///< index into SourceModel::textures
  std::uint32_t emissive_texture = kNoSourceTexture;   ///< multiplied by `emissive`, at the coordinates of `texture`;
                                                       ///< index into SourceModel::textures
  std::uint32_t normal_texture = kNoSourceTexture;     ///< a normal map, at the coordinates of `texture`
  std::uint32_t occlusion_texture = kNoSourceTexture;  ///< an occlusion map in its red channel, likewise
  double normal_scale = 1;                             ///< of the map's components along the surface
  double occlusion_strength = 1;                       ///< 0: the map changes nothing, to 1
  std::array<TextureWrap, 2> wrap{TextureWrap::repeat, TextureWrap::repeat};  ///< of u and v
  double metallic = 0;                                                        ///< share of metal, 0..1
  double roughness = 1;                                                       ///< of the surface, 0: a mirror
  bool is_mirror = false;                                                     ///< `texture` is an environment map
  bool lit = true;
  bool smooth = true;
  std::optional<bool> double_sided;  ///< empty: the file does not say it
};

/// Texture coordinates of materials without a texture: removed, or kept for a texture from another source.
enum class Texcoords : std::uint8_t { of_textures, all };

/// Highlights of materials: removed, because they cost time at each vertex or pixel, or as in the file.
enum class Highlights : std::uint8_t { none, of_materials };

/// Plain: a matt surface of the material's colour and texture. Rich: smooth metals have an environment map of a studio,
/// and normal and occlusion maps are painted into textures.
enum class MaterialStyle : std::uint8_t { plain, rich };

/// The parts of a file's materials beyond colours and textures that are drawn.
struct Shine {
  Highlights highlights;
  MaterialStyle style;
  /// Not explicit, so that either can be written for a Shine.
  constexpr Shine(Highlights which = Highlights::none, MaterialStyle how = MaterialStyle::plain)
      : highlights(which), style(how) {}
};

/// The axis of a model that points upwards. Formats differ, and files do not always follow their format.
enum class UpAxis : std::uint8_t { plus_x, minus_x, plus_y, minus_y, plus_z, minus_z };

enum class SourceLightType : std::uint8_t { directional, point, spot };

struct SourceLight {
  SourceLightType type = SourceLightType::directional;
  std::array<double, 3> towards{0, 0, 1};  ///< unit vector towards a directional light, or against a spot's direction
  std::array<double, 3> colour{1, 1, 1};   ///< light that arrives, for point and spot lights at distance 1; any scale
                                           ///< >= 0
  std::array<double, 3> position{};        ///< for point and spot lights, in the file's units
  double range = 0;                        ///< distance at which the light of a point or spot ends; 0: unlimited
  double inner = 0, outer = 0;             ///< radians from a spot's direction: fully lit within `inner`, dark outside
                                           ///< `outer`; 0..pi/2
};

/// A camera of the file, for pictures of any shape.
struct SourceCamera {
  std::string name;                         ///< the name of its node, or its own
  std::string other_name{};                 ///< its own name if its node has a name, too
  std::array<double, 3> eye{};              ///< the file's units
  std::array<double, 3> towards{0, 0, -1};  ///< unit vector of the viewing direction
  std::array<double, 3> up{0, 1, 0};        ///< a hint, any length
  bool orthographic = false;
  double field_of_view = 45;  ///< perspective: vertical, degrees
  double half_height = 1;     ///< orthographic: half the visible height, in the file's units
  double near = 0;            ///< distance of the near plane, in the file's units; 0: the file does not say it
};

struct SourceModel {
  /// Positions of vertices begin here, because floats of places far away have no bits left for a model's details. All
  /// other places are in the file's coordinates.
  Vector origin{};
  std::vector<SourceMesh> meshes;
  std::vector<SourceLines> lines;
  std::vector<SourceMaterial> materials;
  std::vector<RgbImage> textures;
  std::vector<std::string> texture_names;  ///< one for each texture, for messages
  std::vector<SourceLight> lights;
  std::vector<SourceCamera> cameras;
  NodeTree nodes;                                      ///< the moving nodes, all with an inverse at rest
  std::vector<SourceJoint> joints;                     ///< of all skins, at most 256
  std::vector<std::vector<SourceMorphOffset>> morphs;  ///< of vertices; each has one offset at most for a weight
  std::vector<SourceWeight> weights;
  std::vector<std::string> warnings;  ///< features that are missing in the picture, one line each
};

/// Returns the vertex's place in the file's coordinates.
inline Vector place_of(const SourceModel& model, const SourceVertex& vertex) {
  return {model.origin[0] + double{vertex.position[0]}, model.origin[1] + double{vertex.position[1]},
          model.origin[2] + double{vertex.position[2]}};
}

}  // namespace zstrip::sim
