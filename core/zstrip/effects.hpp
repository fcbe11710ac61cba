// The effects that a scene needs. The set is a template argument of the renderer: other effects add no code.
#pragma once

#include <cstdint>

#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/depth_format.hpp"
#include "zstrip/status.hpp"
#include "zstrip/view.hpp"

namespace zstrip {

/// A set of effects; a structural type, so that it can be a template argument.
struct Effects {
  std::uint64_t bits = 0;     ///< namespace effect
  std::uint32_t methods = 0;  ///< namespace method: how visibility is found; none is the z-buffer
  /// True if the set has all of `other`.
  constexpr bool has(Effects other) const { return (*this & other) == other; }
  /// True if the set has at least one of `other`.
  constexpr bool any(Effects other) const { return (*this & other) != Effects{}; }
  /// The union.
  friend constexpr Effects operator|(Effects a, Effects b) { return {a.bits | b.bits, a.methods | b.methods}; }
  /// The intersection.
  friend constexpr Effects operator&(Effects a, Effects b) { return {a.bits & b.bits, a.methods & b.methods}; }
  /// The difference: `a` without the effects of `b`.
  friend constexpr Effects without(Effects a, Effects b) { return {a.bits & ~b.bits, a.methods & ~b.methods}; }
  friend constexpr bool operator==(const Effects&, const Effects&) = default;
};

// Members of these two namespaces read as values: effect::lighting.
// NOLINTBEGIN(readability-identifier-naming)
/// The effects, each a set of one.
namespace effect {
inline constexpr Effects lighting{1U << 0};        ///< some material is lit and there is a light or normals
inline constexpr Effects gouraud{1U << 1};         ///< colour varies over a triangle
inline constexpr Effects vertex_colours{1U << 2};  ///< some mesh has colours
inline constexpr Effects textures{1U << 3};        ///< some material has a texture
inline constexpr Effects orthographic{
    1U << 4};  ///< Projection::orthographic; such a renderer refuses perspective cameras
inline constexpr Effects statistics{1U << 5};  ///< counts triangles and fragments; effects_of never returns it
inline constexpr Effects all{(1U << 6) - 1};   ///< all of the above

inline constexpr Effects depth_state{1U << 6};  ///< some material has a depth test, depth write or bias of its own
inline constexpr Effects depth_float{1U << 7};  ///< DepthFormat::float16; effects_of never returns a depth format
inline constexpr Effects depth_24{1U << 9};     ///< DepthFormat::z24
/// z16 in sub-ranges that save clears; see Renderer::begin_frame. effects_of never returns it.
inline constexpr Effects depth_ranges{1U << 11};
/// The effects that select a depth format. A renderer has at most one of them.
inline constexpr Effects depth_formats{depth_float.bits | depth_24.bits};
/// Draws plans of Mode::binned. Not together with depth_ranges. effects_of never returns it.
inline constexpr Effects bins{1U << 12};
/// The distance between pixels with exact texture coordinates in a textured row, with perspective; coordinates between
/// them are interpolated linearly. A renderer with none of these uses every 16th pixel, and so does a triangle that is
/// drawn fragment by fragment. At most one; effects_of never returns one.
inline constexpr Effects perspective_affine{std::uint64_t{1} << 40};  ///< only at the triangle's corners
inline constexpr Effects perspective_8{std::uint64_t{1} << 41};       ///< at every 8th pixel
inline constexpr Effects perspective_1{std::uint64_t{1} << 42};       ///< at every pixel
/// All perspective runs.
inline constexpr Effects perspective_runs{perspective_affine.bits | perspective_8.bits | perspective_1.bits};

// Effects of light and of fragments. None needs another one.
inline constexpr Effects fog{std::uint64_t{1} << 13};              ///< Scene::fog
inline constexpr Effects emissive{std::uint64_t{1} << 14};         ///< Finish::emissive
inline constexpr Effects specular{std::uint64_t{1} << 15};         ///< Finish::specular
inline constexpr Effects punctual_lights{std::uint64_t{1} << 16};  ///< Scene::punctual_lights
inline constexpr Effects alpha_test{std::uint64_t{1} << 17};       ///< AlphaMode::mask
inline constexpr Effects blending{std::uint64_t{1} << 18};         ///< AlphaMode::blend
inline constexpr Effects texture_alpha{std::uint64_t{1} << 19};    ///< a texture's alpha is used to mask or to blend
inline constexpr Effects bilinear{std::uint64_t{1} << 20};         ///< TextureFilter::bilinear
/// View::dither for RGB565 and for formats converted from it without loss: gradients and fragments are dithered.
inline constexpr Effects dithered_colours{std::uint64_t{1} << 21};
inline constexpr Effects texture_palettes{std::uint64_t{1} << 24};  ///< TextureFormat::palette8 or palette4
inline constexpr Effects mipmaps{std::uint64_t{1} << 26};           ///< Texture::smaller_levels
/// A lit material has Shading::pixel. Such materials add neither lighting nor gouraud to the set.
inline constexpr Effects pixel_shading{std::uint64_t{1} << 32};

/// Scene::csg.
inline constexpr Effects csg{std::uint64_t{1} << 33};
/// Scene::edges: anti-aliases edges only. Needs z16 without sub-ranges and without a visibility method.
inline constexpr Effects edges{std::uint64_t{1} << 34};
inline constexpr Effects overlay{std::uint64_t{1} << 35};  ///< Scene::overlay

// The ways in which triangles get their colours, and the sides that are drawn. The set has every way that some instance
// uses. A renderer with none of them supports all ways that its other effects allow.
inline constexpr Effects shade_flat{std::uint64_t{1} << 45};              ///< one colour for each triangle
inline constexpr Effects shade_gouraud{std::uint64_t{1} << 46};           ///< colours of vertices
inline constexpr Effects shade_textured{std::uint64_t{1} << 47};          ///< texels as they are
inline constexpr Effects shade_textured_flat{std::uint64_t{1} << 48};     ///< texels times one colour
inline constexpr Effects shade_textured_gouraud{std::uint64_t{1} << 49};  ///< texels times colours of vertices
inline constexpr Effects shade_fragments{std::uint64_t{1} << 50};         ///< fragment by fragment
inline constexpr Effects two_sided{std::uint64_t{1} << 51};               ///< some material shows its back faces
inline constexpr Effects shades{std::uint64_t{127} << 45};                ///< all of these

/// Nothing is clipped. Every instance's box must stay between the camera's planes, with some margin, and within a
/// thousand pixels of the picture's centre; begin_frame checks it and returns Error::clipping. A model that rotates in
/// front of the camera can use it. effects_of never returns it.
inline constexpr Effects unclipped{std::uint64_t{1} << 52};

inline constexpr Effects skins{std::uint64_t{1} << 53};  ///< Mesh::skinning

/// The effects of fragments: fill_fragments draws an instance that has one of them.
inline constexpr Effects fragments = fog | alpha_test | blending | texture_alpha | bilinear | dithered_colours |
                                     texture_palettes | mipmaps | pixel_shading;
/// The effects that light a vertex by its place.
inline constexpr Effects local_light = specular | punctual_lights;
/// The effects of light other than ambient and directional light.
inline constexpr Effects vertex_light = local_light | emissive;

// Surfaces and passes other than the triangles of instances: bits 22 to 31 except 24 and 26.
inline constexpr Effects quadrics{1U << 22};  ///< spheres and ellipsoids
/// View::dither of a picture in a format that is_narrow.
inline constexpr Effects dithered_format{1U << 23};
inline constexpr Effects lines{1U << 25};         ///< lines and points
inline constexpr Effects supersampled{1U << 27};  ///< View::samples is not 1
inline constexpr Effects billboards{1U << 28};    ///< Mesh::billboard
inline constexpr Effects environment{1U << 29};   ///< TextureFilter::environment_nearest, environment_bilinear
inline constexpr Effects outlines{1U << 30};      ///< Mesh::outline
inline constexpr Effects shadows{1U << 31};       ///< Scene::shadow, where something is lit
inline constexpr Effects surfaces{quadrics.bits | lines.bits};  ///< all of these

/// All effects that a scene and its picture can need.
inline constexpr Effects of_scenes = without(all, statistics) | depth_state | fragments | vertex_light | surfaces |
                                     billboards | environment | outlines | shadows | csg | edges | overlay | skins |
                                     dithered_format | supersampled;

// The CSG stage draws operands with these; no renderer and no scene has them.
inline constexpr Effects csg_layers{std::uint64_t{1} << 62};   ///< DepthUse::layered
inline constexpr Effects csg_colours{std::uint64_t{1} << 63};  ///< DepthUse::matched
}  // namespace effect
// NOLINTEND(readability-identifier-naming)

/// Returns Error::effect_missing for these effects: the lower 32 bits of the set in `needed`, the upper in `available`.
constexpr Status effects_missing(Effects effects) {
  return {.error = Error::effect_missing,
          .needed = static_cast<std::uint32_t>(effects.bits),
          .available = static_cast<std::uint32_t>(effects.bits >> 32)};
}

/// Returns the effects that an Error::effect_missing names; empty if the renderer is for orthographic cameras only.
constexpr Effects missing_effects(const Status& status) {
  return {std::uint64_t{status.available} << 32 | status.needed};
}

/// Returns the depth format of a renderer with these effects: z16 without any of effect::depth_formats.
constexpr DepthFormat depth_format(Effects effects) {
  if (effects.has(effect::depth_float)) return DepthFormat::float16;
  if (effects.has(effect::depth_24)) return DepthFormat::z24;
  return DepthFormat::z16;
}

/// Returns the effect that selects a format; none for z16.
constexpr Effects depth_effect(DepthFormat format) {
  switch (format) {
    case DepthFormat::float16: return effect::depth_float;
    case DepthFormat::z24: return effect::depth_24;
    case DepthFormat::z16: break;
  }
  return {};
}

/// Returns the number of pixels from one pair of exact texture coordinates to the next, a power of two; 0: only the
/// corners are exact.
constexpr std::int32_t perspective_run(Effects effects) {
  if (effects.has(effect::perspective_affine)) return 0;
  if (effects.has(effect::perspective_8)) return 8;
  return effects.has(effect::perspective_1) ? 1 : 16;
}

/// True if this material needs effect::depth_state.
constexpr bool has_depth_state(const Material& material) {
  return material.depth_test != DepthTest::nearer || !material.depth_write || material.depth_bias != 0 ||
         material.depth_slope_bias != 0;
}

/// Returns the material's finish, or a default one.
constexpr Finish finish_of(const Scene& scene, const Material& material) {
  return material.finish < scene.finishes.size() ? scene.finishes[material.finish] : Finish{};
}

/// True if this material blends: its instances are drawn after all others.
constexpr bool is_blended(const Scene& scene, const Material& material) {
  return finish_of(scene, material).alpha_mode == AlphaMode::blend;
}

/// True if an instance with this mesh and material has an environment map as its texture.
constexpr bool has_environment_map(const Scene& scene, const Mesh& mesh, const Material& material) {
  return is_environment(finish_of(scene, material).filter) && material.texture != kNoTexture && !mesh.normals.empty();
}

/// True if an instance with this mesh and material is lit at its pixels, not at its vertices.
constexpr bool is_lit_by_pixel(const Mesh& mesh, const Material& material) {
  return material.smooth == Shading::pixel && material.lit && !mesh.normals.empty();
}

/// True if the colour adds no light; ignores alpha.
constexpr bool is_black(const Colour& colour) { return colour.r == 0 && colour.g == 0 && colour.b == 0; }

/// Returns the shade of an instance that is not drawn fragment by fragment.
constexpr Effects shade_effect(bool textured, bool lit, bool varies) {
  if (!textured) return varies ? effect::shade_gouraud : effect::shade_flat;
  if (!lit) return effect::shade_textured;
  return varies ? effect::shade_textured_gouraud : effect::shade_textured_flat;
}

/// Returns the effects without effect::shades.
constexpr Effects without_shades(Effects effects) { return without(effects, effect::shades); }

/// Returns the effects of `called_for` that a renderer with `effects` does not have.
constexpr Effects missing_effects(Effects called_for, Effects effects) {
  const Effects missing = without(called_for, effects);
  return effects.any(effect::shades) ? missing : without_shades(missing);
}

/// Returns the effects that an instance's light and fragments need, in addition to those of a material without finish.
constexpr Effects effects_of_finish(const Scene& scene, const Material& material, bool lit, bool textured) {
  Effects found{};
  if (lit && !scene.punctual_lights.empty()) found = found | effect::punctual_lights;
  if (material.finish >= scene.finishes.size()) return found;
  const Finish& finish = scene.finishes[material.finish];
  const bool has_light = !scene.lights.empty() || !scene.punctual_lights.empty();
  if (lit && !is_black(finish.emissive)) found = found | effect::emissive;
  if (lit && has_light && !is_black(finish.specular)) found = found | effect::specular;
  if (finish.alpha_mode == AlphaMode::mask) found = found | effect::alpha_test;
  if (finish.alpha_mode == AlphaMode::blend) found = found | effect::blending;
  if (textured) {
    const Texture texture = material.texture < scene.textures.size() ? scene.textures[material.texture] : Texture{};
    if (has_palette(texture.format)) {
      found = found | effect::texture_palettes;
    } else if (texture.format == TextureFormat::rgb565_alpha && finish.alpha_mode != AlphaMode::opaque) {
      found = found | effect::texture_alpha;
    }
    if (texture.smaller_levels != 0) found = found | effect::mipmaps;
    if (is_bilinear(finish.filter)) found = found | effect::bilinear;
  }
  return found;
}

/// Returns the effects that a picture needs in addition to those of its scene. constexpr.
constexpr Effects effects_of(const View& view) {
  const Effects samples = view.samples == 1 ? Effects{} : effect::supersampled;
  if (dithers_colours(view)) return samples | effect::dithered_colours;
  return view.dither ? samples | effect::dithered_format : samples;
}

/// Returns exactly the effects, with shades, that this scene needs with this camera. constexpr for baked scenes.
/// Not inlined: inside of a caller, GCC makes it larger (0.2 KB of flash).
[[gnu::noinline]] constexpr Effects effects_of(const Scene& scene, const Camera& camera) {
  Effects found{};
  const bool has_tables = !scene.finishes.empty() || !scene.punctual_lights.empty();
  for (const Instance& instance : scene.instances) {
    if (instance.material >= scene.materials.size() || instance.mesh >= scene.meshes.size()) continue;
    const Material& material = scene.materials[instance.material];
    const Mesh& mesh = scene.meshes[instance.mesh];
    const bool lit = material.lit && !mesh.normals.empty();
    const bool mirrors = has_tables && has_environment_map(scene, mesh, material);
    const bool textured = mirrors || (material.texture != kNoTexture && !mesh.texcoords.empty());
    const bool coloured = !mesh.colours.empty() && !(textured && !material.lit);
    const bool by_pixel = is_lit_by_pixel(mesh, material);
    if (lit) found = found | (by_pixel ? effect::pixel_shading : effect::lighting);
    if (coloured) found = found | effect::vertex_colours;
    if (textured) found = found | effect::textures;
    if (mirrors) found = found | effect::environment;
    const bool varies = material.smooth && !by_pixel && (lit || coloured);
    if (varies) found = found | effect::gouraud;
    if (material.double_sided) found = found | effect::two_sided;
    if (has_depth_state(material)) found = found | effect::depth_state;
    if (mesh.billboard != Billboard::none) found = found | effect::billboards;
    if (mesh.skinning != nullptr) found = found | effect::skins;
    // A hull has one colour. It is drawn fragment by fragment if the instance that it outlines is.
    if (outline_of(scene, mesh) != nullptr) found = found | effect::outlines | effect::shade_flat;
    const Effects finish = has_tables ? effects_of_finish(scene, material, lit, textured) : Effects{};
    const bool by_fragment = scene.fog != nullptr || by_pixel || finish.any(effect::fragments);
    found = found | finish | (by_fragment ? effect::shade_fragments : shade_effect(textured, lit, varies));
  }
  if (scene.fog != nullptr && !(scene.instances.empty() && scene.quadrics.empty() && scene.lines.empty())) {
    found = found | effect::fog;
  }
  for (const Quadric& quadric : scene.quadrics) {
    found = found | effect::quadrics;
    if (quadric.material >= scene.materials.size()) continue;
    const Material& material = scene.materials[quadric.material];
    if (material.lit) found = found | effect::lighting;
    if (material.texture != kNoTexture) found = found | effect::textures;
    if (has_depth_state(material)) found = found | effect::depth_state;
  }
  for (const LineSet& lines : scene.lines) {
    found = found | effect::lines;
    if (lines.material >= scene.materials.size()) continue;
    if (has_depth_state(scene.materials[lines.material])) found = found | effect::depth_state;
  }
  if (scene.shadow != nullptr && found.any(effect::lighting | effect::pixel_shading)) found = found | effect::shadows;
  if (!scene.csg.empty()) found = found | effect::csg;
  if (edge_groups(scene) != 0) found = found | effect::edges;
  if (scene.overlay != nullptr) found = found | effect::overlay;
  if (camera.projection == Projection::orthographic) found = found | effect::orthographic;
  return found;
}

}  // namespace zstrip
