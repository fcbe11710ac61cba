// The scene as the renderer reads it: views of the caller's memory, which may lie in flash.
// Nothing is copied and nothing is written; all of it must stay alive from begin_frame to the last draw_strip.
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/base/fixed.hpp"

namespace zstrip {

/// A vertex inside its mesh's bounding box: centre + half_extent * position / 32768. -32767..32767.
struct Position {
  std::int16_t x, y, z;  ///< in 1/32768 of the half extent
};

/// A unit vector, 1.7. `unused` keeps a normal on one word.
struct Normal {
  std::int8_t x, y, z, unused;  ///< 1.7; `unused`: any value
};

/// 0..255 a channel.
struct Colour {
  std::uint8_t r, g, b, a;  ///< red, green, blue, alpha: 255 is full, or opaque
  friend constexpr bool operator==(const Colour&, const Colour&) = default;
};

/// Texture coordinates with Mesh::texcoord_bits fraction bits; 1.0 is the whole texture. v grows downwards
/// (as in glTF).
struct TexCoord {
  std::int16_t u, v;  ///< to the right, and down; beyond 0..1 textures repeat
};

/// Indices into the mesh's vertices; counter-clockwise seen from the front.
struct Triangle {
  std::uint16_t a, b, c;  ///< each below the number of Mesh::positions
};

/// A run of triangles that use only a run of vertices: the unit of culling and of streaming.
struct Meshlet {
  std::uint32_t first_triangle;  ///< index into Mesh::triangles
  std::uint16_t first_vertex;    ///< index into Mesh::positions
  std::uint16_t vertex_count;    ///< of the run: the triangles use no other vertices
  std::uint16_t triangle_count;  ///< of the run, which goes on where the meshlet before ends
  std::uint16_t radius;  ///< of a sphere around all vertices: 1/32768 of the mesh's largest half extent, rounded up
  Position centre;       ///< of that sphere
};

/// Whether a mesh's instances turn with the camera.
enum class Billboard : std::uint8_t {
  none,     ///< no: they stand as in their transform
  viewer,   ///< x to the picture's right, y up, z against the viewing direction; only lengths and place are theirs
  upright,  ///< y as in the transform; x as far to the right as that allows
};

inline constexpr std::uint16_t kOwnMesh = 0xFFFF;       ///< for Outline::hull
inline constexpr std::uint16_t kMaxOutlineWidth = 256;  ///< 1/16 pixels

/// A line around an instance's picture, as wide at any distance: the far side of a hull around it, drawn in one colour
/// after what is opaque. The hull is a mesh whose vertices are moved along their normals, so that it must be closed:
/// vertices in one place have one normal. Where edges are to keep their width, normals may be longer than one: with v
/// the vertex' and n those of the faces around it, v . n = 1. Where a vertex moves: docs/conventions.md.
struct Outline {
  Colour colour{0, 0, 0, 255};    ///< alpha means nothing
  std::uint16_t width = 32;       ///< 1/16 pixels, 1..kMaxOutlineWidth
  std::uint16_t hull = kOwnMesh;  ///< index into Scene::meshes, of a mesh with normals, or kOwnMesh: the instance's
};

/// What a mesh' instances have to do with Scene::shadow. What only receives (a floor) leaves the map's texels to what
/// casts.
enum class ShadowRole : std::uint8_t {
  casts_and_receives,  ///< the default
  only_receives,       ///< no shadow of its own: a floor
  only_casts,          ///< it is lit as without shadows
  none,                ///< as without a shadow in the scene
};
/// Whether its instances are drawn into the map.
constexpr bool casts_shadow(ShadowRole role) {
  return role == ShadowRole::casts_and_receives || role == ShadowRole::only_casts;
}
/// Whether its instances are darkened by the map.
constexpr bool receives_shadow(ShadowRole role) {
  return role == ShadowRole::casts_and_receives || role == ShadowRole::only_receives;
}

struct Skinning;  // skin.hpp

/// Vertices and triangles that instances share; only views of the caller's tables.
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
  Billboard billboard = Billboard::none;              ///< anything else makes its instances billboards
  std::uint8_t outline = 0;  ///< 1 + index into Scene::outlines: all its instances have it, and are opaque; 0: none
  ShadowRole shadow = ShadowRole::casts_and_receives;  ///< only looked at where the scene has a shadow
  Skinning* skinning = nullptr;  ///< moves the vertices while they are drawn; null: they stay as they are
};

