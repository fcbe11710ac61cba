// A model as its file describes it: floating point, the file's own units, any size. What the import steps work on.
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

/// Compared and hashed as bytes: no padding, no negative zeros.
struct SourceVertex {
  std::array<float, 3> position{};  ///< the file's units, node transforms applied
  std::array<float, 3> normal{};    ///< unit, or zero: to be generated
  std::array<float, 2> texcoord{};  ///< v grows downwards
  std::array<std::uint8_t, 4> colour{255, 255, 255, 255};
  std::array<std::uint8_t, 4> joints{};   ///< of a skin, as VertexJoints has them
  std::array<std::uint8_t, 4> weights{};  ///< likewise
  friend bool operator==(const SourceVertex&, const SourceVertex&) = default;
};
static_assert(sizeof(SourceVertex) == 44);

struct SourceMesh {
  std::uint32_t material = 0;   ///< index into SourceModel::materials
  std::int32_t node = kNoNode;  ///< of SourceModel::nodes, which moves it; vertices are where they are at rest
  bool has_colours = false;
  bool has_texcoords = false;
  bool has_skin = false;  ///< joints move it: vertices are where they were modelled
  std::vector<SourceVertex> vertices;
  std::vector<std::uint32_t> indices;  ///< three a triangle, counter-clockwise seen from the front
};

/// Lines and points, which have no surface: they are as wide at any distance.
struct SourceLines {
  std::uint32_t material = 0;   ///< index into SourceModel::materials
  std::int32_t node = kNoNode;  ///< as SourceMesh::node
  bool has_colours = false;
  std::vector<SourceVertex> vertices;  ///< of which positions and colours count
  std::vector<std::uint32_t> indices;  ///< two a line; twice the same is a point
};

inline constexpr std::size_t kNoSourceJoint = static_cast<std::size_t>(-1);

/// What moves vertices of skins: a node that moves, or what hangs on one.
struct SourceJoint {
  std::size_t parent = kNoSourceJoint;  ///< an index below its own; none: the file's coordinates
  std::int32_t node = kNoNode;          ///< of SourceModel::nodes; none: it stays where its parent is
  Affine inverse_bind;                  ///< from where vertices were modelled to the joint's coordinates
  bool has_vertices = false;
};

inline constexpr std::uint32_t kNoSourceTexture = 0xFFFFFFFF;

/// What a texture shows beyond its borders, along one axis.
enum class TextureWrap : std::uint8_t { repeat, clamp, mirror };

struct SourceMaterial {
  std::string name;  ///< the file's, for messages; may be empty
  std::array<std::uint8_t, 3> colour{255, 255, 255};
  std::array<std::uint8_t, 3> emissive{};
  std::array<std::uint8_t, 3> specular{};  ///< colour of highlights, black: none
  std::uint8_t shininess = 32;             ///< their exponent
  AlphaMode alpha_mode = AlphaMode::opaque;
  std::uint8_t alpha = 255;                           ///< of the colour; 255 where alpha does nothing
  std::uint8_t alpha_cutoff = 128;                    ///< of what is masked
  std::uint32_t texture = kNoSourceTexture;           ///< index into SourceModel::textures
  std::uint32_t emissive_texture = kNoSourceTexture;  ///< times `emissive`, where `texture` is; index likewise
  std::array<TextureWrap, 2> wrap{TextureWrap::repeat, TextureWrap::repeat};  ///< of u and v
  bool lit = true;
  bool smooth = true;
  std::optional<bool> double_sided;  ///< empty: not in the file
};

/// Texture coordinates of materials without a texture: left out, or kept for a texture from elsewhere.
enum class Texcoords : std::uint8_t { of_textures, all };

/// Highlights of materials: left out, for they cost time at each vertex or pixel, or as the file says.
enum class Highlights : std::uint8_t { none, of_materials };

/// The axis of a model that shall point upwards. Formats disagree, and files do not always follow their format.
enum class UpAxis : std::uint8_t { plus_x, minus_x, plus_y, minus_y, plus_z, minus_z };

enum class SourceLightType : std::uint8_t { directional, point, spot };

struct SourceLight {
  SourceLightType type = SourceLightType::directional;
  std::array<double, 3> towards{0, 0, 1};  ///< unit vector towards a directional light, or against a spot's direction
  std::array<double, 3> colour{1, 1, 1};   ///< what arrives, of point and spot lights at distance 1; any scale >= 0
  std::array<double, 3> position{};        ///< of point and spot lights, the file's units
  double range = 0;                        ///< where the light of a point or spot ends; 0: it does not
  double inner = 0, outer = 0;             ///< radians off a spot's direction: fully lit, and lit at all; 0..pi/2
};

/// A camera of the file, for pictures of any shape.
struct SourceCamera {
  std::string name;                         ///< of its node, or its own
  std::string other_name{};                 ///< its own, where its node has one, too
  std::array<double, 3> eye{};              ///< the file's units
  std::array<double, 3> towards{0, 0, -1};  ///< unit vector, where it looks
  std::array<double, 3> up{0, 1, 0};        ///< a hint, any length
  bool orthographic = false;
  double field_of_view = 45;  ///< perspective: vertical, degrees
  double half_height = 1;     ///< orthographic: of what is seen, the file's units
};

struct SourceModel {
  std::vector<SourceMesh> meshes;
  std::vector<SourceLines> lines;
  std::vector<SourceMaterial> materials;
  std::vector<RgbImage> textures;
  std::vector<std::string> texture_names;  ///< one for each texture, for messages
  std::vector<SourceLight> lights;
  std::vector<SourceCamera> cameras;
  NodeTree nodes;                     ///< those that move, all with an inverse at rest
  std::vector<SourceJoint> joints;    ///< of all skins, at most 256
  std::vector<std::string> warnings;  ///< what the picture will lack, one line each
};

}  // namespace zstrip::sim
