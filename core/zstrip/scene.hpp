// The scene, which the renderer reads: views of the caller's memory, which may lie in flash. The renderer neither
// copies nor writes it. All of it must stay alive from begin_frame to the last draw_strip.
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/base/fixed.hpp"

namespace zstrip {

/// A vertex inside its mesh's bounding box: centre + half_extent * position / 32768. -32767..32767.
struct Position {
  std::int16_t x, y, z;  ///< in 1/32768 of the half extent
};

/// A unit vector, 1.7. `unused` fills the normal up to one word.
struct Normal {
  std::int8_t x, y, z, unused;  ///< 1.7; `unused`: any value
};

/// 0..255 a channel.
struct Colour {
  std::uint8_t r, g, b, a;  ///< red, green, blue, alpha: 255 is full, or opaque
  friend constexpr bool operator==(const Colour&, const Colour&) = default;
};

/// Texture coordinates with Mesh::texcoord_bits fraction bits; 1.0 is the whole texture. v grows downwards (as in
/// glTF).
struct TexCoord {
  std::int16_t u, v;  ///< to the right, and down; textures repeat outside 0..1
};

/// Indices into the mesh's vertices; counter-clockwise seen from the front.
struct Triangle {
  std::uint16_t a, b, c;  ///< each below the number of Mesh::positions
};

/// A run of triangles that use only a run of vertices: the unit of culling and of streaming.
struct Meshlet {
  std::uint32_t first_triangle;  ///< index into Mesh::triangles
  std::uint16_t first_vertex;    ///< index into Mesh::positions
  std::uint16_t vertex_count;    ///< the triangles use only these vertices
  std::uint16_t triangle_count;  ///< the triangles begin after the last one of the meshlet before
  std::uint16_t radius;  ///< radius of a sphere around all vertices, in 1/32768 of the mesh's largest half extent,
                         ///< rounded up
  Position centre;       ///< centre of that sphere
};

/// Selects if and how a mesh's instances rotate with the camera.
enum class Billboard : std::uint8_t {
  none,     ///< instances stand as their transform says
  viewer,   ///< x to the picture's right, y up, z against the viewing direction; the transform gives only lengths and
            ///< position
  upright,  ///< y as in the transform; x as far to the picture's right as y allows
};

inline constexpr std::uint16_t kOwnMesh = 0xFFFF;       ///< for Outline::hull
inline constexpr std::uint16_t kMaxOutlineWidth = 256;  ///< 1/16 pixels

/// A line around an instance's picture, with the same width at any distance: the far side of a hull around it, drawn in
/// one colour after the opaque instances. The hull is a mesh whose vertices are moved along their normals, so that it
/// must be closed: vertices in one place have one normal. Normals may be longer than one to keep the width at sharp
/// edges: v . n = 1, with v the vertex's normal and n the normal of each face around it. docs/conventions.md says where
/// a vertex moves.
struct Outline {
  Colour colour{0, 0, 0, 255};    ///< alpha is ignored
  std::uint16_t width = 32;       ///< 1/16 pixels, 1..kMaxOutlineWidth
  std::uint16_t hull = kOwnMesh;  ///< index into Scene::meshes, of a mesh with normals; kOwnMesh: the instance's mesh
};

/// The role of a mesh's instances in Scene::shadow. Use only_receives for a floor: the whole map is then available to
/// the casters.
enum class ShadowRole : std::uint8_t {
  casts_and_receives,  ///< casts a shadow, and shadows darken it
  only_receives,       ///< it casts no shadow: a floor
  only_casts,          ///< lit as in a scene without shadows
  none,                ///< it neither casts nor receives shadows
};
/// True if instances of the mesh are drawn into the map.
constexpr bool casts_shadow(ShadowRole role) {
  return role == ShadowRole::casts_and_receives || role == ShadowRole::only_casts;
}
/// True if instances of the mesh are darkened by the map.
constexpr bool receives_shadow(ShadowRole role) {
  return role == ShadowRole::casts_and_receives || role == ShadowRole::only_receives;
}

struct Skinning;  // skin.hpp

/// Vertices and triangles that instances share. The tables are the caller's.
struct Mesh {
  std::span<const Position> positions;  ///< 1..65535 vertices
  std::span<const Normal> normals;      ///< one a vertex, or empty: unlit
  std::span<const Colour> colours;      ///< one a vertex, or empty: the material's colour
  std::span<const TexCoord> texcoords;  ///< one a vertex, or empty: untextured
  std::span<const Triangle> triangles;  ///< in the order in which they are drawn
  std::span<const Meshlet> meshlets;    ///< covers all triangles in order, or empty: the mesh is one meshlet
  Vec3 centre{0, 0, 0};                 ///< 16.16, of the bounding box; +-4095
  Vec3 half_extent{kFixedOne, kFixedOne, kFixedOne};  ///< 16.16, 0..4095
  std::uint8_t texcoord_bits = 12;                    ///< 4..15
  Billboard billboard = Billboard::none;              ///< other values make its instances billboards
  std::uint8_t outline = 0;  ///< 1 + index into Scene::outlines, for all its instances, which must be opaque; 0: no
                             ///< outline
  ShadowRole shadow = ShadowRole::casts_and_receives;  ///< ignored if the scene has no shadow
  Skinning* skinning = nullptr;  ///< moves the vertices while they are drawn; null: the vertices do not move
};

/// Selects how a texel is chosen.
enum class TextureFilter : std::uint8_t {
  nearest,   ///< the texel that contains the pixel's centre
  bilinear,  ///< the four texels around the centre, weighted by their distance
  /// The texture is an environment map (effect::environment), with the filter of that name. Normals select its texels
  /// instead of Mesh::texcoords. It is a sphere map: a picture of a mirrored ball that fills it, as seen from the eye;
  /// docs/conventions.md has the formula. The mesh needs normals, and its texture coordinates are ignored. So a
  /// material has either a texture of its own or an environment map, not both.
  environment_nearest = 0x10,
  environment_bilinear = 0x11,
};
/// True if texels of a texture or an environment map are mixed.
constexpr bool is_bilinear(TextureFilter filter) { return (static_cast<unsigned>(filter) & 1U) != 0; }
/// True if the texture is an environment map.
constexpr bool is_environment(TextureFilter filter) { return (static_cast<unsigned>(filter) & 0x10U) != 0; }
/// Returns the filter of environment maps that corresponds to nearest or bilinear.
constexpr TextureFilter of_environment(TextureFilter filter) {
  return static_cast<TextureFilter>(static_cast<unsigned>(filter) | 0x10U);
}

/// The layout of texels in Texture::texels, in words of 16 bits.
enum class TextureFormat : std::uint8_t {
  rgb565,        ///< one texel a word
  rgb565_alpha,  ///< as rgb565, then an alpha for each texel: 8 bits, two in a word, the first in the low half
  palette8,      ///< 256 colours, then an index of 8 bits for each texel, two in a word, the first in the low half
  palette4,      ///< 16 colours, then an index of 4 bits for each texel, four in a word, the first in the lowest
};

/// True if texels are indices of a palette. The palette has a colour for every possible index, so that no index needs a
/// check. Only materials with a finish (which may be Finish{}) can use such a texture: the pixel loops of other
/// materials do not test for a palette. Quadrics cannot use it.
constexpr bool has_palette(TextureFormat format) { return format >= TextureFormat::palette8; }
/// Returns the bits of an index, for formats with a palette.
constexpr std::uint32_t index_bits(TextureFormat format) { return format == TextureFormat::palette8 ? 8 : 4; }

/// Row-major texels; the first row is v = 0. Sides are powers of two, 1..2048.
struct Texture {
  std::span<const std::uint16_t> texels;         ///< words in `format`, level after level
  std::uint8_t log2_width = 0;                   ///< 0..11
  std::uint8_t log2_height = 0;                  ///< 0..11
  TextureFormat format = TextureFormat::rgb565;  ///< of all levels
  /// Number of smaller pictures of the texture (mipmaps) that follow. Each has half the sides of the one before,
  /// rounded down, at least 1, down to 1 texel at most. Each has its own palette, and its alpha after its texels. Only
  /// materials with a finish (which may be Finish{}) use them; other materials and quadrics are drawn with the first
  /// picture.
  std::uint8_t smaller_levels = 0;
};

/// Returns the words of one level with 2^log2_texels texels, without the palette.
constexpr std::size_t level_words(TextureFormat format, std::uint32_t log2_texels) {
  const std::size_t texels = std::size_t{1} << log2_texels;
  switch (format) {
    case TextureFormat::rgb565_alpha: return texels + (texels + 1) / 2;
    case TextureFormat::palette8: return (texels + 1) / 2;
    case TextureFormat::palette4: return (texels + 3) / 4;
    case TextureFormat::rgb565: break;
  }
  return texels;
}

inline constexpr std::uint16_t kNoTexture = 0xFFFF;  ///< for Material::texture

/// Selects the fragments that are drawn, by their depth compared with the z-buffer: nearer, equal and farther are one
/// bit each. A cleared cell is farther than every fragment.
enum class DepthTest : std::uint8_t {
  never = 0,
  nearer = 1,
  equal = 2,
  nearer_or_equal = 3,
  farther = 4,
  not_equal = 5,
  farther_or_equal = 6,
  always = 7,
};

/// The use of alpha, defined as in glTF. A fragment's alpha is the material's colour.a, times the texel's alpha if the
/// texture has alpha.
enum class AlphaMode : std::uint8_t {
  opaque,  ///< alpha is ignored
  mask,    ///< fragments with less than Finish::alpha_cutoff are not drawn
  blend,   ///< fragments are mixed with the colour behind them
};

/// Properties that few materials have. A separate table keeps them out of the other materials.
struct Finish {
  Colour emissive{0, 0, 0, 255};  ///< added to the light of a lit material; texels are multiplied with the sum
  Colour specular{0, 0, 0, 255};  ///< colour of highlights (Blinn-Phong) on a lit material
  std::uint8_t shininess = 32;    ///< exponent of the highlights: greater values make them smaller
  AlphaMode alpha_mode = AlphaMode::opaque;       ///< other values need an effect
  std::uint8_t alpha_cutoff = 128;                ///< 0..255; for AlphaMode::mask
  TextureFilter filter = TextureFilter::nearest;  ///< for the material's texture
  friend constexpr bool operator==(const Finish&, const Finish&) = default;
};

inline constexpr std::uint8_t kNoFinish = 0xFF;  ///< for Material::finish

/// The interpolation of light and vertex colours over a triangle. A bool converts to one of the first two kinds.
struct Shading {
  /// The place where light is computed, and the interpolation between these places.
  enum Kind : std::uint8_t {
    flat,     ///< false: the first vertex gives the colour
    gouraud,  ///< true: lit at the vertices, linear between them
    pixel,    ///< lit at each pixel with the interpolated normal (effect::pixel_shading); as gouraud if unlit
  };
  Kind kind;  ///< the kind
  /// Not explicit, so that a Kind can be written for a Shading.
  constexpr Shading(Kind how) : kind(how) {}
  /// Not explicit, so that a bool can be written for a Shading: true is gouraud, false is flat.
  constexpr Shading(bool smooth) : kind(smooth ? gouraud : flat) {}
  /// Converts for comparisons with a Kind; true unless flat.
  constexpr operator Kind() const { return kind; }
};

/// The colour of a surface, and its rules for depth.
struct Material {
  Colour colour{255, 255, 255,
                255};  ///< multiplied with vertex colours and light; not with texels of an unlit material
  std::uint16_t texture = kNoTexture;        ///< index into Scene::textures
  bool lit = true;                           ///< false: colours and texels are drawn without light
  Shading smooth = true;                     ///< true: Gouraud; false: flat, the first vertex gives the colour; or
                                             ///< Shading::pixel
  bool double_sided = false;                 ///< false: back faces are culled
  DepthTest depth_test = DepthTest::nearer;  ///< other values need effect::depth_state, and so do values other than the
                                             ///< defaults of the depth members below
  bool depth_write = true;                   ///< false: fragments are tested and drawn; the z-buffer does not change
  std::uint8_t finish = kNoFinish;           ///< index into Scene::finishes
  std::int32_t depth_bias = 0;               ///< codes; positive is nearer
  Fixed depth_slope_bias = 0;                ///< 16.16, times the triangle's larger slope in codes a pixel
  std::int32_t depth_bias_clamp = 0;  ///< codes; limit for the sum of both biases: upper limit if positive, lower limit
                                      ///< if negative, 0: no limit
};

/// A mesh with a material and a transform. The transform may change between frames.
struct Instance {
  std::uint16_t mesh = 0;                       ///< index into Scene::meshes
  std::uint16_t material = 0;                   ///< index into Scene::materials
  Transform transform = Transform::identity();  ///< object to world; rotation and scale entries within +-255
};

/// A sphere or ellipsoid: the transformed unit sphere around the origin. Drawn pixel by pixel along the viewing ray,
/// before the instances, into the same z-buffer; docs/effects.md has the mapping of its texture. Material::smooth is
/// ignored. Its depth has no slope: Material::depth_slope_bias must be 0. It is opaque: the material must have no
/// finish and its texture no alpha. Punctual lights do not light quadrics: a lit quadric in a scene that has punctual
/// lights is refused.
struct Quadric {
  std::uint16_t material = 0;  ///< index into Scene::materials
  /// Sphere to world; entries within +-255; must have an inverse. If the columns are perpendicular, they are the half
  /// axes of the ellipsoid.
  Transform transform = Transform::identity();
};

/// A line between two vertices, or a point if both vertices are the same.
struct Segment {
  std::uint16_t a, b;  ///< indices into the mesh's vertices
};

inline constexpr std::uint8_t kMaxLineWidth = 64;  ///< pixels

/// Lines and points, with the same width in pixels at any distance; docs/conventions.md defines the pixels. Drawn after
/// the quadrics and before the instances, into the same z-buffer, so that nearer surfaces hide them. Each line has one
/// colour: the material's, times the colour of the vertex Segment::a if the mesh has colours. Lines have no surface:
/// Material::lit, smooth and double_sided are ignored; a texture, a finish or a slope bias is refused. A constant bias
/// of a few codes keeps a wireframe in front of its surface.
struct LineSet {
  std::span<const Segment> segments;            ///< drawn in this order
  std::uint16_t mesh = 0;                       ///< index into Scene::meshes; only its vertices are used
  std::uint16_t material = 0;                   ///< index into Scene::materials
  Transform transform = Transform::identity();  ///< object to world; rotation and scale entries within +-255
  std::uint8_t width = 1;                       ///< pixels, 1..kMaxLineWidth
};

/// A light that is infinitely far away.
struct DirectionalLight {
  std::int16_t x = 0, y = 0, z = 32767;  ///< 1.15, unit vector *towards* the light, in world space
  Colour colour{255, 255, 255, 255};     ///< alpha is ignored
};

/// The shape of a punctual light.
enum class PunctualLightType : std::uint8_t {
  point,  ///< into all directions
  spot,   ///< within a cone
};

/// A light at a point (as KHR_lights_punctual of glTF). At distance d (units of length) the light is its colour times
/// `intensity` / d^2, at most 256 times the colour. A range multiplies this by 1 - (d / range)^4, and by 0 beyond it. A
/// spot multiplies it by ((c - cosine_outer) / (cosine_inner - cosine_outer))^2, within 0..1, with c the cosine of the
/// angle to the spot's direction.
struct PunctualLight {
  PunctualLightType type = PunctualLightType::point;  ///< only a spot uses direction and cosines
  Colour colour{255, 255, 255, 255};                  ///< alpha is ignored
  Vec3 position{0, 0, 0};                             ///< 16.16, world
  Fixed intensity = kFixedOne;                        ///< 16.16, >= 0
  Fixed range = 0;                                    ///< 16.16; 0: unlimited
  std::int16_t x = 0, y = 0, z = -32767;              ///< 1.15, unit vector of the spot's direction, in world space
  std::int16_t cosine_inner = 32767;                  ///< 1.15, of half the angle that is fully lit
  std::int16_t cosine_outer = 23170;                  ///< 1.15, of half the angle that is lit; 0 <= outer < inner
  std::uint16_t unused = 0;                           ///< any value
};

inline constexpr std::uint32_t kMaxPunctualLights = 4;  ///< of a scene

/// The formula by which surfaces fade into a colour with their distance w from the camera's plane (along the viewing
/// direction).
enum class FogMode : std::uint8_t {
  linear,               ///< visible: (end - w) / (end - start), within 0..1
  exponential,          ///< visible: e^-(density w)
  exponential_squared,  ///< visible: e^-(density w)^2
};

/// Fog of one colour; the amount depends on the distance along the viewing direction.
struct Fog {
  Colour colour{128, 128, 128, 255};  ///< fog does not change the background: give Scene::background the same colour
  FogMode mode = FogMode::linear;     ///< selects the members below that are used
  Fixed start = 0;                    ///< 16.16, 0 <= start < end; for linear
  Fixed end = 100 * kFixedOne;        ///< 16.16
  Fixed density = kFixedOne / 8;      ///< 16.16 a unit of length, >= 0; for the exponential modes
};

inline constexpr std::uint32_t kMaxLights = 4;  ///< directional lights of a scene

inline constexpr std::uint8_t kMinShadowLog2 = 4, kMaxShadowLog2 = 10;  ///< limits of Shadow::log2_size

/// The shadows of one directional light, from a map of depths as the light sees them (effect::shadows). Casters are
/// quadrics, and instances that write depth and are not blended. Both faces cast, and the alpha of a texture is
/// ignored. Receivers are instances and quadrics. A pixel in shadow loses this light's term and keeps all others. Every
/// material's depth test must pass nearer, equal or both. docs/conventions.md defines the pixels that are in shadow.
struct Shadow {
  std::uint8_t light = 0;      ///< index into Scene::lights
  std::uint8_t log2_size = 8;  ///< log2 of the map's side in texels, kMinShadowLog2..kMaxShadowLog2
  std::uint16_t bias = 32;     ///< added to a caster's distance in the map, in 1/65533 of the depth of all casters
  /// Also added: this factor times the caster's slope; 16.16, in texels, >= 0. Below 1, a surface that faces the light
  /// at a slant shadows itself.
  Fixed slope_bias = kFixedOne + kFixedOne / 4;
  /// Bytes for the compressed map, of Purpose::effects; 0: enough for the worst map. Error::store_full when a frame
  /// begins if they are too few.
  std::uint32_t pool = 0;
};

/// The use of an operand in its product.
enum class CsgUse : std::uint8_t {
  intersected,  ///< the result lies inside it
  subtracted,   ///< the result lies outside it
};

inline constexpr std::uint32_t kMaxCsgOperands = 64;  ///< of a scene

/// A solid of a product: constructive solid geometry on the z-buffer (effect::csg). The operands of a product are
/// adjacent and have its number; products have ascending numbers. A product is the intersection of its intersected
/// operands, of which there is at least one, minus the subtracted ones; a union is several products. The picture shows
/// front faces of intersected operands, and back faces of subtracted ones, which have their own material and are lit
/// from the other side. An instance may be in several products, and is not drawn by itself.
///
/// A mesh must be closed: it has each edge once in either direction, where corners in one place count as one. It must
/// not intersect itself. A frame does not check this, and draws other meshes wrong. Material::double_sided is ignored.
/// The material must be opaque and have default rules for depth; the mesh must have neither a billboard nor an outline.
/// If the near plane cuts a solid, its inside is visible: the cut is not capped. If the far plane also cuts the solid,
/// its inside is undefined.
struct CsgOperand {
  std::uint16_t instance = 0;        ///< index into Scene::instances
  std::uint8_t product = 0;          ///< the product's number
  CsgUse use = CsgUse::intersected;  ///< each product needs an intersected operand
};

inline constexpr std::uint16_t kNoFace = 0xFFFF;  ///< for Edge::right

/// An edge of a mesh: its ends, and the third corner of each of its faces, as indices into the mesh's vertices. Only
/// their positions are used. Seen from the front, both (a, b, left) and (b, a, right) are counter-clockwise. There are
/// two ways to describe an edge: (a, b, left, right) and (b, a, right, left). With a > b the edge is a crease, where
/// shading or colour may change abruptly between two faces that are both seen.
struct Edge {
  std::uint16_t a, b;             ///< the ends
  std::uint16_t left;             ///< third corner of the face on the left
  std::uint16_t right = kNoFace;  ///< kNoFace: the mesh has no face there
};

/// Edges of a mesh that are anti-aliased (effect::edges) wherever its instances are drawn. They are drawn in this
/// order. Drawing is fastest if the edges of one meshlet (the one with a, b and left) are adjacent, in the order of the
/// meshlets.
struct EdgeSet {
  std::span<const Edge> edges;  ///< any number
  std::uint16_t mesh = 0;       ///< index into Scene::meshes
};

struct Overlay;  // overlay.hpp

/// All data that a frame draws. The tables are the caller's, in flash or in RAM.
struct Scene {
  std::span<const Mesh> meshes;                      ///< Instance::mesh is an index into them
  std::span<const Material> materials;               ///< Instance::material is an index into them
  std::span<const Texture> textures;                 ///< Material::texture is an index into them
  std::span<const Instance> instances;               ///< drawn in this order
  std::span<const DirectionalLight> lights;          ///< at most kMaxLights
  Colour ambient{48, 48, 48, 255};                   ///< light from all directions; alpha is ignored
  Colour background{0, 0, 0, 255};                   ///< colour of pixels that no object covers; alpha is ignored
  const Fog* fog = nullptr;                          ///< null: no fog
  std::span<const Finish> finishes{};                ///< at most 255
  std::span<const PunctualLight> punctual_lights{};  ///< at most kMaxPunctualLights
  std::span<const Quadric> quadrics{};               ///< drawn in this order, before the instances
  std::span<const LineSet> lines{};                  ///< drawn in this order, after the quadrics
  std::span<const Outline> outlines{};               ///< at most 255; Mesh::outline is an index into them
  const Shadow* shadow = nullptr;                    ///< null: no shadow
  std::span<const CsgOperand> csg{};                 ///< at most kMaxCsgOperands, product after product
  /// Sorted by ascending mesh, at most one for each mesh. Not with outlines, shadows, CSG or several samples.
  std::span<const EdgeSet> edges{};
  const Overlay* overlay = nullptr;  ///< sprites and labels over the picture; null: none
};

/// Returns the outline of the mesh's instances, or null if they have none.
constexpr const Outline* outline_of(const Scene& scene, const Mesh& mesh) {
  return mesh.outline != 0 && mesh.outline <= scene.outlines.size() ? &scene.outlines[mesh.outline - 1U] : nullptr;
}

/// Returns the anti-aliased edges of the mesh's instances.
constexpr std::span<const Edge> edges_of(const Scene& scene, std::uint32_t mesh) {
  for (const EdgeSet& set : scene.edges) {
    if (set.mesh == mesh) return set.edges;
  }
  return {};
}

inline constexpr std::uint32_t kEdgesOfGroup = 8;  ///< edges whose state in a frame is stored together

/// Returns the groups of kEdgesOfGroup edges of all instances; 2^32 - 1 means that many or more. Not inlined, because
/// checks of scenes without edges call it in several places.
[[gnu::noinline]] constexpr std::uint32_t edge_groups(const Scene& scene) {
  std::uint64_t groups = 0;
  for (const EdgeSet& set : scene.edges) {
    for (const Instance& instance : scene.instances) {
      if (instance.mesh == set.mesh) groups += (set.edges.size() + kEdgesOfGroup - 1) / kEdgesOfGroup;
    }
  }
  return groups < 0xFFFFFFFF ? static_cast<std::uint32_t>(groups) : 0xFFFFFFFF;
}

/// Returns the index of the mesh that is the hull of an instance with this outline; it may be out of range before
/// validate.
constexpr std::uint16_t hull_of(const Outline& outline, const Instance& instance) {
  return outline.hull == kOwnMesh ? instance.mesh : outline.hull;
}

}  // namespace zstrip