/// How a texel is chosen.
enum class TextureFilter : std::uint8_t {
  nearest,   ///< the one in which the pixel's centre lies
  bilinear,  ///< the four around it, by their distance
  /// Likewise of an environment map (effect::environment), by normals instead of Mesh::texcoords: the
  /// texture is a sphere map, a picture of a mirrored ball that fills it, as seen from the eye; docs/conventions.md has
  /// the formula. The mesh needs normals, and its texture coordinates mean nothing. So a material has either a texture
  /// of its own or an environment map, not both.
  environment_nearest = 0x10,
  environment_bilinear = 0x11,
};
/// Whether texels are mixed, of a texture or an environment map.
constexpr bool is_bilinear(TextureFilter filter) { return (static_cast<unsigned>(filter) & 1U) != 0; }
/// Whether the texture is an environment map.
constexpr bool is_environment(TextureFilter filter) { return (static_cast<unsigned>(filter) & 0x10U) != 0; }
/// nearest and bilinear become those of environment maps.
constexpr TextureFilter of_environment(TextureFilter filter) {
  return static_cast<TextureFilter>(static_cast<unsigned>(filter) | 0x10U);
}

/// How texels lie in Texture::texels, in words of 16 bits.
enum class TextureFormat : std::uint8_t {
  rgb565,        ///< one texel each
  rgb565_alpha,  ///< the same, and after all texels an alpha for each: 8 bits, two in a word, the first in the low half
  palette8,      ///< 256 colours, then an index of 8 bits for each texel, two in a word, the first in the low half
  palette4,      ///< 16 colours, then an index of 4 bits for each texel, four in a word, the first in the lowest
};

/// Whether texels are indices of a palette. Every index has its colour: nothing to check, nothing to overrun. Such a
/// texture is for materials with a finish (which may be Finish{}): those without have no test for it. Not for quadrics.
constexpr bool has_palette(TextureFormat format) { return format >= TextureFormat::palette8; }
/// Bits of an index; with a palette only.
constexpr std::uint32_t index_bits(TextureFormat format) { return format == TextureFormat::palette8 ? 8 : 4; }

/// Row-major RGB565 texels, the first row is v = 0. Sides are powers of two, 1..2048.
struct Texture {
  std::span<const std::uint16_t> texels;         ///< words in `format`, level after level
  std::uint8_t log2_width = 0;                   ///< 0..11
  std::uint8_t log2_height = 0;                  ///< 0..11
  TextureFormat format = TextureFormat::rgb565;  ///< of all levels
  /// Smaller pictures of the same (mipmaps) that follow, each with half the sides of the one before, rounded down, at
  /// least 1; with its palette, and its alpha behind its texels. Down to 1 texel at most. They are for materials with a
  /// finish (which may be Finish{}): all others, and quadrics, are drawn with the first picture.
  std::uint8_t smaller_levels = 0;
};

/// Words of one level of so many texels, without the palette.
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

/// Which fragments are drawn, by where they lie against what the z-buffer holds there: nearer, equal and farther are
/// one bit each. A cleared cell is farther than every fragment.
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

/// What alpha does (as in glTF). A fragment's alpha is the material's colour.a times the texel's, where its texture has
/// any.
enum class AlphaMode : std::uint8_t {
  opaque,  ///< nothing
  mask,    ///< fragments with less than Finish::alpha_cutoff are not drawn
  blend,   ///< fragments are mixed into what lies behind them
};

/// What few materials have, in a table of its own, so that the others have no bytes for it.
struct Finish {
  Colour emissive{0, 0, 0, 255};  ///< added to the light of a lit material; texels are multiplied with the sum
  Colour specular{0, 0, 0, 255};  ///< colour of highlights (Blinn-Phong) on a lit material
  std::uint8_t shininess = 32;    ///< their exponent; the greater, the smaller they are
  AlphaMode alpha_mode = AlphaMode::opaque;       ///< anything else calls for an effect
  std::uint8_t alpha_cutoff = 128;                ///< 0..255; of AlphaMode::mask
  TextureFilter filter = TextureFilter::nearest;  ///< of the material's texture
  friend constexpr bool operator==(const Finish&, const Finish&) = default;
};

inline constexpr std::uint8_t kNoFinish = 0xFF;  ///< for Material::finish

/// How light and vertex colours vary over a triangle. A bool is one of the first two.
struct Shading {
  /// Where light is computed, and what lies between.
  enum Kind : std::uint8_t {
    flat,     ///< false: the first vertex decides
    gouraud,  ///< true: lit at the vertices, linear between
    pixel,    ///< lit at each pixel, by the normal that is interpolated there (effect::pixel_shading); unlit as gouraud
  };
  Kind kind;  ///< the value
  /// Not explicit: a Kind is written where a Shading is wanted.
  constexpr Shading(Kind how) : kind(how) {}
  /// Likewise for a bool: gouraud or flat.
  constexpr Shading(bool smooth) : kind(smooth ? gouraud : flat) {}
  /// To compare it with a Kind; true unless flat.
  constexpr operator Kind() const { return kind; }
};

/// How a surface looks, and how it treats depth.
struct Material {
  Colour colour{255, 255, 255,
                255};  ///< multiplied with vertex colours and light; not with texels of an unlit material
  std::uint16_t texture = kNoTexture;        ///< index into Scene::textures
  bool lit = true;                           ///< false: colours and texels as they are
  Shading smooth = true;                     ///< Gouraud; false: flat, the first vertex decides; or Shading::pixel
  bool double_sided = false;                 ///< false: back faces are culled
  DepthTest depth_test = DepthTest::nearer;  ///< anything below but the default calls for effect::depth_state
  bool depth_write = true;                   ///< false: fragments are tested and drawn, the z-buffer keeps its depth
  std::uint8_t finish = kNoFinish;           ///< index into Scene::finishes
  std::int32_t depth_bias = 0;               ///< codes; positive is nearer
  Fixed depth_slope_bias = 0;                ///< 16.16, times the triangle's larger slope in codes a pixel
  std::int32_t depth_bias_clamp = 0;  ///< codes: the sum of both at most (positive), at least (negative), any (0)
};

/// A mesh with a material at a place. Its transform may change between frames.
struct Instance {
  std::uint16_t mesh = 0;                       ///< index into Scene::meshes
  std::uint16_t material = 0;                   ///< index into Scene::materials
  Transform transform = Transform::identity();  ///< object to world; rotation and scale entries within +-255
};

/// A sphere or ellipsoid: the unit sphere around the origin, transformed. Drawn pixel by pixel along the viewing ray,
/// before the instances, into the same z-buffer; docs/effects.md has the mapping of its texture. Material::smooth means
/// nothing to it. Its depth has no slope: Material::depth_slope_bias must be 0. It is opaque: the material has no
/// finish and its texture no alpha; punctual lights do not light it, and a lit one in a scene that has them is refused.
struct Quadric {
  std::uint16_t material = 0;  ///< index into Scene::materials
  /// Sphere to world; entries within +-255, with an inverse. Its columns are the ellipsoid's half axes where they are
  /// at right angles.
  Transform transform = Transform::identity();
};

/// A line between two vertices, or a point where both are the same one.
struct Segment {
  std::uint16_t a, b;  ///< indices into the mesh's vertices
};

inline constexpr std::uint8_t kMaxLineWidth = 64;  ///< pixels

/// Lines and points, as many pixels wide at any distance; which pixels: docs/conventions.md. Drawn after the
/// quadrics, before the instances, into the same z-buffer, so that what is nearer hides them. Of one colour each: the
/// material's, times that of the vertex Segment::a where the mesh has colours. They have no surface: Material::lit,
/// smooth and double_sided mean nothing to them; a texture, a finish or a slope bias is refused. A constant bias of a
/// few codes keeps a wireframe in front of the surface that it lies on.
struct LineSet {
  std::span<const Segment> segments;            ///< drawn in this order
  std::uint16_t mesh = 0;                       ///< index into Scene::meshes; only its vertices are looked at
  std::uint16_t material = 0;                   ///< index into Scene::materials
  Transform transform = Transform::identity();  ///< as an instance's
  std::uint8_t width = 1;                       ///< pixels, 1..kMaxLineWidth
};

/// A light that is infinitely far away.
struct DirectionalLight {
  std::int16_t x = 0, y = 0, z = 32767;  ///< 1.15, unit vector *towards* the light, in world space
  Colour colour{255, 255, 255, 255};     ///< alpha means nothing
};

/// The shape of a light at a point.
enum class PunctualLightType : std::uint8_t {
  point,  ///< into all directions
  spot,   ///< within a cone
};

/// A light at a point (as KHR_lights_punctual of glTF). At distance d (units of length) `intensity` / d^2 of its colour
/// arrives, up to 256 times; with a range that times 1 - (d / range)^4, none beyond it. Of a spot that times
/// ((c - cosine_outer) / (cosine_inner - cosine_outer))^2, c the cosine of the angle off its direction, within 0..1.
struct PunctualLight {
  PunctualLightType type = PunctualLightType::point;  ///< only a spot has a direction and cosines
  Colour colour{255, 255, 255, 255};                  ///< alpha means nothing
  Vec3 position{0, 0, 0};                             ///< 16.16, world
  Fixed intensity = kFixedOne;                        ///< 16.16, >= 0
  Fixed range = 0;                                    ///< 16.16; 0: no end
  std::int16_t x = 0, y = 0, z = -32767;              ///< 1.15, unit vector in which a spot shines, world
  std::int16_t cosine_inner = 32767;                  ///< 1.15, of half the angle that is fully lit
  std::int16_t cosine_outer = 23170;                  ///< 1.15, of half the angle that is lit; 0 <= outer < inner
  std::uint16_t unused = 0;                           ///< any value
};

inline constexpr std::uint32_t kMaxPunctualLights = 4;  ///< of a scene

/// How what is seen fades into a colour with its distance w from the camera's plane (along the viewing direction).
enum class FogMode : std::uint8_t {
  linear,               ///< visible: (end - w) / (end - start), within 0..1
  exponential,          ///< visible: e^-(density w)
  exponential_squared,  ///< visible: e^-(density w)^2
};

/// Fog of one colour, by the distance along the viewing direction.
struct Fog {
  Colour colour{128, 128, 128, 255};  ///< the background is not fogged: give Scene::background the same colour
  FogMode mode = FogMode::linear;     ///< which of the members below count
  Fixed start = 0;                    ///< 16.16, 0 <= start < end; linear
  Fixed end = 100 * kFixedOne;        ///< 16.16
  Fixed density = kFixedOne / 8;      ///< 16.16 a unit of length, >= 0; the exponential modes
};

inline constexpr std::uint32_t kMaxLights = 4;  ///< directional lights of a scene

inline constexpr std::uint8_t kMinShadowLog2 = 4, kMaxShadowLog2 = 10;  ///< limits of Shadow::log2_size

/// The shadows of one directional light, by a map of depths as the light sees them (effect::shadows). What casts:
/// instances that are neither blended nor without depth write, as solid whatever their texture's alpha, both faces, and
/// quadrics. What receives: instances, quadrics. In shadow the light's term is missing, all else stays. Every
/// material's depth test must be one that passes nearer, equal or both. docs/conventions.md defines which pixels are in
/// shadow.
struct Shadow {
  std::uint8_t light = 0;      ///< index into Scene::lights
  std::uint8_t log2_size = 8;  ///< of the map's side in texels, kMinShadowLog2..kMaxShadowLog2
  std::uint16_t bias = 32;     ///< how much farther than it is a caster is kept, in 1/65533 of the depth of all casters
  /// And times its slope, 16.16, in texels, 0 or more: below 1 what faces the light at a slant shadows itself.
  Fixed slope_bias = kFixedOne + kFixedOne / 4;
  /// Bytes for the compressed map, of Purpose::effects. Too few are Error::store_full when a frame begins. 0: as many
  /// as the worst map takes.
  std::uint32_t pool = 0;
};

/// What an operand does to its product.
enum class CsgUse : std::uint8_t {
  intersected,  ///< the result lies inside it
  subtracted,   ///< the result lies outside it
};

inline constexpr std::uint32_t kMaxCsgOperands = 64;  ///< of a scene

/// A solid of a product: constructive solid geometry on the z-buffer (effect::csg). The operands of a product lie next
/// to each other, with its number; products have ascending numbers. A product is what all of its intersected operands
/// have in common, of which there is at least one, less the subtracted ones; a union is several products. What is seen
/// of it are the front faces of intersected operands, and of the subtracted ones the back faces, with their own
/// material, lit from the other side. An instance may be in several products, and is not drawn by itself.
///
/// A mesh must be closed, each edge once in either direction where corners in one place count as one, and must not cut
/// itself: a frame does not notice what is open, and shows it wrong. Material::double_sided means nothing. The material
/// has no rules of its own for depth and is opaque; a mesh is no billboard and has no outline. What the near plane cuts
/// open shows its inside: nothing caps it. Of what the far plane cuts as well the inside is not known.
struct CsgOperand {
  std::uint16_t instance = 0;        ///< index into Scene::instances
  std::uint8_t product = 0;          ///< its number
  CsgUse use = CsgUse::intersected;  ///< at least one of a product is intersected
};

inline constexpr std::uint16_t kNoFace = 0xFFFF;  ///< for Edge::right

/// An edge of a mesh, by its ends and the third corner of each of its faces: indices into the mesh's vertices, of which
/// only the positions count. Seen from the front a, b, left are counter-clockwise, and b, a, right. The description has
/// two directions, (a, b, left, right) and (b, a, right, left): with a > b the edge is a crease, where shading or
/// colour may break between two faces that are both seen.
struct Edge {
  std::uint16_t a, b;             ///< the ends
  std::uint16_t left;             ///< third corner of the face on the left
  std::uint16_t right = kNoFace;  ///< kNoFace: the mesh ends here
};

/// Edges of a mesh that are anti-aliased (effect::edges) wherever its instances are drawn. Drawn in this order; fastest
/// where edges with the same meshlet, that of a, b and left, lie next to each other and in the meshlets' order.
struct EdgeSet {
  std::span<const Edge> edges;  ///< any number
  std::uint16_t mesh = 0;       ///< index into Scene::meshes
};

struct Overlay;  // overlay.hpp

/// All that a frame draws. Only views: the tables are the caller's, in flash or in RAM.
struct Scene {
  std::span<const Mesh> meshes;                      ///< Instance::mesh names them
  std::span<const Material> materials;               ///< Instance::material names them
  std::span<const Texture> textures;                 ///< Material::texture names them
  std::span<const Instance> instances;               ///< drawn in this order
  std::span<const DirectionalLight> lights;          ///< at most kMaxLights
  Colour ambient{48, 48, 48, 255};                   ///< light from everywhere; alpha means nothing
  Colour background{0, 0, 0, 255};                   ///< of pixels that nothing covers; alpha means nothing
  const Fog* fog = nullptr;                          ///< none if null
  std::span<const Finish> finishes{};                ///< at most 255
  std::span<const PunctualLight> punctual_lights{};  ///< at most kMaxPunctualLights
  std::span<const Quadric> quadrics{};               ///< drawn in this order, before the instances
  std::span<const LineSet> lines{};                  ///< drawn in this order, after the quadrics
  std::span<const Outline> outlines{};               ///< at most 255; Mesh::outline names them
  const Shadow* shadow = nullptr;                    ///< none if null
  std::span<const CsgOperand> csg{};                 ///< at most kMaxCsgOperands, product after product
  /// By ascending mesh, one a mesh at most. Not with outlines, shadows, CSG or several samples.
  std::span<const EdgeSet> edges{};
  const Overlay* overlay = nullptr;  ///< sprites and labels over the picture; none if null
};

/// Of the instances of this mesh; null if they have none.
constexpr const Outline* outline_of(const Scene& scene, const Mesh& mesh) {
  return mesh.outline != 0 && mesh.outline <= scene.outlines.size() ? &scene.outlines[mesh.outline - 1U] : nullptr;
}

/// Of the instances of this mesh.
constexpr std::span<const Edge> edges_of(const Scene& scene, std::uint32_t mesh) {
  for (const EdgeSet& set : scene.edges) {
    if (set.mesh == mesh) return set.edges;
  }
  return {};
}

inline constexpr std::uint32_t kEdgesOfGroup = 32;  ///< whose frame keeps what is known of them together

/// Groups of kEdgesOfGroup edges that the instances have, together; 2^32 - 1 also stands for more. Not inlined: checks
/// of scenes without edges call it in several places.
[[gnu::noinline]] constexpr std::uint32_t edge_groups(const Scene& scene) {
  std::uint64_t groups = 0;
  for (const EdgeSet& set : scene.edges) {
    for (const Instance& instance : scene.instances) {
      if (instance.mesh == set.mesh) groups += (set.edges.size() + kEdgesOfGroup - 1) / kEdgesOfGroup;
    }
  }
  return groups < 0xFFFFFFFF ? static_cast<std::uint32_t>(groups) : 0xFFFFFFFF;
}

/// The mesh that is the hull of an instance with this outline; may be out of range before validate.
constexpr std::uint16_t hull_of(const Outline& outline, const Instance& instance) {
  return outline.hull == kOwnMesh ? instance.mesh : outline.hull;
}

}  // namespace zstrip
